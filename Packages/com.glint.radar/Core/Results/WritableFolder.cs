using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Glint.Core
{
    /// <summary>Finds out whether a folder can be made and written, by doing so and taking it back.</summary>
    static class WritableFolder
    {
        /// <exception cref="IOException">It cannot.</exception>
        /// <exception cref="UnauthorizedAccessException">It may not.</exception>
        public static void Check(string path)
        {
            var missing = MissingFolders(path);
            try
            {
                Directory.CreateDirectory(path);
                Probe(Path.Combine(path, ".glint-" + Guid.NewGuid().ToString("N")));
            }
            finally
            {
                foreach (string folder in missing)
                    if (Directory.Exists(folder) && !Directory.EnumerateFileSystemEntries(folder).Any())
                        Directory.Delete(folder);
            }
        }

        static void Probe(string file)
        {
            try
            {
                File.WriteAllBytes(file, new byte[1]);
            }
            finally
            {
                File.Delete(file);
            }
        }

        // Deepest first.
        static List<string> MissingFolders(string path)
        {
            var missing = new List<string>();
            for (var folder = new DirectoryInfo(Path.GetFullPath(path)); folder != null && !folder.Exists; folder = folder.Parent)
                missing.Add(folder.FullName);
            return missing;
        }
    }
}
