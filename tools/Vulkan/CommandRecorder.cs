using System;
using System.Collections.Generic;

namespace Glint.Vulkan;

/// <summary>
/// Commands that are recorded but not yet run, in order, with a full memory barrier before each. They run as one batch
/// when the host waits, or when the batch has <see cref="MaxDispatches"/> dispatches. That is enough to hide the cost
/// of a submission, and few enough that a batch of short dispatches stays well below a GPU's watchdog limit.
/// </summary>
sealed unsafe class CommandRecorder : IDisposable
{
    internal const int MaxDispatches = 16;
    internal const int UniformRingBytes = 256 << 10;
    const long StagingBytes = 16 << 20;
    const uint PoolStorageBuffers = 1024, PoolUniformBuffers = 64;
    const int ComputeBindPoint = 1;

    /// <summary>Time after which a dispatch is considered to hang.</summary>
    static readonly TimeSpan Patience = TimeSpan.FromMinutes(10);

    readonly VulkanDevice _device;
    readonly nint _queue;
    readonly List<GpuBuffer> _uploadTargets = []; // targets of the uploads since the last barrier
    ulong _commandPool, _descriptorPool, _fence;
    nint _commands;
    Allocation _staging, _uniformRing;
    long _stagingUsed, _uniformsUsed;
    int _dispatches;
    bool _recording;

    /// <summary>
    /// Number of the last batch before the device counts as lost. For tests, since no driver loses its device on
    /// request.
    /// </summary>
    internal long LastBatch { get; set; } = long.MaxValue;

    /// <summary>Number of the batch being recorded. All batches with smaller numbers have run.</summary>
    internal long Batch { get; private set; } = 1;

    internal CommandRecorder(VulkanDevice device, nint queue, uint queueFamily)
    {
        _device = device;
        _queue = queue;
        // Flag 2: command buffers can be reset.
        var poolInfo = new CommandPoolCreateInfo
        {
            SType = StructureType.CommandPoolCreateInfo, Flags = 2, QueueFamily = queueFamily
        };
        VulkanException.Check(Native.vkCreateCommandPool(device.Handle, &poolInfo, null, out _commandPool),
            "make a command pool");
        var bufferInfo = new CommandBufferAllocateInfo
        {
            SType = StructureType.CommandBufferAllocateInfo, Pool = _commandPool, Count = 1
        };
        VulkanException.Check(Native.vkAllocateCommandBuffers(device.Handle, &bufferInfo, out _commands),
            "make a command buffer");
        var fenceInfo = new FenceCreateInfo { SType = StructureType.FenceCreateInfo };
        VulkanException.Check(Native.vkCreateFence(device.Handle, &fenceInfo, null, out _fence), "make a fence");
        var sizes = stackalloc DescriptorPoolSize[]
        {
            new() { Type = Native.StorageBuffer, Count = PoolStorageBuffers },
            new() { Type = Native.UniformBuffer, Count = PoolUniformBuffers },
        };
        var descriptorInfo = new DescriptorPoolCreateInfo
        {
            SType = StructureType.DescriptorPoolCreateInfo, MaxSets = MaxDispatches, SizeCount = 2, Sizes = sizes
        };
        VulkanException.Check(Native.vkCreateDescriptorPool(device.Handle, &descriptorInfo, null, out _descriptorPool),
            "make a descriptor pool");
    }

    internal void Dispatch(ComputeProgram program, ReadOnlySpan<byte> uniforms,
        ReadOnlySpan<GpuBuffer> buffers, GroupCounts groups)
    {
        if (program.UniformBytes > UniformRingBytes - _uniformsUsed)
            Flush();
        ulong set = AllocateSet(program);
        WriteSet(program, set, uniforms, buffers);

        Begin();
        Native.vkCmdBindPipeline(_commands, ComputeBindPoint, program.Pipeline);
        Native.vkCmdBindDescriptorSets(_commands, ComputeBindPoint, program.Layout, 0, 1, in set, 0, null);
        _device.Clock.Stamp(_commands);
        groups.Dispatch(_commands);
        _device.Clock.Stamp(_commands);
        program.LastBatch = Batch;
        foreach (var buffer in buffers)
            buffer.LastBatch = Batch;
        if (groups.Buffer != null)
            groups.Buffer.LastBatch = Batch;
        if (++_dispatches == MaxDispatches)
            Flush();
    }

    internal void Fill(ulong buffer)
    {
        Begin();
        Native.vkCmdFillBuffer(_commands, buffer, 0, ulong.MaxValue, 0);
    }

    internal void Upload(ReadOnlySpan<byte> data, GpuBuffer target, long offset)
    {
        while (data.Length > 0)
        {
            var piece = Stage(data.Length, out long at);
            data[..piece.Length].CopyTo(piece);
            BeginUpload(target);
            Copy(_staging.Buffer, at, target.Handle, offset, piece.Length);
            target.LastBatch = Batch;
            data = data[piece.Length..];
            offset += piece.Length;
        }
    }

    internal void Download(GpuBuffer source, long offset, Span<byte> data)
    {
        while (data.Length > 0)
        {
            var piece = Stage(data.Length, out long at);
            Begin();
            Copy(source.Handle, offset, _staging.Buffer, at, piece.Length);
            Flush();
            piece.CopyTo(data);
            data = data[piece.Length..];
            offset += piece.Length;
        }
    }

    /// <summary>Runs the recorded commands and waits for their end.</summary>
    internal void Flush()
    {
        if (!_recording)
            return;
        int dispatches = _dispatches;
        _recording = false;
        _dispatches = 0;
        _uploadTargets.Clear();
        Barrier();
        VulkanException.Check(Native.vkEndCommandBuffer(_commands), "record commands");
        nint commands = _commands;
        var submit =
            new SubmitInfo { SType = StructureType.SubmitInfo, CommandBufferCount = 1, CommandBuffers = &commands };
        string run = $"run {dispatches} dispatches on {_device.Info.Name}";
        VulkanException.Check(
            Batch > LastBatch ? Native.DeviceLost : Native.vkQueueSubmit(_queue, 1, &submit, _fence), run);

        var patience = Patience * Math.Max(1, dispatches);
        int result = Native.vkWaitForFences(_device.Handle, 1, in _fence, 1, (ulong)patience.Ticks * 100);
        if (result == Native.Timeout)
        {
            _device.Abandon();
            throw new VulkanException($"could not {run}: no answer in {patience.TotalMinutes:0} minutes; "
                + "use smaller dispatches or another device");
        }
        VulkanException.Check(result, run);
        VulkanException.Check(Native.vkResetFences(_device.Handle, 1, in _fence), run);
        VulkanException.Check(Native.vkResetDescriptorPool(_device.Handle, _descriptorPool, 0), run);
        _device.Clock.EndBatch();
        Batch++;
        _stagingUsed = _uniformsUsed = 0;
    }

    void Begin()
    {
        _uploadTargets.Clear();
        if (_recording)
        {
            Barrier();
            return;
        }
        // Flag 1: each recording is submitted once.
        var info = new CommandBufferBeginInfo { SType = StructureType.CommandBufferBeginInfo, Flags = 1 };
        VulkanException.Check(Native.vkBeginCommandBuffer(_commands, &info), "record commands");
        _recording = true;
        _device.Clock.BeginBatch(_commands);
    }

    /// <summary>Consecutive uploads to different buffers need no barrier between them.</summary>
    void BeginUpload(GpuBuffer target)
    {
        if (_uploadTargets.Count == 0 || _uploadTargets.Contains(target))
            Begin();
        _uploadTargets.Add(target);
    }

    void Barrier()
    {
        var barrier = new MemoryBarrier
        {
            SType = StructureType.MemoryBarrier, From = Native.MemoryWrite, To = Native.MemoryRead | Native.MemoryWrite
        };
        const uint Stages = Native.ComputeStage | Native.TransferStage | Native.IndirectStage;
        Native.vkCmdPipelineBarrier(_commands, Stages, Stages | Native.HostStage, 0, 1, &barrier, 0, null, 0, null);
    }

    void Copy(ulong from, long fromOffset, ulong to, long toOffset, long bytes)
    {
        var copy = new BufferCopy { From = (ulong)fromOffset, To = (ulong)toOffset, Bytes = (ulong)bytes };
        Native.vkCmdCopyBuffer(_commands, from, to, 1, &copy);
    }

    /// <summary>Next free part of the staging buffer, up to <paramref name="bytes"/> long.</summary>
    Span<byte> Stage(int bytes, out long at)
    {
        _staging ??= Allocation.ForHost(_device, StagingBytes, Native.TransferSource | Native.TransferTarget);
        if (_stagingUsed == StagingBytes)
            Flush();
        at = _stagingUsed;
        int piece = (int)Math.Min(bytes, StagingBytes - at);
        _stagingUsed = Math.Min(StagingBytes, (at + piece + 15) / 16 * 16);
        return new Span<byte>(_staging.Mapped + at, piece);
    }

    ulong AllocateSet(ComputeProgram program)
    {
        ulong layout = program.SetLayout;
        var info = new DescriptorSetAllocateInfo
        {
            SType = StructureType.DescriptorSetAllocateInfo, Pool = _descriptorPool, Count = 1, Layouts = &layout
        };
        int result = Native.vkAllocateDescriptorSets(_device.Handle, &info, out ulong set);
        if (result is Native.OutOfPoolMemory or Native.FragmentedPool && _recording)
        {
            Flush();
            result = Native.vkAllocateDescriptorSets(_device.Handle, &info, out set);
        }
        VulkanException.Check(result, $"bind {program.Slots.Count} buffers to kernel {program.Name}");
        return set;
    }

    void WriteSet(ComputeProgram program, ulong set, ReadOnlySpan<byte> uniforms, ReadOnlySpan<GpuBuffer> buffers)
    {
        var blocks = program.Blocks;
        int count = buffers.Length + blocks.Count;
        if (count == 0)
            return;
        var targets = stackalloc DescriptorBufferInfo[count];
        var writes = stackalloc WriteDescriptorSet[count];
        for (int i = 0; i < count; i++)
        {
            bool isBuffer = i < buffers.Length;
            targets[i] = isBuffer
                ? new DescriptorBufferInfo { Buffer = buffers[i].Handle, Range = (ulong)buffers[i].Bytes }
                : PlaceUniforms(blocks[i - buffers.Length], uniforms);
            writes[i] = new WriteDescriptorSet
            {
                SType = StructureType.WriteDescriptorSet,
                Set = set,
                Binding = isBuffer ? program.Slots[i].Binding : blocks[i - buffers.Length].Binding,
                Count = 1,
                Type = isBuffer ? Native.StorageBuffer : Native.UniformBuffer,
                Buffer = targets + i,
            };
        }
        Native.vkUpdateDescriptorSets(_device.Handle, (uint)count, writes, 0, null);
    }

    DescriptorBufferInfo PlaceUniforms(UniformBlock block, ReadOnlySpan<byte> uniforms)
    {
        _uniformRing ??= Allocation.ForHost(_device, UniformRingBytes, Native.UniformUsage);
        long at = _uniformsUsed;
        uniforms.Slice(block.Start, block.Bytes).CopyTo(new Span<byte>(_uniformRing.Mapped + at, block.Bytes));
        _uniformsUsed =
            (at + block.Bytes + Reflection.BlockAlignment - 1) / Reflection.BlockAlignment * Reflection.BlockAlignment;
        return new DescriptorBufferInfo
        {
            Buffer = _uniformRing.Buffer, Offset = (ulong)at, Range = (ulong)block.Bytes
        };
    }

    public void Dispose()
    {
        _uniformRing?.Dispose();
        _staging?.Dispose();
        Native.vkDestroyDescriptorPool(_device.Handle, _descriptorPool, null);
        Native.vkDestroyFence(_device.Handle, _fence, null);
        Native.vkDestroyCommandPool(_device.Handle, _commandPool, null);
    }
}
