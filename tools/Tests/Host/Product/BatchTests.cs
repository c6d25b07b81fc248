using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host.Tests;

/// <summary>
/// The methods for Unity's -executeMethod, called with Unity's command line: their files, log and exit code.
/// </summary>
public sealed class BatchTests
{
    readonly List<(LogType type, string text)> _log = new();
    string _folder;
    int? _exitCode;

    [SetUp]
    public void Listen()
    {
        _folder = Directory.CreateTempSubdirectory("glint-batch-").FullName;
        _exitCode = null;
        _log.Clear();
        EditorHooks.Exit = code => _exitCode = code;
        Application.logMessageReceived += Hear;
    }

    [TearDown]
    public void Restore()
    {
        Application.logMessageReceived -= Hear;
        EditorHooks.Exit = System.Environment.Exit;
        GraphicsDevice.Type = GraphicsDeviceType.Vulkan;
        Directory.Delete(_folder, true);
    }

    [Test]
    public void Sweep_OfTheCornerReflector_WritesTheFilesAndEndsUnityWithZero()
    {
        string results = Path.Combine(_folder, "results");
        Call(Commands.Sweep, "Scenes/CornerReflector.unity", "--target", "Corner Reflector", "--angles", "0,45",
            "--size", "192x108", "--out", results);

        Assert.That(_exitCode, Is.EqualTo(0), string.Join("\n", _log));
        Assert.That(File.ReadAllLines(Path.Combine(results, "results.csv")).Skip(1).Select(line => line.Split(',')[0]),
            Is.EqualTo(new[] { "0", "45" }));
        Assert.That(File.Exists(Path.Combine(results, "results.json")));
        Assert.That(_log.Select(line => line.text), Has.Some.Contains("2 of 2"));
    }

    [Test]
    public void Sweep_CancelledAfterAPose_KeepsItsRow()
    {
        string results = Path.Combine(_folder, "results");
        string[] sweep = { "Scenes/CornerReflector.unity", "--target", "Corner Reflector", "--angles", "0,10,20", "--size",
            "64x36", "--out", results };
        var progress = new CancelAfterAPose();

        Assert.That(Batch.Execute(CommandLine.Parse(Commands.Sweep, sweep), progress), Is.EqualTo(130));
        Assert.That(progress.Part, Is.EqualTo(1), "told how much of the pose is done");
        Assert.That(File.ReadAllLines(Path.Combine(results, "results.csv")).Skip(1).Select(row => row.Split(',')[0]),
            Is.EqualTo(new[] { "0" }));
        Assert.That(File.Exists(Path.Combine(results, "results.json")), Is.False);

        Batch.Execute(CommandLine.Parse(Commands.Sweep, sweep.Append("--resume").ToArray()), progress);
        Assert.That(progress.Before, Is.EqualTo(1), "poses done before take no time");
    }

    [Test]
    public void Sweep_OfARowAtAnotherAngle_IsNotResumed()
    {
        string[] sweep = { "Scenes/CornerReflector.unity", "--target", "Corner Reflector", "--angles", "0,10,20", "--size",
            "64x36", "--out", _folder };
        Batch.Execute(CommandLine.Parse(Commands.Sweep, sweep), new CancelAfterAPose());
        string partial = Path.Combine(_folder, "results.partial");
        File.WriteAllText(partial, File.ReadAllText(partial).Replace("\"angle_deg\":0,", "\"angle_deg\":5,"));
        File.Delete(Path.Combine(_folder, "results.csv"));
        Call(Commands.Sweep, sweep.Append("--resume").ToArray());
        Assert.That(_exitCode, Is.EqualTo(1));
        Assert.That(Errors.Single(), Does.EndWith($"{partial}: row 1 is of 5 deg instead of 0 deg: it was changed; restore it, "
            + "or leave --resume out"));
    }

    [Test]
    public void Merge_WarnsOfUndersampledPosesAsASweepDoes()
    {
        string At(string name) => Path.Combine(_folder, name);
        string[] Sweep(string name) => new[] { "Scenes/CornerReflector.unity", "--target", "Corner Reflector", "--angles",
            "0,10", "--size", "64x36", "--out", At(name) };
        Call(Commands.Sweep, Sweep("whole"));
        for (int number = 1; number <= 2; number++)
            Call(Commands.Sweep, Sweep($"{number}").Concat(new[] { "--shard", $"{number}/2" }).ToArray());
        string whole = _log.First(line => line.type == LogType.Warning).text;
        Assert.That(whole, Does.Contain(" in 2 of 2 poses (column undersampled)"));
        _log.Clear();
        Call(Commands.Merge, At("1"), At("2"), "--out", At("merged"));
        Assert.That(_log.Single(line => line.type == LogType.Warning).text, Is.EqualTo(whole));
    }

    [Test]
    public void Sweep_WithoutSamplingError_LeavesItEmptyAndIsNotMixedWithAnother()
    {
        string[] sweep = { "Scenes/CornerReflector.unity", "--target", "Corner Reflector", "--angles", "0,10",
            "--size", "192x108", "--out", _folder };
        Call(Commands.Sweep, sweep.Append("--no-sampling-error").ToArray());
        Assert.That(_exitCode, Is.EqualTo(0), string.Join("\n", _log));
        var lines = File.ReadAllLines(Path.Combine(_folder, "results.csv")).Select(line => line.Split(',')).ToArray();
        var json = JObject.Parse(File.ReadAllText(Path.Combine(_folder, "results.json")));
        foreach (string column in new[] { "sampling_error", "largest_path_step_wavelengths", "undersampled" })
        {
            Assert.That(lines[1][System.Array.IndexOf(lines[0], column)], Is.Empty);
            Assert.That(json["rows"][0][column].Type, Is.EqualTo(JTokenType.Null));
        }
        Assert.That((string)json["settings"]["sampling_error"], Is.EqualTo("not estimated"));
        Assert.That(_log.Where(line => line.type == LogType.Warning), Is.Empty, "nothing is known to be undersampled");

        Call(Commands.Sweep, sweep.Append("--resume").ToArray());
        Assert.That(Errors.Single(), Does.Contain("sampling_error was \"not estimated\" and is not given"));
    }

    [Test]
    public void Run_ByAssetPath_FindsTheSameScene()
    {
        Call(Commands.Run, "Packages/com.glint.scenes/CornerReflector.unity", "--size", "64x36");
        Assert.That(_exitCode, Is.EqualTo(0), string.Join("\n", _log));
    }

    [Test]
    public void Sweep_WithoutGraphicsDevice_SaysToLeaveOutNographicsAndWritesNothing()
    {
        GraphicsDevice.Type = GraphicsDeviceType.Null;
        string results = Path.Combine(_folder, "results");
        Call(Commands.Sweep, "Scenes/CornerReflector.unity", "--target", "Corner Reflector",
            "--angles", "0,45", "--out", results);

        Assert.That(_exitCode, Is.EqualTo(1));
        Assert.That(Errors.Single(), Does.Contain("start Unity without -nographics"));
        Assert.That(Directory.Exists(results), Is.False);
    }

    [Test]
    public void Log_OfACommand_HasStackTracesOfErrorsOnly()
    {
        Application.SetStackTraceLogType(LogType.Log, StackTraceLogType.ScriptOnly);
        Call(Commands.Sweep);
        Assert.That(Application.GetStackTraceLogType(LogType.Log), Is.EqualTo(StackTraceLogType.None));
        Assert.That(Application.GetStackTraceLogType(LogType.Error), Is.EqualTo(StackTraceLogType.ScriptOnly));
        Assert.That(Application.GetStackTraceLogType(LogType.Exception), Is.EqualTo(StackTraceLogType.ScriptOnly));
    }

    [Test]
    public void Sweep_WithABadOption_EndsUnityWithTwo()
    {
        Call(Commands.Sweep, "Scenes/CornerReflector.unity", "--target", "Corner Reflector", "--angles", "0:45");
        Assert.That(_exitCode, Is.EqualTo(2));
        Assert.That(Errors.Single(), Does.Contain("--angles 0:45"));
    }

    [Test]
    public void Sweep_WithDevice_PointsToUnitysOwnOption()
    {
        Call(Commands.Sweep, "Scenes/CornerReflector.unity", "--target", "Corner Reflector",
            "--angles", "0", "--device", "1");
        Assert.That(_exitCode, Is.EqualTo(2));
        Assert.That(Errors.Single(), Does.Contain("-force-device-index"));
    }

    [Test]
    public void Sweep_WithoutTheMarker_SaysWhereTheArgumentsGo()
    {
        Batch.ExecuteAndExit(Commands.Sweep, new[] { "Unity", "-batchmode", "Scenes/CornerReflector.unity" });
        Assert.That(_exitCode, Is.EqualTo(2));
        Assert.That(Errors.Single(), Does.Contain("--glint is missing"));
    }

    sealed class CancelAfterAPose : IProgressSink
    {
        readonly CancellationTokenSource _source = new();

        public double Part { get; private set; }

        public CancellationToken Cancel => _source.Token;

        public int Before { get; private set; }

        public void Start(string what, int total, int done = 0) => Before = done;

        public void Report(double value) => Part = value;

        public void Advance(int done, string note) => _source.Cancel();

        public void Finish() { }

        public void Print(string line) { }
    }

    IEnumerable<string> Errors =>
        _log.Where(line => line.type is LogType.Error or LogType.Exception).Select(line => line.text);

    static void Call(Command command, params string[] arguments) =>
        Batch.ExecuteAndExit(command, new[]
        {
            "Unity", "-batchmode", "-executeMethod", command.UnityMethod ?? "", "--glint"
        }.Concat(arguments).ToArray());

    void Hear(string text, string stack, LogType type) => _log.Add((type, text));
}
