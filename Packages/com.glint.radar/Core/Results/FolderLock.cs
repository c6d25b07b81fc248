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

        // errno EAGAIN of .NET on Linux; ERROR_LOCK_VIOLATION of Mono and Windows.
        const int TryAgain = 11;
        const int LockViolation = 33;

        // Lock files of this process. Unix drops the byte locks that a process has on a file when the process closes
        // any handle to it, so a second attempt must not open the file.
        static readonly HashSet<string> s_held = new HashSet<string>();

        readonly List<string> _made;
        readonly string _name;
        readonly FileStream _file;
        bool _released;

        /// <summary>Whether the file is in a folder, held or not.</summary>
        public static bool IsIn(string folder) => File.Exists(Path.Combine(folder, FileName));

        /// <exception cref="GlintException">Another run has the folder, or it cannot be made or written.</exception>
        public FolderLock(string path)
        {
            RefuseFileOnTheWay(path);
            _made = MissingFolders(path);
            _name = Path.GetFullPath(Path.Combine(path, FileName));
            lock (s_held)
                if (!s_held.Add(_name))
                    throw Held(path, null);
            try
            {
                _file = Take(path);
                // A full disk may still have room for an empty file. Mono keeps a byte until it is flushed.
                _file.WriteByte((byte)'\n');
                _file.Flush();
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
            if (_released)
                return;
            _released = true;
            if (_file != null)
                DeleteFile();
            RemoveMadeFolders();
            lock (s_held)
                s_held.Remove(_name);
        }

        static FileStream Take(string path)
        {
            Directory.CreateDirectory(path);
            string name = Path.Combine(path, FileName);
            while (true)
            {
                var file = OpenFile(path, name);
                if (!TryLock(file))
                {
                    file.Dispose();
                    throw Held(path, null);
                }
                // On Unix its last holder may have deleted it between opening and locking: it then locks nothing.
                if (File.Exists(name))
                    return file;
                file.Dispose();
            }
        }

        static FileStream OpenFile(string path, string name)
        {
            try
            {
                // A separate file, since results.csv must stay open to readers. FileShare.None excludes other
                // processes on Windows, and on Unix those of .NET (flock), but not those of Mono.
                return new FileStream(name, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, 1);
            }
            catch (IOException error) when (File.Exists(name))
            {
                throw Held(path, error);
            }
        }

        // On Unix a lock by fcntl, which both .NET and Mono see.
        static bool TryLock(FileStream file)
        {
            try
            {
#pragma warning disable CA1416 // Not on macOS: caught below.
                file.Lock(0, 1);
#pragma warning restore CA1416
                return true;
            }
            catch (PlatformNotSupportedException)
            {
                // .NET on macOS, where flock and fcntl exclude each other.
                return true;
            }
            catch (IOException error)
            {
                // Other errors: the file system has no byte locks, as some of clusters.
                int code = error.HResult & 0xffff;
                return code != TryAgain && code != LockViolation;
            }
        }

        static GlintException Held(string path, Exception error) => new GlintException(
            $"{path}: another run is writing its results there; wait for its end or {Remedy}", error);

        // Before closing, so that no file is deleted that another process has locked; Windows refuses to delete an
        // open file.
        void DeleteFile()
        {
            bool deleted = TryDelete(_name);
            _file.Dispose();
            if (!deleted)
                TryDelete(_name);
        }

        static bool TryDelete(string file)
        {
            try
            {
                File.Delete(file);
                return true;
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException)
            {
                return false;
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
