using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;
using Glint.Vulkan;

namespace UnityEngine;

public sealed partial class ComputeShader : Object
{
    const int MaxGroups = 65535; // Direct3D 11's, and the least that Vulkan guarantees
    const int GroupCountBytes = 12; // three uint: groups along x, y and z

    readonly ComputeKernel[] _kernels;

    /// <summary>The kernels of a .compute file as compiled with this program; each is loaded on first use.</summary>
    /// <param name="projectRoot">Folder with the same source files as when compiled.</param>
    /// <param name="computePath">Path of the .compute file relative to it.</param>
    internal ComputeShader(string name, string projectRoot, string computePath, IReadOnlyList<string> kernels)
    {
        this.name = name;
        // Once for all kernels, on the thread that loads the first.
        var sources = new Lazy<string>(() =>
        {
            ShaderLibrary.RequireSources(projectRoot, computePath);
            return computePath;
        });
        _kernels = kernels.Select(kernel => new ComputeKernel(kernel, () => ShaderLibrary.Load(sources.Value, kernel),
            () => ShaderLibrary.ByteAddressBuffers(computePath, kernel))).ToArray();
    }

    /// <summary>The kernel's index. One whose compiled code is stored is made meanwhile, on another thread.</summary>
    public int FindKernel(string name)
    {
        int index = IndexOf(name);
        if (index < 0)
            throw new ArgumentException($"Kernel '{name}' not found.");
        _kernels[index].Begin();
        return index;
    }

    public bool HasKernel(string name) => IndexOf(name) >= 0;

    /// <summary>False without a graphics device; other obstacles throw an exception with the reason.</summary>
    public bool IsSupported(int kernelIndex) => !GraphicsDevice.IsNull && Kernel(kernelIndex).Program != null;

    public void GetKernelThreadGroupSizes(int kernelIndex, out uint x, out uint y, out uint z) =>
        (x, y, z) = Kernel(kernelIndex).Program.GroupSize;

    public void SetBuffer(int kernelIndex, string name, ComputeBuffer buffer) =>
        SetBuffer(kernelIndex, Shader.PropertyToID(name), buffer);

    public void SetBuffer(int kernelIndex, string name, GraphicsBuffer buffer) =>
        SetBuffer(kernelIndex, Shader.PropertyToID(name), buffer);

    public void SetBuffer(int kernelIndex, int nameID, ComputeBuffer buffer) =>
        Kernel(kernelIndex).Set(nameID, (buffer ?? throw new ArgumentNullException(nameof(buffer))).Elements);

    public void SetBuffer(int kernelIndex, int nameID, GraphicsBuffer buffer) =>
        Kernel(kernelIndex).Set(nameID, (buffer ?? throw new ArgumentNullException(nameof(buffer))).Elements);

    public void SetTexture(int kernelIndex, string name, Texture texture) =>
        SetTexture(kernelIndex, Shader.PropertyToID(name), texture);

    /// <summary>Sets an RWTexture2D: a RenderTexture with random write.</summary>
    public void SetTexture(int kernelIndex, int nameID, Texture texture)
    {
        if (texture is not RenderTexture { enableRandomWrite: true } writable)
            throw new ArgumentException(texture == null ? "the texture is null" : $"the texture ({texture.name}) is no "
                + "RenderTexture with enableRandomWrite: the host has no other in kernels", nameof(texture));
        Kernel(kernelIndex).Set(nameID, writable);
    }

    public void Dispatch(int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ)
    {
        var kernel = Kernel(kernelIndex);
        int least = Math.Min(threadGroupsX, Math.Min(threadGroupsY, threadGroupsZ));
        int most = Math.Max(threadGroupsX, Math.Max(threadGroupsY, threadGroupsZ));
        if (least <= 0)
            Debug.LogError("Thread group count must be above zero", this);
        else if (most > MaxGroups)
            Debug.LogError("Thread group count is above the maximum allowed limit. "
                + $"Maximum allowed thread group count is {MaxGroups}", this);
        else if (Bind(kernelIndex))
            kernel.Dispatch((uint)threadGroupsX, (uint)threadGroupsY, (uint)threadGroupsZ);
    }

    public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer) =>
        DispatchIndirect(kernelIndex, argsBuffer, 0);

    public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer, uint argsOffset) =>
        DispatchIndirect(kernelIndex, argsBuffer?.Elements, argsOffset);

    public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer) =>
        DispatchIndirect(kernelIndex, argsBuffer, 0);

    public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer, uint argsOffset) =>
        DispatchIndirect(kernelIndex, argsBuffer?.Elements, argsOffset);

    internal override void OnDestroyed()
    {
        foreach (var kernel in _kernels)
            kernel.Dispose();
    }

    void DispatchIndirect(int kernelIndex, StructuredBuffer argsBuffer, uint argsOffset)
    {
        var kernel = Kernel(kernelIndex);
        if (argsBuffer == null)
            throw new ArgumentNullException(nameof(argsBuffer));
        if (!SystemInfo.supportsIndirectArgumentsBuffer)
            throw new NotSupportedException("this device has no DispatchIndirect "
                + "(SystemInfo.supportsIndirectArgumentsBuffer); use Dispatch");
        string What() => $"Compute shader ({Name}): the argument buffer of kernel {kernel.Name}";
        if (!argsBuffer.Uses.Arguments)
            throw new ArgumentException($"{What()} was made without IndirectArguments; make it with "
                + "IndirectArguments | Raw", nameof(argsBuffer));
        if (argsOffset % 4 != 0 || (long)argsOffset + GroupCountBytes > argsBuffer.Bytes)
            throw new ArgumentException($"{What()} has {argsBuffer.Bytes:N0} bytes; an offset into it is a multiple "
                + $"of 4 with {GroupCountBytes} bytes after it, not {argsOffset:N0}", nameof(argsOffset));
        if (Bind(kernelIndex))
            kernel.DispatchIndirect(argsBuffer.Gpu, argsOffset);
    }

    /// <summary>Gives a kernel its buffers and uniforms. Logs a buffer that is not set and returns false.</summary>
    bool Bind(int kernelIndex)
    {
        string missing = _kernels[kernelIndex].Bind(Name, _values);
        if (missing != null)
            Debug.LogError(
                $"Compute shader ({Name}): Property ({missing}) at kernel index ({kernelIndex}) is not set", this);
        return missing == null;
    }

    int IndexOf(string kernel)
    {
        EnsureAlive();
        return Array.FindIndex(_kernels, candidate => candidate.Name == kernel);
    }

    ComputeKernel Kernel(int index)
    {
        EnsureAlive();
        if (index < 0 || index >= _kernels.Length)
            throw new IndexOutOfRangeException($"Invalid kernelIndex ({index}) passed, "
                + $"must be non-negative less than {_kernels.Length}.");
        return _kernels[index];
    }
}
