using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Host.Tests;

/// <summary>Writes Mesh assets: channels of vertex data in any format, indices, submeshes.</summary>
public sealed class MeshText
{
    public const int ChannelCount = 14;

    public string Name = "Hull";
    public int VertexCount;
    public (int Stream, int Offset, int Format, int Dimension)[] Channels = new (int, int, int, int)[ChannelCount];
    public byte[] VertexData = [];
    public uint[] Indices = [];
    public bool WideIndices;
    public bool IsReadable = true;
    public List<(int FirstByte, int IndexCount, int Topology, int BaseVertex)> SubMeshes = new();

    /// <summary>Positions only, with all indices in one submesh of triangles.</summary>
    public static MeshText Of(float[] positions, params uint[] indices)
    {
        MeshText mesh = new() { VertexCount = positions.Length / 3, VertexData = Floats(positions), Indices = indices };
        mesh.Channels[0] = (0, 0, 0, 3);
        mesh.SubMeshes.Add((0, indices.Length, 0, 0));
        return mesh;
    }

    public static byte[] Floats(params float[] values) => values.SelectMany(BitConverter.GetBytes).ToArray();

    public override string ToString() => UnityText.Header
        + $"--- !u!43 &4300000\nMesh:\n  m_Name: {Name}\n  serializedVersion: 11\n  m_SubMeshes:"
        + (SubMeshes.Count == 0 ? " []\n" : "\n" + string.Concat(SubMeshes.Select(SubMesh)))
        + $"  m_MeshCompression: 0\n  m_IsReadable: {(IsReadable ? 1 : 0)}\n  m_IndexFormat: {(WideIndices ? 1 : 0)}\n"
        + $"  m_IndexBuffer: {Hex(IndexBytes())}\n"
        + $"  m_VertexData:\n    serializedVersion: 3\n    m_VertexCount: {VertexCount}\n"
        + $"    m_Channels:\n{string.Concat(Channels.Select(Channel))}    m_DataSize: {VertexData.Length}\n"
        + $"    _typelessdata: {Hex(VertexData)}\n"
        + "  m_LocalAABB:\n    m_Center: {x: 1, y: 2, z: 3}\n    m_Extent: {x: 4, y: 5, z: 6}\n  'm_MeshMetrics[0]': "
        + "1\n  m_StreamData:\n    serializedVersion: 2\n    offset: 0\n    size: 0\n    path: \n";

    static string SubMesh((int FirstByte, int IndexCount, int Topology, int BaseVertex) part) =>
        $"  - serializedVersion: 2\n    firstByte: {part.FirstByte}\n    indexCount: {part.IndexCount}\n"
        + $"    topology: {part.Topology}\n    baseVertex: {part.BaseVertex}\n    firstVertex: 0\n    vertexCount: 0\n"
        + "    localAABB:\n      m_Center: {x: 0, y: 0, z: 0}\n      m_Extent: {x: 1, y: 1, z: 1}\n";

    static string Channel((int Stream, int Offset, int Format, int Dimension) channel) =>
        $"    - stream: {channel.Stream}\n      offset: {channel.Offset}\n      format: {channel.Format}\n"
        + $"      dimension: {channel.Dimension}\n";

    static string Hex(byte[] bytes) => Convert.ToHexString(bytes).ToLowerInvariant();

    byte[] IndexBytes()
    {
        int width = WideIndices ? 4 : 2;
        byte[] bytes = new byte[Indices.Length * width];
        for (int i = 0; i < Indices.Length; i++)
        {
            if (WideIndices)
                BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(i * width), Indices[i]);
            else
                BinaryPrimitives.WriteUInt16LittleEndian(bytes.AsSpan(i * width), (ushort)Indices[i]);
        }
        return bytes;
    }
}
