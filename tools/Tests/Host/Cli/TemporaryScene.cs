using System;
using System.IO;

namespace Glint.Host.Tests;

/// <summary>A scene of a test, in the project, where a scene must be; deleted at its end.</summary>
sealed class TemporaryScene : IDisposable
{
    public TemporaryScene(string text)
    {
        Path = System.IO.Path.Combine(Project.FindRoot(AppContext.BaseDirectory), "Scenes",
            System.IO.Path.GetRandomFileName() + ".unity");
        File.WriteAllText(Path, text);
    }

    public string Path { get; }

    public void Dispose() => File.Delete(Path);
}
