using System;
using System.IO;
using Glint.Core;

namespace Glint.Cli;

/// <summary>Finds the Unity project that a command works in.</summary>
static class ProjectFolder
{
    /// <summary>The project of the input when that is a file on disk, else of the current directory, else the one this program was built in.</summary>
    /// <exception cref="GlintException">There is none.</exception>
    public static string For(string input)
    {
        string beside = Path.GetDirectoryName(Path.GetFullPath(input));
        return (File.Exists(input) ? ProjectPaths.FindRoot(beside) : null)
            ?? ProjectPaths.FindRoot(Environment.CurrentDirectory)
            ?? ProjectPaths.FindRoot(AppContext.BaseDirectory)
            ?? throw new GlintException($"no Unity project: neither {beside} nor {Environment.CurrentDirectory} is in one: change to the folder that holds Assets and Packages");
    }
}
