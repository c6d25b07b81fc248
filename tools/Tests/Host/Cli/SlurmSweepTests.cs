using System;
using System.Diagnostics;
using System.IO;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// The device that tools/slurm-sweep chooses in a task, with echo in place of glint. tools/stress runs the script
/// under Slurm.
/// </summary>
[Platform("Linux")]
public sealed class SlurmSweepTests
{
    static readonly string[] s_variables =
        ["GLINT_DEVICE", "GLINT_PARTS", "CUDA_VISIBLE_DEVICES", "SLURM_STEP_GPUS", "SLURM_JOB_GPUS"];

    [TestCase("", "")]
    [TestCase("", "--device 3", "SLURM_JOB_GPUS=3,4")]
    [TestCase("", "--device 5", "SLURM_JOB_GPUS=3", "SLURM_STEP_GPUS=5")]
    [TestCase("", "--device 0", "SLURM_JOB_GPUS=3", "CUDA_VISIBLE_DEVICES=0")]
    [TestCase("", "--device 3", "SLURM_JOB_GPUS=3", "CUDA_VISIBLE_DEVICES=GPU-1a2b")]
    [TestCase("", "", "CUDA_VISIBLE_DEVICES=NoDevFiles")]
    [TestCase("", "--device H200", "SLURM_JOB_GPUS=3", "GLINT_DEVICE=H200")]
    [TestCase("--device=llvm", "", "SLURM_JOB_GPUS=3")]
    [TestCase("--device llvm", "", "SLURM_JOB_GPUS=3")]
    public void Device_IsTheOneSetOrTheOneThatSlurmGave(string given, string chosen, params string[] environment)
    {
        string words = $"in.unity {given}".Trim();
        var start = new ProcessStartInfo(Path.Combine(Project.FindRoot(AppContext.BaseDirectory), "tools/slurm-sweep"),
            ["dir", .. words.Split(' ')])
        { RedirectStandardOutput = true };
        foreach (string name in s_variables)
            start.Environment.Remove(name);
        foreach (string setting in new[]
        {
            "GLINT=/bin/echo", "SLURM_ARRAY_TASK_ID=2", "SLURM_ARRAY_TASK_MIN=1", "SLURM_ARRAY_TASK_MAX=8",
            "SLURM_ARRAY_TASK_COUNT=8"
        })
            Set(start, setting);
        foreach (string setting in environment)
            Set(start, setting);
        using var script = Process.Start(start);
        string output = script.StandardOutput.ReadToEnd();
        script.WaitForExit();
        Assert.That(output.Trim(),
            Is.EqualTo($"sweep {words} {(chosen == "" ? "" : chosen + " ")}--shard 2/8 --out dir/part-2 --resume"));
    }

    static void Set(ProcessStartInfo start, string setting) =>
        start.Environment[setting.Split('=')[0]] = setting.Split('=')[1];
}
