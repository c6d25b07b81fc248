using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Glint.Vulkan;
using UnityEngine;

namespace Glint.Host;

/// <summary>One kernel of a ComputeShader: its program on the device, and the buffers set for it.</summary>
internal sealed class ComputeKernel : IDisposable
{
    readonly Func<byte[]> _load;
    readonly Func<IReadOnlyCollection<string>> _loadByteAddressBuffers;
    readonly Dictionary<int, StructuredBuffer> _set = new();
    readonly Dictionary<int, RenderTexture> _textures = new();
    Slot[] _slots;
    GpuResource[] _bound;
    Uniform[] _uniforms;
    byte[] _uniformBytes;
    VulkanDevice _device;
    ComputeProgram _program;
    Task<ComputeProgram> _begun;

    internal ComputeKernel(string name, Func<byte[]> load, Func<IReadOnlyCollection<string>> loadByteAddressBuffers) =>
        (Name, _load, _loadByteAddressBuffers) = (name, load, loadByteAddressBuffers);

    internal string Name { get; }

    /// <summary>Begins to make the program on another thread, if a device is open and has its code stored.</summary>
    internal void Begin()
    {
        if (_begun == null && _device == null && GraphicsDevice.IfOpen is VulkanDevice device)
            _begun = device.BeginStoredProgram(_load);
    }

    /// <summary>The program on the present device.</summary>
    internal ComputeProgram Program
    {
        get
        {
            if (_device != GraphicsDevice.Current)
            {
                _device = GraphicsDevice.Current;
                _program = Begun() ?? _device.CreateProgram(_load());
                _uniforms = _program.Uniforms.Values
                    .Select(uniform => new Uniform { Id = PropertyIds.Get(uniform.Name), Field = uniform }).ToArray();
                _uniformBytes = new byte[_program.UniformBytes];
                var byteAddressBuffers = _loadByteAddressBuffers();
                _slots = _program.Slots
                    .Select(slot => new Slot(PropertyIds.Get(slot.Name), slot, byteAddressBuffers.Contains(slot.Name)))
                    .ToArray();
                _bound = new GpuResource[_slots.Length];
            }
            return _program;
        }
    }

    // What was begun for this device.
    ComputeProgram Begun()
    {
        var begun = _begun?.GetAwaiter().GetResult();
        _begun = null;
        return begun?.Device == _device ? begun : null;
    }

    internal void Set(int id, StructuredBuffer buffer) => _set[id] = buffer;

    internal void Set(int id, RenderTexture texture) => _textures[id] = texture;

    /// <summary>
    /// Takes the buffers and textures that are set and the values of the uniforms, for the next dispatch. Returns the
    /// name of the first that is not set or was released; null if the kernel can run.
    /// </summary>
    internal string Bind(string shader, Dictionary<int, UniformValue> values)
    {
        _ = Program;
        for (int i = 0; i < _slots.Length; i++)
        {
            if (_slots[i].Buffer.IsImage)
            {
                if (!_textures.TryGetValue(_slots[i].Id, out var texture) || !texture.IsCreated())
                    return _slots[i].Buffer.Name;
                _bound[i] = texture.Image;
                continue;
            }
            if (!_set.TryGetValue(_slots[i].Id, out var buffer) || !buffer.IsValid)
                return _slots[i].Buffer.Name;
            CheckUse(shader, _slots[i], buffer);
            _bound[i] = buffer.Gpu;
        }
        for (int i = 0; i < _uniforms.Length; i++)
            _uniforms[i].Update(values, _uniformBytes);
        return null;
    }

    internal void Dispatch(uint x, uint y, uint z) => _device.Dispatch(_program, _uniformBytes, _bound, x, y, z);

    internal void DispatchIndirect(GpuBuffer arguments, long offset) =>
        _device.DispatchIndirect(_program, _uniformBytes, _bound, arguments, offset);

    public void Dispose()
    {
        _program?.Dispose();
        _program = null;
        _device = null;
    }

    /// <summary>
    /// Refuses a buffer of another kind. A wrong stride gives garbage on any device, so it is an error here: it shows a
    /// struct with different layouts in C# and HLSL. (Compilers differ too: glslang aligns float3 to 16 bytes, Direct3D
    /// to 4.)
    /// </summary>
    void CheckUse(string shader, in Slot slot, StructuredBuffer buffer)
    {
        if (slot.IsByteAddress ? !buffer.Uses.Raw : !buffer.Uses.Structured)
            throw new InvalidOperationException($"Compute shader ({shader}): kernel {Name} declares {slot.Buffer.Name} "
                + (slot.IsByteAddress
                    ? "as a byte address buffer, the buffer was made without Raw; add Raw to its targets"
                    : "as a structured buffer, the buffer was made without Structured; declare a ByteAddressBuffer "
                        + "or make it Structured"));
        if (!slot.IsByteAddress && slot.Buffer.Stride != buffer.Stride)
            throw new InvalidOperationException($"Compute shader ({shader}): "
                + $"kernel {Name} reads {slot.Buffer.Name} as {slot.Buffer.Element} of {slot.Buffer.Stride} bytes, "
                + $"the buffer's stride is {buffer.Stride}; lay both structs out in rows of 16 bytes");
    }

    readonly record struct Slot(int Id, BufferSlot Buffer, bool IsByteAddress);

    struct Uniform
    {
        internal int Id;
        internal UniformField Field;
        UniformValue _value;
        int _version;

        /// <summary>Copies the value to its place in the bytes of a dispatch, if it was set since.</summary>
        internal void Update(Dictionary<int, UniformValue> values, byte[] bytes)
        {
            if (_value == null && !values.TryGetValue(Id, out _value) || _version == _value.Version)
                return;
            _value.Bytes.AsSpan(0, Math.Min(_value.Bytes.Length, Field.Bytes)).CopyTo(bytes.AsSpan(Field.Offset));
            _version = _value.Version;
        }
    }
}
