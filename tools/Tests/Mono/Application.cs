using System.IO;
using Glint.Tests.Mono;

namespace UnityEngine;

/// <summary>All that the engine-free tests use of the engine.</summary>
static class Application
{
    public static string dataPath => Path.Combine(ProjectFolder.FullPath, "Assets");
}
