using System;
using System.IO;
using System.Linq;

namespace Glint.Vulkan;

/// <summary>
/// The environment variables that tell the Vulkan loader which drivers to take, in place of those installed.
/// </summary>
static class DriverVariable
{
    // The loader does not look at the second when the first is set.
    static readonly string[] Names = ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"];

    /// <summary>Why there is no device, where a variable explains it; null where none is set.</summary>
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
