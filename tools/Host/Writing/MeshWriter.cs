using System;
using System.Buffers.Binary;
using System.IO;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host;

/// <summary>
/// Writes a mesh in the form that <see cref="MeshRecord"/> reads: one stream of float32 channels, and the indices.
/// </summary>
internal static class MeshWriter
{
    const int ChannelCount = 14, FirstTexture = 4, ChunkBytes = 1 << 16;
    static readonly string[] _rangedVectors = ["m_Vertices", "m_UV", "m_Normals", "m_Tangents", "m_FloatColors"];
    static readonly string[] _compressedVectors =
        ["m_Vertices", "m_UV", "m_Normals", "m_Tangents", "m_Weights", "m_NormalSigns", "m_TangentSigns",
            "m_FloatColors", "m_BoneIndices", "m_Triangles"];

    internal static void Write(YamlWriter yaml, Mesh mesh)
    {
        MeshContents contents = mesh.Contents;
        bool isWide = contents.IndexFormat == IndexFormat.UInt32;
        yaml.Field("serializedVersion", 11);
        yaml.List("m_SubMeshes", contents.SubMeshes.Count,
            index => SubMesh(yaml, contents.SubMeshes[index], isWide ? sizeof(uint) : sizeof(ushort)));
        yaml.Map("m_Shapes", () =>
        {
            foreach (string key in new[] { "vertices", "shapes", "channels", "fullWeights" })
                yaml.Field(key, "[]");
        });
        yaml.Field("m_BindPose", "[]");
        yaml.Field("m_BoneNameHashes", "");
        yaml.Field("m_RootBoneNameHash", 0);
        yaml.Field("m_BonesAABB", "[]");
        yaml.Map("m_VariableBoneCountWeights", () => yaml.Field("m_Data", ""));
        yaml.Field("m_MeshCompression", 0);
        yaml.Field("m_IsReadable", contents.IsReadable);
        yaml.Field("m_KeepVertices", 1);
        yaml.Field("m_KeepIndices", 1);
        yaml.Field("m_IndexFormat", isWide);
        yaml.Field("m_IndexBuffer", text => Indices(text, contents.Indices, isWide));
        yaml.Map("m_VertexData", () => VertexData(yaml, contents));
        yaml.Map("m_CompressedMesh", () => NothingCompressed(yaml));
        yaml.Map("m_LocalAABB", () => EngineValueWriter.Box(yaml, contents.Bounds));
        yaml.Field("m_MeshUsageFlags", 0);
        yaml.Field("m_CookingOptions", 30);
        yaml.Field("m_BakedConvexCollisionMesh", "");
        yaml.Field("m_BakedTriangleCollisionMesh", "");
        yaml.Field("m_MeshMetrics[0]", 1);
        yaml.Field("m_MeshMetrics[1]", 1);
        yaml.Field("m_MeshOptimizationFlags", 1);
        yaml.Map("m_StreamData", () =>
        {
            yaml.Field("serializedVersion", 2);
            yaml.Field("offset", 0);
            yaml.Field("size", 0);
            yaml.Field("path", "");
        });
    }

    static void SubMesh(YamlWriter yaml, SubMeshDescriptor part, int indexBytes)
    {
        yaml.Field("serializedVersion", 2);
        yaml.Field("firstByte", (long)part.indexStart * indexBytes);
        yaml.Field("indexCount", part.indexCount);
        yaml.Field("topology", (int)part.topology);
        yaml.Field("baseVertex", part.baseVertex);
        yaml.Field("firstVertex", part.firstVertex);
        yaml.Field("vertexCount", part.vertexCount);
        yaml.Map("localAABB", () => EngineValueWriter.Box(yaml, part.bounds));
    }

    static void VertexData(YamlWriter yaml, MeshContents contents)
    {
        (int Dimension, Func<int, Vector4> Value)[] channels = Channels(contents);
        int stride = sizeof(float) * channels.Sum(channel => channel.Dimension), offset = 0;
        yaml.Field("serializedVersion", 3);
        yaml.Field("m_VertexCount", contents.Vertices.Length);
        yaml.List("m_Channels", ChannelCount, index =>
        {
            int dimension = channels[index].Dimension;
            yaml.Field("stream", 0);
            yaml.Field("offset", dimension > 0 ? offset : 0);
            yaml.Field("format", 0);
            yaml.Field("dimension", dimension);
            offset += sizeof(float) * dimension;
        });
        yaml.Field("m_DataSize", (long)stride * contents.Vertices.Length);
        yaml.Field("_typelessdata", text => Hex(text, contents.Vertices.Length, stride, (vertex, bytes) =>
        {
            foreach ((int dimension, Func<int, Vector4> value) in channels)
            {
                for (int component = 0; component < dimension; component++, bytes = bytes[sizeof(float)..])
                    BinaryPrimitives.WriteSingleLittleEndian(bytes, value(vertex)[component]);
            }
        }));
    }

    static (int Dimension, Func<int, Vector4> Value)[] Channels(MeshContents contents)
    {
        (int, Func<int, Vector4>)[] channels = new (int, Func<int, Vector4>)[ChannelCount];
        channels[0] = (contents.Vertices.Length > 0 ? 3 : 0, vertex => contents.Vertices[vertex]);
        channels[1] = (contents.Normals.Length > 0 ? 3 : 0, vertex => contents.Normals[vertex]);
        channels[2] = (contents.Tangents.Length > 0 ? 4 : 0, vertex => contents.Tangents[vertex]);
        channels[3] = (contents.Colors.Length > 0 ? 4 : 0, vertex => contents.Colors[vertex]);
        for (int uv = 0; uv < MeshContents.UvChannels; uv++)
        {
            Vector4[] values = contents.Uvs[uv];
            channels[FirstTexture + uv] = (TextureDimension(values), vertex => values[vertex]);
        }
        return channels;
    }

    // The mesh does not keep the number of components of a texture coordinate; trailing components that are 0
    // everywhere are left out.
    static int TextureDimension(Vector4[] values)
    {
        int dimension = values.Length > 0 ? 2 : 0;
        foreach (Vector4 value in values)
        {
            while (dimension < 4 && Enumerable.Range(dimension, 4 - dimension)
                .Any(component => BitConverter.SingleToInt32Bits(value[component]) != 0))
                dimension++;
        }
        return dimension;
    }

    static void Indices(TextWriter text, int[] indices, bool isWide) =>
        Hex(text, indices.Length, isWide ? sizeof(int) : sizeof(ushort), (index, bytes) =>
        {
            if (isWide)
                BinaryPrimitives.WriteInt32LittleEndian(bytes, indices[index]);
            else
                BinaryPrimitives.WriteUInt16LittleEndian(bytes, (ushort)indices[index]);
        });

    // Written in pieces, since the text of a mesh of millions of vertices would take several times its size.
    static void Hex(TextWriter text, int count, int itemBytes, FillItem fill)
    {
        int capacity = Math.Max(1, ChunkBytes / Math.Max(1, itemBytes));
        byte[] bytes = new byte[capacity * itemBytes];
        for (int start = 0; start < count; start += capacity)
        {
            int items = Math.Min(capacity, count - start);
            for (int item = 0; item < items; item++)
                fill(start + item, bytes.AsSpan(item * itemBytes, itemBytes));
            text.Write(Convert.ToHexStringLower(bytes.AsSpan(0, items * itemBytes)));
        }
    }

    static void NothingCompressed(YamlWriter yaml)
    {
        foreach (string key in _compressedVectors)
        {
            yaml.Map(key, () =>
            {
                yaml.Field("m_NumItems", 0);
                foreach (string range in _rangedVectors.Contains(key) ? new[] { "m_Range", "m_Start" } : [])
                    yaml.Field(range, 0);
                yaml.Field("m_Data", "");
                yaml.Field("m_BitSize", 0);
            });
        }
        yaml.Field("m_UVInfo", 0);
    }

    delegate void FillItem(int item, Span<byte> bytes);
}
