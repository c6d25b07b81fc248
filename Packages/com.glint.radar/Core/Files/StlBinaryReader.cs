using System;
using System.Buffers.Binary;
using System.IO;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Reads a binary STL: a header of 80 bytes, the number of triangles, and 50 bytes for each: normal and three
    /// corners in float32, and two unused bytes.
    /// Normals are not used. Coinciding corners are not merged: the tracer needs no shared vertices.
    /// </summary>
    sealed class StlBinaryReader
    {
        const int HeadBytes = 84;
        const int CountAt = 80;
        const int RecordBytes = 50;
        const int CornersAt = 12;
        const int RecordsAtOnce = 1024;
        const int MaxTriangles = int.MaxValue / 3;

        readonly Stream _stream;
        readonly string _path;
        readonly MeshFilePlacement _placement;

        public StlBinaryReader(Stream stream, string path, MeshFilePlacement placement)
        {
            _stream = stream;
            _path = path;
            _placement = placement;
        }

        /// <summary>
        /// Whether the length matches the number of triangles. The word "solid" does not decide: binary files may begin
        /// with it. Text read as a number would need more than 7 GB.
        /// </summary>
        public static bool IsBinary(ReadOnlySpan<byte> head, long length) =>
            head.Length >= HeadBytes && length == LengthOf(Count(head));

        /// <summary>The failure for a file that is neither text nor of the right length.</summary>
        public static GlintException WrongLength(string path, ReadOnlySpan<byte> head, long length)
        {
            if (head.Length < HeadBytes)
                return new GlintException($"{path}: has {length} bytes, "
                    + $"too few for a binary STL ({HeadBytes} and {RecordBytes} for each triangle), "
                    + "and does not begin with \"solid\" as an ASCII one: it is truncated; export it again");
            uint count = Count(head);
            return new GlintException($"{path}: announces {count} triangles, which take {LengthOf(count)} bytes, "
                + $"but has {length}: it is truncated, damaged or not an STL; export it again");
        }

        public MeshFile Read()
        {
            // The file's length matches the count, so that the count may size the buffers.
            var buffer = new byte[RecordBytes * RecordsAtOnce];
            Bytes.Fill(_stream, buffer, HeadBytes);
            uint count = Count(buffer);
            if (count == 0)
                throw new GlintException($"{_path}: has no triangles; export the mesh again");
            if (count > MaxTriangles)
                throw new GlintException($"{_path}: has {count} triangles, more than {MaxTriangles}; "
                    + "simplify or split the mesh");

            var vertices = new float3[3 * (int)count];
            var indices = new int[vertices.Length];
            for (int i = 0; i < indices.Length; i++)
                indices[i] = i;
            for (int first = 0; first < count; first += RecordsAtOnce)
            {
                int records = Math.Min(RecordsAtOnce, (int)count - first);
                if (Bytes.Fill(_stream, buffer, RecordBytes * records) < RecordBytes * records)
                    throw new GlintException($"{_path}: became shorter while it was read; "
                        + "try again when nothing writes to it");
                for (int i = 0; i < records; i++)
                    ReadTriangle(new ReadOnlySpan<byte>(buffer, RecordBytes * i + CornersAt, RecordBytes - CornersAt),
                        first + i, vertices);
            }
            return new MeshFile(Path.GetFileNameWithoutExtension(_path), vertices, _placement.Turn(indices));
        }

        void ReadTriangle(ReadOnlySpan<byte> corners, int triangle, float3[] vertices)
        {
            for (int corner = 0; corner < 3; corner++)
            {
                float x = Coordinate(corners, triangle, corner, 0), y = Coordinate(corners, triangle, corner, 1),
                    z = Coordinate(corners, triangle, corner, 2);
                vertices[3 * triangle + corner] = _placement.Turn(x, y, z);
            }
        }

        float Coordinate(ReadOnlySpan<byte> corners, int triangle, int corner, int axis)
        {
            float value = BitConverter.Int32BitsToSingle(
                BinaryPrimitives.ReadInt32LittleEndian(corners.Slice(4 * (3 * corner + axis))));
            float meters = _placement.Scale(value);
            if (float.IsNaN(value) || float.IsInfinity(value))
                throw Error(triangle, corner, axis, $"{Name(value)}; correct the mesh or export it again");
            if (float.IsInfinity(meters))
                throw Error(triangle, corner, axis, $"{Numbers.Format(value)} {_placement.Unit}, "
                    + "more than a float holds (3.4e38 m); correct the mesh or choose another unit");
            return meters;
        }

        GlintException Error(int triangle, int corner, int axis, string message) =>
            new GlintException($"{_path}: triangle {triangle + 1}, corner {corner + 1}: {"xyz"[axis]} is {message}");

        static string Name(float value) => float.IsNaN(value) ? "NaN" : value > 0 ? "infinite" : "minus infinite";

        static uint Count(ReadOnlySpan<byte> head) => BinaryPrimitives.ReadUInt32LittleEndian(head.Slice(CountAt));

        static long LengthOf(uint count) => HeadBytes + (long)RecordBytes * count;
    }
}
