namespace Glint.Vulkan;

/// <summary>A buffer that a kernel uses.</summary>
/// <param name="Name">Name in the HLSL source.</param>
/// <param name="Stride">Bytes from element to element in the kernel; 4 for a ByteAddressBuffer.</param>
/// <param name="Element">The HLSL element type: "RayData", "float4", "uint".</param>
/// <param name="Writable">True for an RW buffer.</param>
public sealed record BufferSlot(string Name, int Stride, string Element, bool Writable)
{
    internal uint Binding { get; init; }
}
