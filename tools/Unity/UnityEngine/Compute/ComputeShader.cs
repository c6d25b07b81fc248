using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;
using Glint.Vulkan;

namespace UnityEngine;

public sealed partial class ComputeShader : Object
{
    const int MaxGroups = 65535; // Direct3D 11's, and the least that Vulkan guarantees

    readonly ComputeKernel[] _kernels;

    /// <summary>The kernels of a .compute file as compiled with this program; each is loaded on first use.</summary>
    /// <param name="projectRoot">Folder with the same source files as when compiled.</param>
    /// <param name="computePath">Path of the .compute file relative to it.</param>
    internal ComputeShader(string name, string projectRoot, string computePath, IReadOnlyList<string> kernels)
    {
        this.name = name;
        _kernels = kernels.Select(
            kernel => new ComputeKernel(kernel, () => ShaderLibrary.Load(projectRoot, computePath, kernel))).ToArray();
    }

    public int FindKernel(string name)
    {
        int index = IndexOf(name);
        return index >= 0 ? index : throw new ArgumentException($"Kernel '{name}' not found.");
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
        else if (kernel.FindMissing() is { } missing)
            Debug.LogError(
                $"Compute shader ({Name}): Property ({missing}) at kernel index ({kernelIndex}) is not set", this);
        else
            kernel.Dispatch(Name, _values, (uint)threadGroupsX, (uint)threadGroupsY, (uint)threadGroupsZ);
    }

    internal override void OnDestroyed()
    {
        foreach (var kernel in _kernels)
            kernel.Dispose();
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
