using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Locks a results folder for one run: creates the folder and holds a lock file in it.
    /// The system releases the lock with the process; the file of a killed run locks nothing.
    /// </summary>
    sealed class FolderLock : IDisposable
    {
        const string FileName = "results.lock";
        const string Remedy = "choose another results folder";

        readonly List<string> _made;
        readonly FileStream _file;

        /// <exception cref="GlintException">Another run has the folder, or it cannot be made or written.</exception>
        public FolderLock(string path)
        {
            RefuseFileOnTheWay(path);
            _made = MissingFolders(path);
            try
            {
                _file = Take(path);
                // A full disk may still have room for an empty file.
                _file.WriteByte((byte)'\n');
            }
            catch (Exception error)
            {
                Dispose();
                throw error is GlintException ? error : new GlintException(
                    $"{path}: cannot be written as a results folder: {Reason(path, error)}; {Remedy}", error);
            }
        }

        /// <summary>Releases the folder, and removes it if nothing was written into it.</summary>
        public void Dispose()
        {
            _file?.Dispose();
            RemoveMadeFolders();
        }

        static FileStream Take(string path)
        {
            Directory.CreateDirectory(path);
            string file = Path.Combine(path, FileName);
            try
            {
                // A separate file: only FileShare.None locks against processes on every system,
                // and results.csv must stay open to readers.
                return new FileStream(file, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, 1,
                    FileOptions.DeleteOnClose);
            }
            catch (IOException error) when (File.Exists(file))
            {
                throw new GlintException(
                    $"{path}: another run is writing its results there; wait for its end or {Remedy}", error);
            }
        }

        static string Reason(string path, Exception error)
        {
            if (Directory.Exists(Path.Combine(path, FileName)))
                return $"{FileName} in it is a folder";
            switch (error)
            {
                case UnauthorizedAccessException _: return $"{NearestFolder(path)} may not be written";
                case DirectoryNotFoundException _:
                case FileNotFoundException _: return $"{NearestFolder(path)} takes no folders";
                case PathTooLongException _: return "the name is too long";
                default: return error.Message.TrimEnd('.');
            }
        }

        static void RefuseFileOnTheWay(string path)
        {
            var file = Ancestry(path).FirstOrDefault(folder => File.Exists(folder.FullName));
            if (file != null)
                throw new GlintException(
                    $"{(file.FullName == Path.GetFullPath(path) ? path : $"{path}: {file.FullName}")} is a file, "
                    + $"not a folder: {Remedy}");
        }

        static string NearestFolder(string path) => Ancestry(path).First(folder => folder.Exists).FullName;

        // Deepest first.
        static List<string> MissingFolders(string path) =>
            Ancestry(path).TakeWhile(folder => !folder.Exists).Select(folder => folder.FullName).ToList();

        static IEnumerable<DirectoryInfo> Ancestry(string path)
        {
            for (var folder = new DirectoryInfo(Path.GetFullPath(path)); folder != null; folder = folder.Parent)
                yield return folder;
        }

        void RemoveMadeFolders()
        {
            try
            {
                foreach (string folder in _made)
                    if (Directory.Exists(folder) && !Directory.EnumerateFileSystemEntries(folder).Any())
                        Directory.Delete(folder);
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException)
            {
                // Another process uses it now.
            }
        }
    }
}
