using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Glint.Vulkan;

namespace Glint.Host.Tests.Vulkan;

/// <summary>The tests' own kernels and helpers to run them.</summary>
static class Kernels
{
    internal const string Arithmetic = "tools/Tests/Host/Shaders/Arithmetic.compute";
    internal const string Uniforms = "tools/Tests/Host/Shaders/Uniforms.compute";
    internal const string Structs = "tools/Tests/Host/Shaders/Structs.compute";
    internal const string Buffers = "tools/Tests/Host/Shaders/Buffers.compute";

    internal const string Indirect = "tools/Tests/Host/Shaders/Indirect.compute";

    internal static ComputeProgram Create(VulkanDevice device, string computePath, string kernel) =>
        device.CreateProgram(ShaderLibrary.Load(computePath, kernel));

    internal static GpuBuffer Buffer<T>(VulkanDevice device, T[] data) where T : unmanaged
    {
        var bytes = MemoryMarshal.AsBytes<T>(data);
        var buffer = device.CreateBuffer(bytes.Length);
        buffer.Write(bytes);
        return buffer;
    }

    internal static T[] Read<T>(GpuBuffer buffer) where T : unmanaged
    {
        var data = new T[buffer.Bytes / Marshal.SizeOf<T>()];
        buffer.Read(MemoryMarshal.AsBytes(data.AsSpan()));
        return data;
    }

    /// <summary>Uniform bytes of a program with the given values at their reflected offsets.</summary>
    internal static byte[] Pack(ComputeProgram program, params (string Name, object Value)[] values)
    {
        var bytes = new byte[program.UniformBytes];
        foreach (var (name, value) in values)
        {
            var raw = value switch
            {
                float[] floats => MemoryMarshal.AsBytes(floats.AsSpan()),
                int[] ints => MemoryMarshal.AsBytes(ints.AsSpan()),
                uint number => BitConverter.GetBytes(number),
                int number => BitConverter.GetBytes(number),
                float number => BitConverter.GetBytes(number),
                _ => throw new ArgumentException($"{name}: {value.GetType()}"),
            };
            raw.CopyTo(bytes.AsSpan(program.Uniforms[name].Offset));
        }
        return bytes;
    }

    internal static Dictionary<string, GpuBuffer> Bind(params (string Name, GpuBuffer Buffer)[] buffers)
    {
        var bound = new Dictionary<string, GpuBuffer>();
        foreach (var (name, buffer) in buffers)
            bound[name] = buffer;
        return bound;
    }
}
