using System;
using System.IO;

namespace Glint.Tests
{
    /// <summary>A folder of its own in the system's temporary folder, gone at the end with all that is in it.</summary>
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
