using System.IO;
using System.Runtime.CompilerServices;

namespace Glint.Host.Tests.Vulkan;

static class Sources
{
    /// <summary>The project that these tests were built from.</summary>
    internal static string Root => Path.GetFullPath(Path.Combine(Path.GetDirectoryName(File()), "../../../.."));

    static string File([CallerFilePath] string path = null) => path;
}
