using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Glint.Host;
using Unity.Collections;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Vector2[] uv { get => Uvs(0); set => SetUVs(0, value); }
    public Vector2[] uv2 { get => Uvs(1); set => SetUVs(1, value); }
    public Vector2[] uv3 { get => Uvs(2); set => SetUVs(2, value); }
    public Vector2[] uv4 { get => Uvs(3); set => SetUVs(3, value); }

    public void GetUVs(int channel, List<Vector2> uvs) =>
        Read(UvName(channel), Array.ConvertAll(Contents.Uvs[channel], uv => (Vector2)uv), uvs);
    public void SetUVs(int channel, List<Vector2> uvs) => SetUVs(channel, uvs?.ToArray());
    public void SetUVs(int channel, List<Vector2> uvs, int start, int length) =>
        SetUVs(channel, uvs.GetRange(start, length).ToArray());
    public void SetUVs(int channel, Vector2[] uvs) =>
        StoreUvs(channel, Array.ConvertAll(uvs ?? Array.Empty<Vector2>(), uv => (Vector4)uv));
    public void SetUVs(int channel, Vector2[] uvs, int start, int length) =>
        SetUVs(channel, uvs.AsSpan(start, length).ToArray());

    public void GetUVs(int channel, List<Vector3> uvs) =>
        Read(UvName(channel), Array.ConvertAll(Contents.Uvs[channel], uv => (Vector3)uv), uvs);
    public void SetUVs(int channel, List<Vector3> uvs) => SetUVs(channel, uvs?.ToArray());
    public void SetUVs(int channel, List<Vector3> uvs, int start, int length) =>
        SetUVs(channel, uvs.GetRange(start, length).ToArray());
    public void SetUVs(int channel, Vector3[] uvs) =>
        StoreUvs(channel, Array.ConvertAll(uvs ?? Array.Empty<Vector3>(), uv => (Vector4)uv));
    public void SetUVs(int channel, Vector3[] uvs, int start, int length) =>
        SetUVs(channel, uvs.AsSpan(start, length).ToArray());

    public void GetUVs(int channel, List<Vector4> uvs) =>
        Read(UvName(channel), Array.ConvertAll(Contents.Uvs[channel], uv => (Vector4)uv), uvs);
    public void SetUVs(int channel, List<Vector4> uvs) => SetUVs(channel, uvs?.ToArray());
    public void SetUVs(int channel, List<Vector4> uvs, int start, int length) =>
        SetUVs(channel, uvs.GetRange(start, length).ToArray());
    public void SetUVs(int channel, Vector4[] uvs) =>
        StoreUvs(channel, Array.ConvertAll(uvs ?? Array.Empty<Vector4>(), uv => (Vector4)uv));
    public void SetUVs(int channel, Vector4[] uvs, int start, int length) =>
        SetUVs(channel, uvs.AsSpan(start, length).ToArray());

    public void SetUVs<T>(int channel, NativeArray<T> uvs) where T : struct => SetUVs(channel, uvs, 0, uvs.Length);

    public void SetUVs<T>(int channel, NativeArray<T> uvs, int start, int length)
        where T : struct
    {
        ReadOnlySpan<T> values = uvs.AsSpan().Slice(start, length);
        switch (Marshal.SizeOf<T>())
        {
            case 8: SetUVs(channel, Cast<T, Vector2>(values).ToArray()); break;
            case 12: SetUVs(channel, Cast<T, Vector3>(values).ToArray()); break;
            default: SetUVs(channel, Cast<T, Vector4>(values).ToArray()); break;
        }
    }

    Vector2[] Uvs(int channel) => Array.ConvertAll(Read(UvName(channel), Contents.Uvs[channel]), uv => (Vector2)uv);

    void StoreUvs(int channel, Vector4[] values)
    {
        string name = UvName(channel);
        Contents.Uvs[channel] = Channel(name, Contents.Uvs[channel], values);
    }

    static string UvName(int channel)
    {
        if (channel < 0 || channel >= MeshContents.UvChannels)
            throw new ArgumentOutOfRangeException(nameof(channel), channel,
                "The uv index is invalid. Must be in the range 0 to 7.");
        return channel == 0 ? "uv" : "uv" + (channel + 1);
    }
}
