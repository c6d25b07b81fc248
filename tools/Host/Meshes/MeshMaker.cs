using System;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host;

/// <summary>Makes the engine's mesh from a decoded one.</summary>
internal static class MeshMaker
{
    const int Position = 0, Normal = 1, Tangent = 2, Colour = 3, FirstTexture = 4;

    internal static Mesh Make(MeshRecord record)
    {
        MeshContents contents = new()
        {
            Vertices = Vectors(record, Position, value => (Vector3)value),
            Normals = Vectors(record, Normal, value => (Vector3)value),
            Tangents = Vectors(record, Tangent, value => value),
            Colors = Vectors(record, Colour, value => new Color(value.x, value.y, value.z, value.w)),
            Uvs = Enumerable.Range(FirstTexture, MeshContents.UvChannels)
                .Select(channel => Vectors(record, channel, value => value)).ToArray(),
            Indices = record.Indices,
            IndexFormat = record.HasWideIndices ? IndexFormat.UInt32 : IndexFormat.UInt16,
            SubMeshes = record.SubMeshes.Select(Descriptor).ToList(),
            IsReadable = record.IsReadable,
            Bounds = Box(record.Box),
        };
        Mesh mesh = ObjectFactory.NewAsset<Mesh>();
        mesh.Load(contents);
        return mesh;
    }

    static SubMeshDescriptor Descriptor(SubMeshRecord subMesh) =>
        new(subMesh.FirstIndex, subMesh.IndexCount, (MeshTopology)subMesh.Topology)
        {
            baseVertex = subMesh.BaseVertex,
            firstVertex = subMesh.FirstVertex,
            vertexCount = subMesh.VertexCount,
            bounds = Box(subMesh.Box),
        };

    static Bounds Box(FieldMap fields) =>
        new(EngineValues.Vector(fields.Map("m_Center")), EngineValues.Vector(fields.Map("m_Extent")) * 2f);

    // Missing components of a channel are 0. The result is empty if the mesh lacks the channel.
    static T[] Vectors<T>(MeshRecord record, int channel, Func<Vector4, T> convert)
    {
        int dimension = record.Dimension(channel);
        if (dimension == 0)
            return [];
        float[] values = record.Channel(channel);
        T[] vectors = new T[record.VertexCount];
        for (int vertex = 0; vertex < vectors.Length; vertex++)
        {
            Vector4 value = default;
            for (int component = 0; component < dimension; component++)
                value[component] = values[vertex * dimension + component];
            vectors[vertex] = convert(value);
        }
        return vectors;
    }
}
