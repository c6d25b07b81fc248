using System.IO;
using System.Runtime.CompilerServices;

namespace Glint.Tests.Mono;

static class ProjectFolder
{
    public static string FullPath => Path.GetFullPath(Path.Combine(Path.GetDirectoryName(ThisFile()), "../../.."));

    static string ThisFile([CallerFilePath] string file = null) => file;
}
