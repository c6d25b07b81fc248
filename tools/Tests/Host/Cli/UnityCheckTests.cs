using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>tools/unity-check, with unity-stub in Unity's place.</summary>
[Platform("Linux")]
public sealed class UnityCheckTests
{
    static readonly string s_root = Project.FindRoot(AppContext.BaseDirectory),
        s_stub = Path.Combine(s_root, "tools/Tests/Host/Cli/unity-stub");

    string _folder;

    [SetUp]
    public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("glint unity-check ").FullName;

    [TearDown]
    public void DeleteFolder() => Directory.Delete(_folder, true);

    [Test]
    public void Check_AllPasses_CallsUnityForEachStepAndWritesTheLog()
    {
        var (code, output, _) = Check("", s_stub, _folder);

        Assert.That(code, Is.Zero, output);
        Assert.That(output, Does.EndWith("5 passed, 0 failed\n"));
        Assert.That(File.ReadAllText(Path.Combine(_folder, "unity-check.log")), Is.EqualTo(output));
        foreach (string line in new[]
        {
            "Unity Editor version:    6000.0.78f1", "Vulkan renderer=[Stub GPU]", "rows: 46 of 46", "worst row:",
            "exit code 0 after", _folder
        })
            Assert.That(output, Does.Contain(line));
        Assert.That(output, Does.Not.Contain("made for Unity"));

        var calls = Calls();
        Assert.That(calls, Has.Length.EqualTo(4));
        Assert.That(calls, Has.All.Contains("-batchmode").And.All.Contains("-projectPath").And.All.Contains(s_root)
            .And.All.Contains("-logFile"));
        Assert.That(calls.Select(call => call.Contains("-nographics")), Has.All.False, "the kernels need a device");
        Assert.That(calls.Select(call => call.Contains("-quit")), Is.EqualTo(new[] { true, false, false, false }),
            "with -runTests Unity would leave before the tests have run");
        foreach (var (call, platform) in new[] { (calls[1], "EditMode"), (calls[2], "PlayMode") })
            Assert.That(call, Is.SupersetOf(new[]
            {
                "-runTests", "-testPlatform", platform, "-testResults", Path.Combine(_folder, platform + ".xml"),
                "-forgetProjectPath"
            }));
        Assert.That(calls[3].SkipWhile(word => word != "-executeMethod"), Is.EqualTo(new[]
        {
            "-executeMethod", "Glint.Editor.Batch.Sweep", "--glint", "Scenes/CornerReflector.unity", "--target",
            "Corner Reflector", "--angles", "0:45:1", "--out", Path.Combine(_folder, "sweep")
        }));
    }

    [TestCase("licence", "import: exit code 198", "Unity has no licence: start Unity Hub")]
    [TestCase("extended", "import: exit code 198", "needs a licence of Unity Industry or Enterprise")]
    [TestCase("open", "import: exit code 1", "Unity has the project open: close it")]
    [TestCase("compile", "import: exit code 1", "GlintVersion.cs(3,1): error CS0246")]
    [TestCase("silent", "import: exit code 139", "Unity wrote no log")]
    public void Check_UnityCannotOpenTheProject_SaysTheWayOutAndLeavesTheRest(string stub, string step, string wayOut)
    {
        var (code, output, _) = Check(stub, s_stub, _folder);

        Assert.That(code, Is.EqualTo(1));
        Assert.That(output, Does.Contain("FAILED: " + step).And.Contain(wayOut));
        Assert.That(output, Does.Contain("FAILED: EditMode, PlayMode, sweep, table: not run"));
        Assert.That(output, Does.EndWith("0 passed, 2 failed\n"));
        Assert.That(Calls(), Has.Length.EqualTo(1));
    }

    [TestCase("failing", 4, "FAILED: PlayMode: 1 of 2 tests did not pass\n  Failed: Glint.Tests.B(\"y\")\n"
        + "        Expected: less than 1\n        But was:  2 & more\n")]
    [TestCase("error", 3, "FAILED: EditMode: no test results; exit code 3\n")]
    [TestCase("empty", 3, "FAILED: EditMode: no test ran; com.glint.tests must be among the testables")]
    [TestCase("sweep", 3, "FAILED: sweep: exit code 1\n", "FAILED: table: the sweep wrote no results.csv\n")]
    [TestCase("table", 4, "worst row:\n  7 deg: hits 216078 (table 215978)", "FAILED: table: results.csv differs")]
    [TestCase("rows", 4, "rows: 45 of 46, outside the tolerance: 0\n")]
    public void Check_AStepFails_IsToldAndCounted(string stub, int passed, params string[] told)
    {
        var (code, output, _) = Check(stub, s_stub, _folder);

        Assert.That(code, Is.EqualTo(1));
        foreach (string each in told)
            Assert.That(output, Does.Contain(each));
        Assert.That(output, Does.EndWith($"{passed} passed, {5 - passed} failed\n"));
    }

    [Test]
    public void Check_UnityLogsALeak_ShowsTheLine() =>
        Assert.That(Check("leak", s_stub, _folder).output,
            Does.Contain("lines of the log:\n  GarbageCollector disposing of GraphicsBuffer."));

    [Test]
    public void Check_ResultsOfAnEarlierRun_AreNotTakenForNewOnes()
    {
        Check("", s_stub, _folder);

        Assert.That(Check("sweep", s_stub, _folder).output, Does.Contain("the sweep wrote no results.csv"));
        Assert.That(Check("error", s_stub, _folder).output, Does.Contain("EditMode: no test results"));
    }

    [Test]
    public void Check_AppOfMacOS_StartsTheProgramInIt()
    {
        string app = Path.Combine(_folder, "Unity.app");
        Directory.CreateDirectory(Path.Combine(app, "Contents/MacOS"));
        File.CreateSymbolicLink(Path.Combine(app, "Contents/MacOS/Unity"), s_stub);

        Assert.That(Check("", app, _folder).code, Is.Zero);
    }

    [TestCase("give the path of Unity")]
    [TestCase("/no/Unity: no such program; Unity Hub shows where", "/no/Unity")]
    [TestCase("/tmp: is no program; give .../Editor/Unity (Linux)", "/tmp")]
    [TestCase("/dev/null/x: cannot be created: choose another folder", "/bin/true", "/dev/null/x")]
    [TestCase("give the path of Unity", "a", "b", "c")]
    public void Call_Wrong_IsRefused(string message, params string[] arguments)
    {
        var (code, output, error) = Check("", arguments);

        Assert.That(code, Is.EqualTo(2));
        Assert.That(error, Does.StartWith("unity-check: " + message));
        Assert.That(output, Is.Empty);
    }

    string[][] Calls() => File.ReadLines(Path.Combine(_folder, "calls")).Select(line => line.Split('\t')).ToArray();

    (int code, string output, string error) Check(string stub, params string[] arguments)
    {
        var start = new ProcessStartInfo(Path.Combine(s_root, "tools/unity-check"), arguments)
        {
            RedirectStandardOutput = true, RedirectStandardError = true
        };
        start.Environment["STUB"] = stub;
        start.Environment["STUB_CALLS"] = Path.Combine(_folder, "calls");
        using var script = Process.Start(start);
        var error = script.StandardError.ReadToEndAsync();
        string output = script.StandardOutput.ReadToEnd();
        script.WaitForExit();
        return (script.ExitCode, output, error.Result);
    }
}
