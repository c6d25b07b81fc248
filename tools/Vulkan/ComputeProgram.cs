using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Glint.Vulkan;

/// <summary>A kernel compiled for one device, and the resources it needs.</summary>
public sealed unsafe class ComputeProgram : IDisposable
{
    /// <summary>Constant buffers of a kernel that every device takes at moving offsets.</summary>
    const int MaxBlocks = 8;

    /// <summary>Raised, on any thread, before a kernel is compiled that no run before has compiled.</summary>
    public static event Action<DeviceInfo> Compiling;

    readonly VulkanDevice _device;
    readonly Reflection _reflection;
    readonly PipelineCacheFile _cacheFile;
    ulong _module, _setLayout, _layout, _pipeline;

    internal ComputeProgram(VulkanDevice device, ReadOnlySpan<byte> spirv)
    {
        _device = device;
        spirv = SpirvModule.WithImageFormat(spirv);
        _reflection = new Reflection(spirv);
        _cacheFile = CacheFileOf(device, spirv);
        Blocks = _reflection.Blocks;
        Sets = new BoundSets(this);
        Buffers = Slots.Select(slot => slot.Name).ToArray();
        CheckLimits(device.Limits);
        try
        {
            CreateModule(spirv);
            CreateLayout();
        }
        catch
        {
            Destroy();
            throw;
        }
    }

    /// <summary>Whether there is a file with what the driver compiled for a kernel.</summary>
    internal static bool IsStored(VulkanDevice device, ReadOnlySpan<byte> spirv) =>
        CacheFileOf(device, SpirvModule.WithImageFormat(spirv)).Exists;

    static PipelineCacheFile CacheFileOf(VulkanDevice device, ReadOnlySpan<byte> spirv) =>
        new(device.PipelineCacheFolder, device.Physical.PipelineCacheHeader, device.Physical.DriverVersion, spirv);

    /// <summary>The kernel's name.</summary>
    public string Name => _reflection.EntryPoint;

    /// <summary>Names in the HLSL source of the buffers and pictures that it uses. Unused declarations are left out.</summary>
    public IReadOnlyList<string> Buffers { get; }

    /// <summary>The buffers and pictures with their element types and strides, in the order of <see cref="Buffers"/>.</summary>
    public IReadOnlyList<BufferSlot> Slots => _reflection.Buffers;

    /// <summary>Bytes of uniforms of a dispatch.</summary>
    public int UniformBytes => _reflection.UniformBytes;

    /// <summary>Globals and members of constant buffers by name.</summary>
    public IReadOnlyDictionary<string, UniformField> Uniforms => _reflection.Uniforms;

    /// <summary>Threads of a group: the kernel's numthreads.</summary>
    public (uint X, uint Y, uint Z) GroupSize => _reflection.GroupSize;

    /// <summary>The device that it runs on.</summary>
    public VulkanDevice Device => _device;

    /// <summary>Constant buffers in the order of their bindings.</summary>
    internal UniformBlock[] Blocks { get; }

    internal BoundSets Sets { get; }
    internal ulong SetLayout => _setLayout;
    internal ulong Layout => _layout;

    /// <summary>
    /// Made when first used: a driver takes tens of milliseconds to compile a large kernel, and few runs use all.
    /// </summary>
    internal ulong Pipeline
    {
        get
        {
            if (_module == 0)
                throw new ObjectDisposedException(nameof(ComputeProgram), $"kernel {Name} was disposed");
            if (_pipeline == 0)
                _pipeline = _device.Pipelines.GetOrAdd(_cacheFile.Name, _ => new Lazy<ulong>(CreatePipeline)).Value;
            return _pipeline;
        }
    }

    /// <summary>Batch of the last recorded dispatch of this kernel.</summary>
    internal long LastBatch { get; set; }

    public void Dispose()
    {
        if (_module == 0)
            return;
        try
        {
            _device.FinishIfAlive(LastBatch);
        }
        finally
        {
            _device.Forget(this);
            Destroy();
        }
    }

    internal void Destroy()
    {
        if (_device.IsAbandoned)
            return;
        Sets.Destroy();
        Native.vkDestroyPipelineLayout(_device.Handle, _layout, null);
        Native.vkDestroyDescriptorSetLayout(_device.Handle, _setLayout, null);
        Native.vkDestroyShaderModule(_device.Handle, _module, null);
        _pipeline = _layout = _setLayout = _module = 0;
    }

    void CheckLimits(DeviceLimits limits)
    {
        int buffers = Slots.Count(slot => !slot.IsImage);
        if (buffers > limits.MaxStorageBuffersPerStage)
            throw new VulkanException($"kernel {Name} uses {buffers} buffers, "
                + $"{_device.Info.Name} takes {limits.MaxStorageBuffersPerStage}");
        if (Blocks.FirstOrDefault(block => block.Bytes > limits.MaxUniformBufferRange) is { Bytes: > 0 } large)
            throw new VulkanException($"kernel {Name} has {large.Bytes:N0} bytes of uniforms in one block, "
                + $"{_device.Info.Name} takes {limits.MaxUniformBufferRange:N0}");
        if (UniformBytes > CommandRecorder.UniformBytes)
            throw new VulkanException($"kernel {Name} has {UniformBytes:N0} bytes of uniforms in all, "
                + $"at most {CommandRecorder.UniformBytes:N0} are supported");
        if (Blocks.Length > MaxBlocks)
            throw new VulkanException($"kernel {Name} has {Blocks.Length} constant buffers, at most {MaxBlocks} are "
                + "supported; put their members into one");
        var (x, y, z) = GroupSize;
        if (x > limits.MaxGroupSizeX || y > limits.MaxGroupSizeY || z > limits.MaxGroupSizeZ
            || (ulong)x * y * z > limits.MaxGroupInvocations)
            throw new VulkanException($"kernel {Name} has groups of {x} x {y} x {z} threads, "
                + $"{_device.Info.Name} takes {limits.MaxGroupInvocations} in all");
    }

    void CreateModule(ReadOnlySpan<byte> spirv)
    {
        fixed (byte* code = spirv)
        {
            var info = new ShaderModuleCreateInfo
            {
                SType = StructureType.ShaderModuleCreateInfo, CodeBytes = (nuint)spirv.Length, Code = (uint*)code
            };
            VulkanException.Check(Native.vkCreateShaderModule(_device.Handle, &info, null, out _module),
                $"load kernel {Name}");
        }
    }

    void CreateLayout()
    {
        var bindings = Slots.Select(slot => (slot.Binding, Type: slot.DescriptorType))
            .Concat(Blocks.Select(block => (block.Binding, Type: Native.DynamicUniformBuffer)))
            .Select(binding => new DescriptorSetLayoutBinding
            {
                Binding = binding.Binding, Type = binding.Type, Count = 1, Stages = Native.ComputeShader
            })
            .ToArray();
        fixed (DescriptorSetLayoutBinding* data = bindings)
        {
            var info = new DescriptorSetLayoutCreateInfo
            {
                SType = StructureType.DescriptorSetLayoutCreateInfo,
                BindingCount = (uint)bindings.Length, Bindings = data
            };
            VulkanException.Check(Native.vkCreateDescriptorSetLayout(_device.Handle, &info, null, out _setLayout),
                $"lay out the buffers of kernel {Name}");
        }
        ulong set = _setLayout;
        var layout = new PipelineLayoutCreateInfo
        {
            SType = StructureType.PipelineLayoutCreateInfo, SetLayoutCount = 1, SetLayouts = &set
        };
        VulkanException.Check(Native.vkCreatePipelineLayout(_device.Handle, &layout, null, out _layout),
            $"lay out the buffers of kernel {Name}");
    }

    ulong CreatePipeline()
    {
        fixed (byte* name = Encoding.UTF8.GetBytes(Name + '\0'))
        {
            var info = new ComputePipelineCreateInfo
            {
                SType = StructureType.ComputePipelineCreateInfo,
                Stage = new PipelineShaderStageCreateInfo
                {
                    SType = StructureType.PipelineShaderStageCreateInfo,
                    Stage = Native.ComputeShader, Module = _module, Name = name,
                },
                Layout = _layout,
            };
            ulong cache = CreateCache();
            try
            {
                bool isKnown = _cacheFile.IsKnown;
                if (!isKnown)
                    Compiling?.Invoke(_device.Info);
                VulkanException.Check(
                    Native.vkCreateComputePipelines(_device.Handle, cache, 1, &info, null, out ulong pipeline),
                    $"compile kernel {Name} on {_device.Info.Name}");
                if (cache != 0)
                    SaveCache(cache);
                if (!isKnown)
                    _cacheFile.Mark();
                return pipeline;
            }
            finally
            {
                Native.vkDestroyPipelineCache(_device.Handle, cache, null);
            }
        }
    }

    // 0 if the driver makes none: the kernel is then compiled.
    ulong CreateCache()
    {
        var loaded = _cacheFile.Load();
        fixed (byte* data = loaded)
        {
            var info = new PipelineCacheCreateInfo
            {
                SType = StructureType.PipelineCacheCreateInfo, DataBytes = (nuint)loaded.Length, Data = data
            };
            return Native.vkCreatePipelineCache(_device.Handle, &info, null, out ulong cache) < 0 ? 0 : cache;
        }
    }

    void SaveCache(ulong cache)
    {
        nuint bytes = 0;
        if (Native.vkGetPipelineCacheData(_device.Handle, cache, ref bytes, null) < 0)
            return;
        var data = new byte[bytes];
        fixed (byte* start = data)
            if (Native.vkGetPipelineCacheData(_device.Handle, cache, ref bytes, start) == 0)
                _cacheFile.Save(data.AsSpan(0, (int)bytes));
    }
}
