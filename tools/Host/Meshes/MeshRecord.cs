using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Host;

/// <summary>
/// The decoded content of a Mesh asset: an array of numbers for each vertex channel, one of indices, and the
/// submeshes.
/// </summary>
internal sealed class MeshRecord
{
    const int ChannelCount = 14, StreamAlignment = 16, StrideAlignment = 4;
    const int Triangles = 0, Quads = 2, Points = 5;
    static readonly string[] _vertexKeys = ["m_VertexCount", "m_Channels", "m_DataSize", "_typelessdata"];

    readonly ObjectRecord _record;
    readonly float[][] _channels = new float[ChannelCount][];
    readonly int[] _dimensions = new int[ChannelCount];

    /// <exception cref="GlintException">The data contradict the file's own description.</exception>
    internal MeshRecord(ObjectRecord record)
    {
        _record = record;
        FieldMap fields = record.Fields;
        if (fields.Integer("m_MeshCompression") != 0)
            throw record.Error("is compressed: set its Mesh Compression to Off");
        if (fields.Map("m_StreamData").Text("path").Length > 0)
            throw record.Error("keeps its vertices in another file: save it again as a separate asset");
        IsReadable = fields.Flag("m_IsReadable", true);
        HasWideIndices = fields.Integer("m_IndexFormat") != 0;
        ReadVertices(fields.Map("m_VertexData"));
        Indices = ReadIndices(fields);
        SubMeshes = fields.Maps("m_SubMeshes").Select(ReadSubMesh).ToList();
        Box = fields.Map("m_LocalAABB");
    }

    internal bool IsReadable { get; }

    internal bool HasWideIndices { get; }

    internal int VertexCount { get; private set; }

    internal int[] Indices { get; }

    internal IReadOnlyList<SubMeshRecord> SubMeshes { get; }

    /// <summary>The mesh's m_Center and m_Extent; Unity too reads them from the file.</summary>
    internal FieldMap Box { get; }

    int IndexBytes => HasWideIndices ? sizeof(uint) : sizeof(ushort);

    /// <summary>
    /// Number of components of a channel (0 position, 1 normal, 2 tangent, 3 colour, 4 to 11 texture coordinates); 0
    /// if absent.
    /// </summary>
    internal int Dimension(int channel) => _dimensions[channel];

    /// <summary>All values of a channel, vertex by vertex; null if absent.</summary>
    internal float[] Channel(int channel) => _channels[channel];

    void ReadVertices(FieldMap data)
    {
        foreach (string key in _vertexKeys)
        {
            if (!data.Has(key))
                throw _record.Flaw($"its m_VertexData has no {key}, the file has been cut short: restore the file");
        }
        VertexCount = data.Count("m_VertexCount");
        byte[] bytes = Hex(data, "_typelessdata");
        int stated = data.Count("m_DataSize");
        if (bytes.Length != stated)
            throw _record.Flaw($"its vertex data are {bytes.Length} bytes long, "
                + $"and m_DataSize says {stated}: restore the file");
        if (VertexCount == 0)
            return;

        List<VertexChannel> channels = data.Maps("m_Channels").Take(ChannelCount).Select(ReadChannel).ToList();
        if (channels.Count == 0 || channels[0].Dimension != 3)
            throw _record.Flaw("its vertices have no position of three components: restore the file");
        long start = 0;
        for (int stream = 0; stream <= VertexChannel.LastStream; stream++)
        {
            List<int> members = Enumerable.Range(0, channels.Count)
                .Where(i => channels[i].IsPresent && channels[i].Stream == stream).ToList();
            if (members.Count == 0)
                continue;
            int stride = Align(members.Max(i => channels[i].End), StrideAlignment);
            start = Align(start, StreamAlignment);
            long length = (long)stride * VertexCount;
            if (start + length > bytes.Length)
                throw _record.Flaw($"{VertexCount} vertices need {start + length} bytes, "
                    + $"and the file has {bytes.Length}: restore the file");
            foreach (int i in members)
            {
                _channels[i] = channels[i].Read(bytes.AsSpan((int)start, (int)length), stride, VertexCount);
                _dimensions[i] = channels[i].Dimension;
            }
            start += length;
        }
    }

    VertexChannel ReadChannel(FieldMap fields)
    {
        // The high half of a dimension marks channels of instanced data.
        VertexChannel channel = new(fields.Count("stream"), fields.Count("offset"), fields.Count("format"),
            fields.Count("dimension") & 0xf);
        if (channel.Stream > VertexChannel.LastStream || channel.Format > VertexChannel.LastFormat
            || channel.Offset > byte.MaxValue || channel.Dimension > 4)
            throw _record.Flaw($"a vertex channel has stream {channel.Stream}, offset {channel.Offset}, "
                + $"format {channel.Format}, dimension {channel.Dimension}, which Unity lacks: restore the file");
        return channel;
    }

    int[] ReadIndices(FieldMap fields)
    {
        byte[] buffer = Hex(fields, "m_IndexBuffer");
        int[] indices = new int[buffer.Length / IndexBytes];
        for (int i = 0; i < indices.Length; i++)
        {
            ReadOnlySpan<byte> data = buffer.AsSpan(i * IndexBytes);
            indices[i] = HasWideIndices
                ? BinaryPrimitives.ReadInt32LittleEndian(data)
                : BinaryPrimitives.ReadUInt16LittleEndian(data);
        }
        return indices;
    }

    SubMeshRecord ReadSubMesh(FieldMap fields, int number)
    {
        SubMeshRecord subMesh = new(
            fields.Count("topology"), fields.Count("firstByte") / IndexBytes,
            fields.Count("indexCount"), fields.Count("baseVertex"),
            fields.Count("firstVertex"), fields.Count("vertexCount"), fields.Map("localAABB"));
        if ((long)subMesh.FirstIndex + subMesh.IndexCount > Indices.Length)
            throw _record.Flaw($"submesh {number} has {subMesh.IndexCount} indices from number {subMesh.FirstIndex} "
                + $"on, and m_IndexBuffer holds {Indices.Length}: restore the file");
        if (subMesh.Topology is not (Triangles or (>= Quads and <= Points)))
            throw _record.Flaw($"submesh {number} has topology {subMesh.Topology}, "
                + "which Unity lacks: restore the file");
        int corners = subMesh.Topology switch { Triangles => 3, Quads => 4, _ => 1 };
        if (subMesh.IndexCount % corners != 0)
            throw _record.Flaw($"submesh {number} has {subMesh.IndexCount} indices, "
                + $"not a multiple of {corners}: restore the file");
        foreach (int index in Indices.AsSpan(subMesh.FirstIndex, subMesh.IndexCount))
        {
            // 32-bit indices are unsigned.
            long vertex = (long)(uint)index + subMesh.BaseVertex;
            if (vertex < 0 || vertex >= VertexCount)
                throw _record.Flaw($"submesh {number} has index {vertex}, "
                    + $"and the mesh has {VertexCount} vertices: correct the mesh");
        }
        return subMesh;
    }

    byte[] Hex(FieldMap fields, string key)
    {
        try
        {
            return Convert.FromHexString(fields.Text(key));
        }
        catch (FormatException error)
        {
            throw new GlintException(
                _record.Flaw($"{key} is not hexadecimal text: restore the file").Message, error);
        }
    }

    static int Align(int value, int to) => (value + to - 1) / to * to;

    static long Align(long value, int to) => (value + to - 1) / to * to;
}
