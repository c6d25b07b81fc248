using System;
using System.IO;

namespace Glint.Core
{
    /// <summary>
    /// Reads the triangles of Wavefront OBJ and STL files.
    /// Coordinates are taken as Unity's (x right, y up, z forward), not mirrored.
    /// With z up, (x, y, z) becomes (x, z, y); that mirrors, so the corners of each triangle change order
    /// and faces keep their outer side.
    /// The tracer does not depend on that order: triangles reflect on both sides.
    /// </summary>
    public static class MeshFileReader
    {
        const int SniffedBytes = 1024;

        /// <summary>
        /// Whether the extension, in any case,
        /// is of a format that <see cref="Read(string, LengthUnit, UpAxis)"/> takes.
        /// </summary>
        public static bool IsMeshFile(string path) => HasExtension(path, ".obj") || HasExtension(path, ".stl");

        /// <summary>Reads a file; coordinates are scaled in double and rounded once to float.</summary>
        /// <param name="path">An .obj or .stl file.</param>
        /// <param name="unit">Unit of the file's coordinates.</param>
        /// <param name="up">Axis of the file that points up.</param>
        /// <exception cref="UsageException">Another extension.</exception>
        /// <exception cref="GlintException">
        /// The file cannot be read, has another format than its extension, is damaged, or has no triangles.
        /// </exception>
        public static MeshFile Read(string path, LengthUnit unit, UpAxis up)
        {
            RefuseOtherExtension(path);
            if (Directory.Exists(path))
                throw new GlintException($"{path}: is a folder; give the .obj or .stl file in it");
            if (!File.Exists(path))
                throw new GlintException($"{path}: there is no such file; check the path");
            try
            {
                // A pipe or device has length 0 too; opening one may block.
                if (new FileInfo(path).Length == 0)
                    throw Empty(path);
                using (var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, 1))
                    return Read(stream, path, unit, up);
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException)
            {
                throw new GlintException($"{path}: cannot be read: {error.Message}", error);
            }
            catch (OutOfMemoryException error)
            {
                throw new GlintException($"{path}: the mesh does not fit into memory; simplify or split it", error);
            }
        }

        /// <summary>
        /// Reads a stream of known length, from its beginning;
        /// <paramref name="path"/> names it in messages and gives the format.
        /// </summary>
        internal static MeshFile Read(Stream stream, string path, LengthUnit unit, UpAxis up)
        {
            RefuseOtherExtension(path);
            if (!stream.CanSeek || stream.Length == 0)
                throw Empty(path);

            var placement = new MeshFilePlacement(unit, up);
            var head = Head(stream);
            if (HasExtension(path, ".stl") && StlBinaryReader.IsBinary(head, stream.Length))
                return new StlBinaryReader(stream, path, placement).Read();

            RefuseForeign(path, head);
            if (HasExtension(path, ".obj"))
                return new ObjReader(stream, path, placement).Read();
            if (StlTextReader.IsText(head))
                return new StlTextReader(stream, path, placement).Read();
            throw StlBinaryReader.WrongLength(path, head, stream.Length);
        }

        static GlintException Empty(string path) =>
            new GlintException($"{path}: is empty, or a pipe or device instead of a file; export the mesh again");

        static void RefuseOtherExtension(string path)
        {
            if (!IsMeshFile(path))
                throw new UsageException($"{path}: is not a mesh file: give an .obj or .stl");
        }

        // Files with the extension of a mesh that are archives or links to one.
        static void RefuseForeign(string path, ReadOnlySpan<byte> head)
        {
            if (Bytes.StartsWith(head, 0x1f, 0x8b))
                throw new GlintException($"{path}: is compressed by gzip; decompress it first (gunzip)");
            if (Bytes.StartsWith(head, (byte)'P', (byte)'K', 3, 4))
                throw new GlintException($"{path}: is a zip archive; unpack it first (unzip)");
            if (Bytes.StartsWith(head, 0xff, 0xfe) || Bytes.StartsWith(head, 0xfe, 0xff))
                throw new GlintException($"{path}: is UTF-16 text; save it as UTF-8 or ASCII");
            if (Bytes.StartsWith(head, "version https://git-lfs"))
                throw new GlintException($"{path}: is a Git LFS pointer, not the mesh itself; "
                    + "fetch it with: git lfs pull");
        }

        static ReadOnlySpan<byte> Head(Stream stream)
        {
            var head = new byte[Math.Min(SniffedBytes, stream.Length)];
            int count = Bytes.Fill(stream, head, head.Length);
            stream.Position = 0;
            return new ReadOnlySpan<byte>(head, 0, count);
        }

        static bool HasExtension(string path, string extension) =>
            path.EndsWith(extension, StringComparison.OrdinalIgnoreCase);
    }
}
