namespace Glint.Vulkan;

/// <summary>
/// A constant buffer of a kernel: <paramref name="Bytes"/> bytes at <paramref name="Start"/> of a dispatch's uniforms.
/// </summary>
readonly record struct UniformBlock(uint Binding, int Start, int Bytes);
