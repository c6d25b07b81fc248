using System;
using System.Collections.Generic;

namespace Glint.Vulkan;

/// <summary>
/// Descriptor sets of a kernel, each with the buffers that it names. A dispatch with the buffers of an earlier one uses
/// its set again; uniforms differ by their offsets only.
/// </summary>
sealed unsafe class BoundSets
{
    /// <summary>Sets of a pool, and the number of sets up to which unknown buffers get a set of their own.</summary>
    const int PoolSets = 8;

    readonly ComputeProgram _program;
    readonly List<ulong> _pools = [];
    readonly List<BoundSet> _sets = [];

    internal BoundSets(ComputeProgram program) => _program = program;

    /// <summary>The set with these buffers, for a dispatch of <paramref name="batch"/>.</summary>
    internal ulong Get(ReadOnlySpan<GpuResource> buffers, ulong uniforms, long batch)
    {
        BoundSet oldest = null;
        foreach (var set in _sets)
        {
            if (buffers.SequenceEqual(set.Buffers))
            {
                set.LastBatch = batch;
                return set.Handle;
            }
            if (oldest == null || set.LastBatch < oldest.LastBatch)
                oldest = set;
        }
        bool canReuse = _sets.Count >= PoolSets && _program.Device.Recorder.HasRun(oldest.LastBatch);
        var unused = canReuse ? oldest : Allocate();
        buffers.CopyTo(unused.Buffers);
        unused.LastBatch = batch;
        Write(unused, uniforms);
        return unused.Handle;
    }

    internal void Destroy()
    {
        foreach (ulong pool in _pools)
            Native.vkDestroyDescriptorPool(_program.Device.Handle, pool, null);
        _pools.Clear();
        _sets.Clear();
    }

    BoundSet Allocate()
    {
        string bind = $"bind {_program.Slots.Count} buffers to kernel {_program.Name}";
        if (_sets.Count == _pools.Count * PoolSets)
            AddPool(bind);
        ulong layout = _program.SetLayout;
        var info = new DescriptorSetAllocateInfo
        {
            SType = StructureType.DescriptorSetAllocateInfo, Pool = _pools[^1], Count = 1, Layouts = &layout
        };
        VulkanException.Check(Native.vkAllocateDescriptorSets(_program.Device.Handle, &info, out ulong handle), bind);
        var set = new BoundSet(handle, new GpuResource[_program.Slots.Count]);
        _sets.Add(set);
        return set;
    }

    void AddPool(string bind)
    {
        // Vulkan has no pool of 0 descriptors.
        var sizes = stackalloc DescriptorPoolSize[]
        {
            new() { Type = Native.StorageBuffer, Count = (uint)Math.Max(1, PoolSets * _program.Slots.Count) },
            new() { Type = Native.StorageImage, Count = (uint)Math.Max(1, PoolSets * _program.Slots.Count) },
            new() { Type = Native.DynamicUniformBuffer, Count = (uint)Math.Max(1, PoolSets * _program.Blocks.Length) },
        };
        var info = new DescriptorPoolCreateInfo
        {
            SType = StructureType.DescriptorPoolCreateInfo, MaxSets = PoolSets, SizeCount = 3, Sizes = sizes
        };
        VulkanException.Check(
            Native.vkCreateDescriptorPool(_program.Device.Handle, &info, null, out ulong pool), bind);
        _pools.Add(pool);
    }

    void Write(BoundSet set, ulong uniforms)
    {
        var (slots, blocks) = (_program.Slots, _program.Blocks);
        int count = slots.Count + blocks.Length;
        if (count == 0)
            return;
        var targets = stackalloc DescriptorBufferInfo[count];
        var images = stackalloc DescriptorImageInfo[count];
        var writes = stackalloc WriteDescriptorSet[count];
        for (int i = 0; i < count; i++)
        {
            int block = i - slots.Count;
            bool isSlot = block < 0;
            var resource = isSlot ? set.Buffers[i] : null;
            if (resource is GpuImage image)
                images[i] = new DescriptorImageInfo { View = image.View, Layout = Native.GeneralLayout };
            else
                targets[i] = resource is GpuBuffer buffer
                    ? new DescriptorBufferInfo { Buffer = buffer.Handle, Range = (ulong)buffer.Bytes }
                    : new DescriptorBufferInfo { Buffer = uniforms, Range = (ulong)blocks[block].Bytes };
            writes[i] = new WriteDescriptorSet
            {
                SType = StructureType.WriteDescriptorSet,
                Set = set.Handle,
                Binding = isSlot ? slots[i].Binding : blocks[block].Binding,
                Count = 1,
                Type = isSlot ? slots[i].DescriptorType : Native.DynamicUniformBuffer,
                Image = images + i,
                Buffer = targets + i,
            };
        }
        Native.vkUpdateDescriptorSets(_program.Device.Handle, (uint)count, writes, 0, null);
    }

    sealed class BoundSet(ulong handle, GpuResource[] buffers)
    {
        internal ulong Handle => handle;
        internal GpuResource[] Buffers => buffers;

        /// <summary>Batch of the last dispatch with this set.</summary>
        internal long LastBatch { get; set; }
    }
}
