using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Glint.Host;

namespace UnityEngine;

// Values are kept as the bytes given and copied to where the kernel declares the name, as Unity does:
// an array of floats therefore needs the padding of HLSL's packing rules (one element in each row of 16 bytes).
// A name the kernel lacks is ignored.
public sealed partial class ComputeShader
{
    readonly Dictionary<int, UniformValue> _values = new();

    public void SetFloat(string name, float val) => SetFloat(Shader.PropertyToID(name), val);

    public void SetFloat(int nameID, float val) => Set(nameID, new ReadOnlySpan<float>(in val));

    public void SetInt(string name, int val) => SetInt(Shader.PropertyToID(name), val);

    public void SetInt(int nameID, int val) => Set(nameID, new ReadOnlySpan<int>(in val));

    public void SetBool(string name, bool val) => SetInt(name, val ? 1 : 0);

    public void SetBool(int nameID, bool val) => SetInt(nameID, val ? 1 : 0);

    public void SetFloats(string name, params float[] values) => SetFloats(Shader.PropertyToID(name), values);

    public void SetFloats(int nameID, params float[] values) => Set<float>(nameID, values);

    public void SetInts(string name, params int[] values) => SetInts(Shader.PropertyToID(name), values);

    public void SetInts(int nameID, params int[] values) => Set<int>(nameID, values);

    public void SetVector(string name, Vector4 val) => SetVector(Shader.PropertyToID(name), val);

    public void SetVector(int nameID, Vector4 val) => Set(nameID, new ReadOnlySpan<Vector4>(in val));

    public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(Shader.PropertyToID(name), values);

    public void SetVectorArray(int nameID, Vector4[] values) => Set<Vector4>(nameID, values);

    public void SetMatrix(string name, Matrix4x4 val) => SetMatrix(Shader.PropertyToID(name), val);

    public void SetMatrix(int nameID, Matrix4x4 val) => Set(nameID, new ReadOnlySpan<Matrix4x4>(in val));

    public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(Shader.PropertyToID(name), values);

    public void SetMatrixArray(int nameID, Matrix4x4[] values) => Set<Matrix4x4>(nameID, values);

    void Set<T>(int id, ReadOnlySpan<T> value) where T : unmanaged
    {
        EnsureAlive();
        var bytes = MemoryMarshal.AsBytes(value);
        if (!_values.TryGetValue(id, out var kept))
            _values[id] = kept = new UniformValue();
        if (kept.Bytes == null || kept.Bytes.Length < bytes.Length)
            Array.Resize(ref kept.Bytes, bytes.Length);
        bytes.CopyTo(kept.Bytes); // a shorter array leaves the rest unchanged
        kept.Version++;
    }
}
