using System;
using Glint.Host;
using Glint.Vulkan;
using Unity.Collections;
using UnityEngine.Experimental.Rendering;

namespace UnityEngine;

/// <summary>
/// A picture that kernels write: R8G8B8A8_UNorm with random write. The host does not rasterise, so that no other
/// picture has a use.
/// </summary>
public class RenderTexture : Texture, IReadbackSource
{
    VulkanDevice _device;
    GpuImage _image;
    bool _enableRandomWrite;

    public RenderTexture(int width, int height, int depth, GraphicsFormat format)
    {
        if (width <= 0 || height <= 0)
            throw new ArgumentException($"RenderTexture of {width} x {height} pixels: both sides must be above 0");
        if (depth != 0 || format != GraphicsFormat.R8G8B8A8_UNorm)
            throw new NotSupportedException($"the host has no RenderTexture of format {format} with a depth of {depth} "
                + "bits: use R8G8B8A8_UNorm and 0");
        (base.width, base.height, graphicsFormat) = (width, height, format);
    }

    public GraphicsFormat graphicsFormat { get; }

    public bool enableRandomWrite
    {
        get => _enableRandomWrite;
        set
        {
            if (IsCreated())
                throw new InvalidOperationException("enableRandomWrite of a RenderTexture is set before Create");
            _enableRandomWrite = value;
        }
    }

    /// <summary>Makes the picture on the device, black and transparent.</summary>
    public bool Create()
    {
        EnsureAlive();
        if (GraphicsDevice.IsNull)
            return false;
        if (!IsCreated())
        {
            _device = GraphicsDevice.Current;
            _image = _device.CreateImage(width, height);
        }
        return true;
    }

    public bool IsCreated() => _image is { IsDisposed: false };

    public void Release()
    {
        _image?.Dispose();
        _image = null;
    }

    internal GpuImage Image => IsCreated() ? _image
        : throw new InvalidOperationException($"the RenderTexture ({name}) was not created: call Create");

    internal override void OnDestroyed() => Release();

    bool IReadbackSource.IsValid => IsCreated();

    VulkanDevice IReadbackSource.Device => _device;

    long IReadbackSource.Bytes => Image.Bytes;

    unsafe long IReadbackSource.BeginGet(NativeArray<byte> data, long offset)
    {
        fixed (byte* target = data.AsSpan())
            return Image.BeginRead(target);
    }
}
