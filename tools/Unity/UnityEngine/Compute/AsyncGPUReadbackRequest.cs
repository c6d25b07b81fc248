using System;
using Glint.Host;
using Unity.Collections;

namespace UnityEngine.Rendering;

public struct AsyncGPUReadbackRequest
{
    readonly Readback _readback;

    internal AsyncGPUReadbackRequest(Readback readback) => _readback = readback;

    public bool done => _readback?.IsDone ?? true;

    public bool hasError => _readback?.HasError ?? true;

    public int layerCount => 1;

    public int layerDataSize => _readback?.Size ?? 0;

    public int width => layerDataSize;

    public int height => 1;

    public int depth => 1;

    public void Update() => AsyncGPUReadback.Update(_readback);

    public void WaitForCompletion() => AsyncGPUReadback.Complete(_readback);

    public NativeArray<T> GetData<T>(int layer = 0) where T : struct
    {
        if (layer != 0)
            throw new ArgumentException($"layer {layer} of a buffer, which has one", nameof(layer));
        if (_readback == null)
            throw new InvalidOperationException("this read-back was never requested");
        return _readback.Data<T>();
    }
}
