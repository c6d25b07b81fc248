using System;
using System.IO;

namespace Glint.Tests
{
    /// <summary>A new folder in the system's temporary folder; Dispose deletes it with its content.</summary>
    sealed class TemporaryFolder : IDisposable
    {
        public TemporaryFolder()
        {
            Path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "glint-tests-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Path);
        }

        public string Path { get; }

        public string PathOf(string name) => System.IO.Path.Combine(Path, name);

        public string Write(string name, byte[] content)
        {
            string path = PathOf(name);
            File.WriteAllBytes(path, content);
            return path;
        }

        public void Dispose() => Directory.Delete(Path, true);
    }
}
