using System;
using System.IO;
using System.Runtime.CompilerServices;
using Glint.Host;
using NUnit.Framework;

// Tests that also run in Unity's test runner get its set-ups and log rules; the host's own tests are plain NUnit.
#if UNITY_INCLUDE_TESTS
[assembly: UnityTestAction]
#endif

/// <summary>
/// Compiled into every test assembly, so that tests are independent of the host. Opens this file's project with an
/// empty scene, in play mode for the play-mode assembly.
/// </summary>
[SetUpFixture]
public sealed class Headless
{
    [OneTimeSetUp]
    public void Open()
    {
        // Log messages go to the test's output, which is shown for failed tests.
        LogSink.Writer = (type, message) => Console.Out.WriteLine($"[{type}] {message}");
        Project.Open(Path.GetFullPath(Path.Combine(ThisFolder(), "..", "..")));
        if (typeof(Headless).Assembly.GetName().Name.EndsWith(".PlayMode"))
            Engine.EnterPlayMode();
    }

    [OneTimeTearDown]
    public void Close()
    {
        if (Engine.IsPlaying)
            Engine.ExitPlayMode();
    }

    static string ThisFolder([CallerFilePath] string file = null) => Path.GetDirectoryName(file);
}
