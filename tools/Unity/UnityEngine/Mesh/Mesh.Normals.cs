using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Vector3[] normals
    {
        get => Read("normals", Contents.Normals);
        set => SetNormals(value);
    }

    public void GetNormals(List<Vector3> normals) => Read("normals", Contents.Normals, normals);
    public void SetNormals(List<Vector3> inNormals) => StoreNormals(CollectionsMarshal.AsSpan(inNormals));
    public void SetNormals(List<Vector3> inNormals, int start, int length) =>
        StoreNormals(CollectionsMarshal.AsSpan(inNormals).Slice(start, length));
    public void SetNormals(List<Vector3> inNormals, int start, int length, MeshUpdateFlags flags) =>
        SetNormals(inNormals, start, length);
    public void SetNormals(Vector3[] inNormals) => StoreNormals(inNormals);
    public void SetNormals(Vector3[] inNormals, int start, int length) => StoreNormals(inNormals.AsSpan(start, length));
    public void SetNormals(Vector3[] inNormals, int start, int length, MeshUpdateFlags flags) =>
        SetNormals(inNormals, start, length);
    public void SetNormals<T>(NativeArray<T> inNormals) where T : struct =>
        StoreNormals(Cast<T, Vector3>(inNormals.AsSpan()));
    public void SetNormals<T>(NativeArray<T> inNormals, int start, int length) where T : struct =>
        StoreNormals(Cast<T, Vector3>(inNormals.AsSpan().Slice(start, length)));
    public void SetNormals<T>(NativeArray<T> inNormals, int start, int length, MeshUpdateFlags flags)
        where T : struct => SetNormals(inNormals, start, length);

    public Vector4[] tangents
    {
        get => Read("tangents", Contents.Tangents);
        set => SetTangents(value);
    }

    public void GetTangents(List<Vector4> tangents) => Read("tangents", Contents.Tangents, tangents);
    public void SetTangents(List<Vector4> inTangents) => StoreTangents(CollectionsMarshal.AsSpan(inTangents));
    public void SetTangents(List<Vector4> inTangents, int start, int length) =>
        StoreTangents(CollectionsMarshal.AsSpan(inTangents).Slice(start, length));
    public void SetTangents(List<Vector4> inTangents, int start, int length, MeshUpdateFlags flags) =>
        SetTangents(inTangents, start, length);
    public void SetTangents(Vector4[] inTangents) => StoreTangents(inTangents);
    public void SetTangents(Vector4[] inTangents, int start, int length) =>
        StoreTangents(inTangents.AsSpan(start, length));
    public void SetTangents(Vector4[] inTangents, int start, int length, MeshUpdateFlags flags) =>
        SetTangents(inTangents, start, length);
    public void SetTangents<T>(NativeArray<T> inTangents) where T : struct =>
        StoreTangents(Cast<T, Vector4>(inTangents.AsSpan()));
    public void SetTangents<T>(NativeArray<T> inTangents, int start, int length) where T : struct =>
        StoreTangents(Cast<T, Vector4>(inTangents.AsSpan().Slice(start, length)));
    public void SetTangents<T>(NativeArray<T> inTangents, int start, int length, MeshUpdateFlags flags)
        where T : struct => SetTangents(inTangents, start, length);

    void StoreNormals(ReadOnlySpan<Vector3> values) => Contents.Normals = Channel("normals", Contents.Normals, values);
    void StoreTangents(ReadOnlySpan<Vector4> values) =>
        Contents.Tangents = Channel("tangents", Contents.Tangents, values);
}
