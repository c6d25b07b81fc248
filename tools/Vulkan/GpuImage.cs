using System;

namespace Glint.Vulkan;

/// <summary>
/// A picture of four bytes a pixel (VK_FORMAT_R8G8B8A8_UNORM) that kernels write; zero when new. Every device can store
/// to this format.
/// </summary>
public sealed unsafe class GpuImage : GpuResource
{
    internal const int PixelBytes = 4;

    ulong _image, _memory, _view;
    GpuBuffer _copy;

    internal GpuImage(VulkanDevice device, int width, int height) : base(device)
    {
        (Width, Height) = (width, height);
        string make = $"make a picture of {width} x {height} pixels on {device.Info.Name}";
        try
        {
            var info = new ImageCreateInfo
            {
                SType = StructureType.ImageCreateInfo, ImageType = Native.Image2D, Format = Native.Rgba8,
                Width = (uint)width, Height = (uint)height, Depth = 1, MipLevels = 1, ArrayLayers = 1, Samples = 1,
                Usage = Native.TransferSource | Native.TransferTarget | Native.ImageStorageUsage
            };
            VulkanException.Check(Native.vkCreateImage(device.Handle, &info, null, out _image), make);
            Native.vkGetImageMemoryRequirements(device.Handle, _image, out var needs);
            var request = new MemoryAllocateInfo
            {
                SType = StructureType.MemoryAllocateInfo, Size = needs.Size, TypeIndex = MemoryOf(needs, make)
            };
            VulkanException.Check(Native.vkAllocateMemory(device.Handle, &request, null, out _memory), make);
            VulkanException.Check(Native.vkBindImageMemory(device.Handle, _image, _memory, 0), make);
            var view = new ImageViewCreateInfo
            {
                SType = StructureType.ImageViewCreateInfo, Image = _image, ViewType = Native.View2D,
                Format = Native.Rgba8, Range = ImageRange.Whole
            };
            VulkanException.Check(Native.vkCreateImageView(device.Handle, &view, null, out _view), make);
            _copy = device.CreateBuffer((long)width * height * PixelBytes);
            device.Recorder.Clear(this);
        }
        catch
        {
            Destroy();
            throw;
        }
    }

    public int Width { get; }

    public int Height { get; }

    public override bool IsDisposed => _image == 0;

    /// <summary>Bytes of all pixels.</summary>
    public long Bytes => _copy.Bytes;

    internal ulong Handle => _image;

    internal ulong View => _view;

    /// <summary>Copies the pixels row by row, as <see cref="GpuBuffer.BeginRead"/> does bytes.</summary>
    public long BeginRead(byte* target)
    {
        ObjectDisposedException.ThrowIf(IsDisposed, this);
        Device.Recorder.Copy(this, _copy);
        return _copy.BeginRead(target, _copy.Bytes);
    }

    internal override void Destroy()
    {
        if (!Device.IsAbandoned)
        {
            Native.vkDestroyImageView(Device.Handle, _view, null);
            Native.vkDestroyImage(Device.Handle, _image, null);
            Native.vkFreeMemory(Device.Handle, _memory, null);
            _copy?.Dispose();
        }
        _image = _memory = _view = 0;
        _copy = null;
    }

    uint MemoryOf(in MemoryRequirements needs, string make)
    {
        int type = Device.Physical.FindMemory(needs.TypeBits, Native.DeviceLocal);
        if (type < 0)
            type = Device.Physical.FindMemory(needs.TypeBits, 0);
        return type >= 0 ? (uint)type : throw new VulkanException($"could not {make}: it lacks memory for pictures");
    }
}
