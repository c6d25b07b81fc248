using System;
using System.IO;

namespace Glint.Core
{
    /// <summary>
    /// A file that is written beside its place, with .tmp after its name, and moved there when it is complete. A file
    /// that is there stays until then.
    /// A link is written through, and what has no length, as a device or a pipe, is written itself: a move would take
    /// its place.
    /// </summary>
    public sealed class FileDraft : IDisposable
    {
        readonly string _path, _written;

        /// <summary>Makes the draft, in a folder that exists.</summary>
        /// <exception cref="IOException">The file or the draft cannot be written, or another draft is open.</exception>
        /// <exception cref="UnauthorizedAccessException">They may not be written, or one is a folder.</exception>
        public FileDraft(string path)
        {
            bool isWrittenItself = IsWrittenItself(path);
            // A move asks for no right to write the file that it replaces.
            if (!isWrittenItself && (File.Exists(path) || Directory.Exists(path)))
                new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.Read).Dispose();
            (_path, _written) = (path, isWrittenItself ? path : path + ".tmp");
            // Another draft for the same place would be moved there in this one's stead.
            Stream = new FileStream(_written, FileMode.Create, FileAccess.Write,
                isWrittenItself ? FileShare.Read : FileShare.None);
        }

        /// <summary>Takes the content.</summary>
        public Stream Stream { get; }

        /// <summary>Writes a file at once.</summary>
        /// <param name="path">In a folder that exists.</param>
        /// <param name="write">Writes the content, and may close the stream. If it throws, a file that is there stays.</param>
        /// <inheritdoc cref="FileDraft(string)"/>
        public static void Write(string path, Action<Stream> write)
        {
            using (var draft = new FileDraft(path))
            {
                write(draft.Stream);
                draft.Finish();
            }
        }

        /// <summary>Whether a file may take a place: what is there, if anything, is empty or of the same kind.</summary>
        /// <param name="isOfItsKind">Whether the content is; from its beginning.</param>
        /// <exception cref="IOException">What is there cannot be read.</exception>
        /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
        public static bool MayReplace(string path, Func<Stream, bool> isOfItsKind)
        {
            // An empty file has nothing to lose, nor has a device or a pipe.
            if (!File.Exists(path) || new FileInfo(path).Length == 0)
                return true;
            using (var file = File.OpenRead(path))
                return isOfItsKind(file);
        }

        /// <summary>
        /// Checks that a file can be written, and leaves what is there. A file that a link names and that is missing is
        /// made.
        /// </summary>
        /// <inheritdoc cref="FileDraft(string)"/>
        public static void Check(string path)
        {
            if (IsWrittenItself(path))
                new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write).Dispose();
            else
                new FileDraft(path).Dispose();
        }

        /// <summary>The content is complete: closes the draft and moves it to its place.</summary>
        /// <exception cref="IOException">It cannot be moved, or the disk is full.</exception>
        /// <exception cref="UnauthorizedAccessException">It may not be moved.</exception>
        public void Finish()
        {
            Stream.Dispose();
            if (_written == _path)
                return;
            if (File.Exists(_path))
                File.Replace(_written, _path, null);
            else
                File.Move(_written, _path);
        }

        /// <summary>Removes a draft that is not finished.</summary>
        public void Dispose()
        {
            try
            {
                Stream.Dispose();
            }
            finally
            {
                if (_written != _path)
                    File.Delete(_written);
            }
        }

        // An empty file has nothing to lose.
        static bool IsWrittenItself(string path)
        {
            try
            {
                return (File.GetAttributes(path) & FileAttributes.ReparsePoint) != 0
                    || File.Exists(path) && new FileInfo(path).Length == 0;
            }
            catch (Exception error) when (error is FileNotFoundException || error is DirectoryNotFoundException)
            {
                return false;
            }
        }
    }
}
