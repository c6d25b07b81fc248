using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Vulkan;

namespace Glint.Host;

/// <summary>One kernel of a ComputeShader: its program on the device, and the buffers set for it.</summary>
internal sealed class ComputeKernel : IDisposable
{
    readonly Func<byte[]> _load;
    readonly Dictionary<int, StructuredBuffer> _set = new();
    readonly Dictionary<string, GpuBuffer> _bound = new();
    (int Id, UniformField Field)[] _uniforms;
    int[] _slotIds;
    VulkanDevice _device;
    ComputeProgram _program;

    internal ComputeKernel(string name, Func<byte[]> load) => (Name, _load) = (name, load);

    internal string Name { get; }

    /// <summary>The program on the present device.</summary>
    internal ComputeProgram Program
    {
        get
        {
            if (_device != GraphicsDevice.Current)
            {
                _device = GraphicsDevice.Current;
                _program = _device.CreateProgram(_load());
                _uniforms =
                    _program.Uniforms.Values.Select(uniform => (PropertyIds.Get(uniform.Name), uniform)).ToArray();
                _slotIds = _program.Slots.Select(slot => PropertyIds.Get(slot.Name)).ToArray();
            }
            return _program;
        }
    }

    internal void Set(int id, StructuredBuffer buffer) => _set[id] = buffer;

    /// <summary>Name of the first buffer of the kernel that is not set or was released; null if it can run.</summary>
    internal string FindMissing()
    {
        var slots = Program.Slots;
        for (int i = 0; i < slots.Count; i++)
            if (!_set.TryGetValue(_slotIds[i], out var buffer) || !buffer.IsValid)
                return slots[i].Name;
        return null;
    }

    internal void Dispatch(string shader, Dictionary<int, byte[]> values, uint x, uint y, uint z)
    {
        var program = Program;
        for (int i = 0; i < program.Slots.Count; i++)
        {
            var buffer = _set[_slotIds[i]];
            CheckStride(shader, program.Slots[i], buffer);
            _bound[program.Slots[i].Name] = buffer.Gpu;
        }
        var uniforms = new byte[program.UniformBytes];
        foreach (var (id, field) in _uniforms)
            if (values.TryGetValue(id, out byte[] value))
                value.AsSpan(0, Math.Min(value.Length, field.Bytes)).CopyTo(uniforms.AsSpan(field.Offset));
        _device.Dispatch(program, uniforms, _bound, x, y, z);
        _bound.Clear();
    }

    public void Dispose()
    {
        _program?.Dispose();
        _program = null;
        _device = null;
    }

    /// <summary>
    /// A wrong stride gives garbage on any device, so it is an error here: it shows a struct with different layouts in
    /// C# and HLSL. (Compilers differ too: glslang aligns float3 to 16 bytes, Direct3D to 4.)
    /// </summary>
    void CheckStride(string shader, BufferSlot slot, StructuredBuffer buffer)
    {
        bool isRaw = buffer.IsRaw && slot.Stride == 4;
        if (slot.Stride != buffer.Stride && !isRaw)
            throw new InvalidOperationException($"Compute shader ({shader}): "
                + $"kernel {Name} reads {slot.Name} as {slot.Element} of {slot.Stride} bytes, "
                + $"the buffer's stride is {buffer.Stride}; lay both structs out in rows of 16 bytes");
    }
}
