using System;
using System.Buffers.Binary;

namespace Glint.Host;

/// <summary>One attribute of the vertices (position, normal, ...): its stream, offset and number format.</summary>
internal readonly record struct VertexChannel(int Stream, int Offset, int Format, int Dimension)
{
    const int Float32 = 0, Float16 = 1, UNorm8 = 2, SNorm8 = 3, UNorm16 = 4, SNorm16 = 5, UInt8 = 6, SInt8 = 7,
        UInt16 = 8, SInt16 = 9, UInt32 = 10, SInt32 = 11;
    internal const int LastFormat = SInt32;
    internal const int LastStream = 3;

    internal bool IsPresent => Dimension > 0;

    internal int End => Offset + Dimension * ComponentBytes;

    int ComponentBytes => Format switch
    {
        UNorm8 or SNorm8 or UInt8 or SInt8 => 1,
        Float16 or UNorm16 or SNorm16 or UInt16 or SInt16 => 2,
        _ => 4,
    };

    /// <summary>All components of all vertices, vertex by vertex.</summary>
    /// <param name="stream">The channel's stream from its first byte.</param>
    /// <param name="stride">Bytes from one vertex to the next.</param>
    internal float[] Read(ReadOnlySpan<byte> stream, int stride, int vertexCount)
    {
        float[] values = new float[vertexCount * Dimension];
        int bytes = ComponentBytes;
        for (int vertex = 0, next = 0; vertex < vertexCount; vertex++)
        {
            ReadOnlySpan<byte> data = stream.Slice(vertex * stride + Offset, Dimension * bytes);
            for (int component = 0; component < Dimension; component++)
                values[next++] = Component(data[(component * bytes)..]);
        }
        return values;
    }

    float Component(ReadOnlySpan<byte> data) => Format switch
    {
        Float32 => BinaryPrimitives.ReadSingleLittleEndian(data),
        Float16 => (float)BinaryPrimitives.ReadHalfLittleEndian(data),
        UNorm8 => data[0] / 255f,
        SNorm8 => Math.Max((sbyte)data[0] / 127f, -1f),
        UNorm16 => BinaryPrimitives.ReadUInt16LittleEndian(data) / 65535f,
        SNorm16 => Math.Max(BinaryPrimitives.ReadInt16LittleEndian(data) / 32767f, -1f),
        UInt8 => data[0],
        SInt8 => (sbyte)data[0],
        UInt16 => BinaryPrimitives.ReadUInt16LittleEndian(data),
        SInt16 => BinaryPrimitives.ReadInt16LittleEndian(data),
        UInt32 => BinaryPrimitives.ReadUInt32LittleEndian(data),
        _ => BinaryPrimitives.ReadInt32LittleEndian(data),
    };
}
