using System;
using System.Diagnostics;
using System.IO;
using System.Threading;

namespace Glint.Host.Tests;

/// <summary>The command line program in a process of its own, as a user runs it.</summary>
static class GlintProcess
{
    /// <summary>Path of the program, for dotnet.</summary>
    public static readonly string Program = Path.Combine(AppContext.BaseDirectory, "glint-cli.dll");

    /// <summary>The program with these arguments, whose output and errors are read.</summary>
    public static ProcessStartInfo Of(params string[] arguments) => new("dotnet", [Program, .. arguments])
    {
        RedirectStandardOutput = true, RedirectStandardError = true
    };

    /// <summary>Runs a program to its end.</summary>
    public static (int Code, string Output, string Error) Run(ProcessStartInfo start)
    {
        using var process = Process.Start(start);
        var error = process.StandardError.ReadToEndAsync();
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return (process.ExitCode, output, error.Result);
    }

    /// <summary>Runs the program until a file has so many bytes, and kills it.</summary>
    public static void KillAt(string file, int bytes, params string[] arguments)
    {
        using var process = Process.Start(Of(arguments));
        process.OutputDataReceived += (_, _) => { };
        process.ErrorDataReceived += (_, _) => { };
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        while (!process.HasExited && !(File.Exists(file) && new FileInfo(file).Length >= bytes))
            Thread.Sleep(1);
        process.Kill(); // SIGKILL
        process.WaitForExit();
    }
}
