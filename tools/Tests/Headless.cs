using System;
using System.IO;
using System.Runtime.CompilerServices;
using Glint.Host;
using NUnit.Framework;

// Tests that Unity's runner runs too get its set-ups and its rules on logging; the host's own tests are plain NUnit.
#if UNITY_INCLUDE_TESTS
[assembly: UnityTestAction]
#endif

/// <summary>
/// Compiled into every test assembly, so that the tests need not know where they run:
/// opens the project that this file belongs to, in play mode for an assembly named so, with an empty scene.
/// </summary>
[SetUpFixture]
public sealed class Headless
{
    [OneTimeSetUp]
    public void Open()
    {
        // With the test's own output, which is shown for those that fail.
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
