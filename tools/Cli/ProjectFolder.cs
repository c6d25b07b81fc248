using System;
using System.IO;
using Glint.Core;

namespace Glint.Cli;

/// <summary>Finds the Unity project that a command works in.</summary>
static class ProjectFolder
{
    /// <summary>The project of the input when that is a file on disk, else <see cref="Current"/>.</summary>
    /// <exception cref="GlintException">There is none.</exception>
    public static string For(string input)
    {
        string own = File.Exists(input) ? ProjectPaths.FindRoot(Path.GetDirectoryName(Path.GetFullPath(input))) : null;
        return own ?? Current ?? throw new GlintException(
            $"no Unity project: {Environment.CurrentDirectory} is not in one: "
            + "change to the folder that holds Assets and Packages");
    }

    /// <summary>
    /// The project of the current directory, else the one this program was built in; null when there is neither.
    /// </summary>
    public static string Current =>
        ProjectPaths.FindRoot(Environment.CurrentDirectory) ?? ProjectPaths.FindRoot(AppContext.BaseDirectory);
}
