namespace Glint.Vulkan;

/// <summary>A buffer or a picture that a kernel uses.</summary>
/// <param name="Name">Name in the HLSL source.</param>
/// <param name="Stride">Bytes from element to element in the kernel; 4 for a ByteAddressBuffer, 0 for a picture.</param>
/// <param name="Element">The HLSL element type: "RayData", "float4", "uint".</param>
/// <param name="Writable">True for an RW buffer.</param>
public sealed record BufferSlot(string Name, int Stride, string Element, bool Writable)
{
    /// <summary>Whether it is an RWTexture2D.</summary>
    public bool IsImage => Stride == 0;

    internal uint Binding { get; init; }

    internal uint DescriptorType => IsImage ? Native.StorageImage : Native.StorageBuffer;
}
