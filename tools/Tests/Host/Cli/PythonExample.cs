using System;
using System.Diagnostics;
using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>The Python example of a page of the documentation.</summary>
internal static class PythonExample
{
    /// <summary>Runs it in a folder, and returns what it prints. It must succeed.</summary>
    public static string Run(string page, string python, string folder)
    {
        string text = File.ReadAllText(Path.Combine(Project.FindRoot(AppContext.BaseDirectory),
            "Packages/com.glint.radar/Documentation~", page));
        return RunText(Regex.Match(text, "```python\n(.*?)```", RegexOptions.Singleline).Groups[1].Value, python, folder);
    }

    /// <summary>The same of a program.</summary>
    public static string RunText(string program, string python, string folder)
    {
        string file = Path.Combine(folder, "example.py");
        File.WriteAllText(file, program);
        using var process = Process.Start(new ProcessStartInfo(python, [file])
        {
            WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true
        });
        string output = process.StandardOutput.ReadToEnd(), error = process.StandardError.ReadToEnd();
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.Zero, error);
        return output;
    }
}
