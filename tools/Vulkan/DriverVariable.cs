using System;
using System.IO;
using System.Linq;

namespace Glint.Vulkan;

/// <summary>The environment variables that select Vulkan drivers in place of the installed ones.</summary>
static class DriverVariable
{
    // The loader ignores the second if the first is set.
    static readonly string[] Names = ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"];

    /// <summary>The reason for a missing device if a variable explains it; null if none is set.</summary>
    internal static string Blame(Func<string, string> environment)
    {
        string name = Array.Find(Names, candidate => !string.IsNullOrEmpty(environment(candidate)));
        if (name == null)
            return null;
        string value = environment(name);
        bool isThere = value.Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries).Any(Path.Exists);
        return $"no Vulkan device: {name} is set to {value}, "
            + $"{(isThere ? "whose driver gives none" : "which is not there")}; unset it to use the installed drivers";
    }
}
