using System;
using System.Collections.Generic;

namespace Glint.Vulkan;

/// <summary>
/// Records commands, in order, with a full memory barrier before each, and submits them in batches. A batch is
/// submitted when the host reads or waits, or when it has <see cref="MaxDispatches"/> dispatches. That is enough to
/// hide the cost of a submission, and few enough that a batch of short dispatches stays well below a GPU's watchdog
/// limit. Up to <see cref="Batches"/> batches are in flight: the host waits only for data, or for the oldest of them.
/// </summary>
sealed unsafe class CommandRecorder : IDisposable
{
    internal const int Batches = 4;
    internal const int MaxDispatches = 16;
    internal const int UniformBytes = 256 << 10; // of a batch
    const long StagingBytes = 4 << 20; // of a batch
    const int ComputeBindPoint = 1;

    /// <summary>Time after which a dispatch is considered to hang.</summary>
    static readonly TimeSpan Patience = TimeSpan.FromMinutes(10);

    readonly VulkanDevice _device;
    readonly nint _queue;
    readonly CommandBatch[] _ring = new CommandBatch[Batches];
    readonly List<GpuBuffer> _uploadTargets = []; // targets of the uploads since the last barrier
    ulong _commandPool;
    Allocation _staging, _uniforms;
    long _lastRun; // number of the last batch known to have run
    bool _recording;

    /// <summary>
    /// Number of the last batch before the device counts as lost. For tests, since no driver loses its device on
    /// request.
    /// </summary>
    internal long LastBatch { get; set; } = long.MaxValue;

    /// <summary>Number of the batch being recorded. All batches with smaller numbers are submitted.</summary>
    internal long Batch { get; private set; } = 1;

    CommandBatch Current => At(Batch);

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
        for (int i = 0; i < Batches; i++)
            _ring[i] = new CommandBatch(device.Handle, _commandPool, i);
    }

    internal void Dispatch(ComputeProgram program, ReadOnlySpan<byte> uniforms,
        ReadOnlySpan<GpuResource> buffers, in GroupCounts groups)
    {
        if (_recording && program.UniformBytes > UniformBytes - Current.UniformsUsed)
            Submit();
        Begin();
        var batch = Current;
        _uniforms ??= Allocation.ForHost(_device, Batches * UniformBytes, Native.UniformUsage);
        ulong set = program.Sets.Get(buffers, _uniforms.Buffer, Batch);
        uint at = (uint)(batch.Index * UniformBytes + batch.UniformsUsed);
        uniforms.CopyTo(new Span<byte>(_uniforms.Mapped + at, uniforms.Length));
        batch.UniformsUsed += Reflection.Align(uniforms.Length);

        var blocks = program.Blocks;
        var offsets = stackalloc uint[blocks.Length];
        for (int i = 0; i < blocks.Length; i++)
            offsets[i] = at + (uint)blocks[i].Start;
        nint commands = batch.Commands;
        Native.vkCmdBindPipeline(commands, ComputeBindPoint, program.Pipeline);
        Native.vkCmdBindDescriptorSets(
            commands, ComputeBindPoint, program.Layout, 0, 1, in set, (uint)blocks.Length, offsets);
        _device.Clock.Stamp(batch);
        groups.Dispatch(commands);
        _device.Clock.Stamp(batch);
        program.LastBatch = Batch;
        foreach (var buffer in buffers)
            buffer.LastBatch = Batch;
        if (groups.Buffer != null)
            groups.Buffer.LastBatch = Batch;
        if (++batch.Dispatches == MaxDispatches)
            Submit();
    }

    internal void Fill(ulong buffer)
    {
        Begin();
        Native.vkCmdFillBuffer(Current.Commands, buffer, 0, ulong.MaxValue, 0);
    }

    /// <summary>Brings a new picture into the layout in which it stays, and makes it black and transparent.</summary>
    internal void Clear(GpuImage image)
    {
        Begin();
        var barrier = new ImageMemoryBarrier
        {
            SType = StructureType.ImageMemoryBarrier, To = Native.MemoryRead | Native.MemoryWrite,
            OldLayout = Native.UndefinedLayout, NewLayout = Native.GeneralLayout,
            FromFamily = Native.IgnoredFamily, ToFamily = Native.IgnoredFamily,
            Image = image.Handle, Range = ImageRange.Whole
        };
        Native.vkCmdPipelineBarrier(Current.Commands, Native.TransferStage, Native.TransferStage, 0, 0, null, 0, null,
            1, &barrier);
        var black = stackalloc uint[4];
        var range = ImageRange.Whole;
        Native.vkCmdClearColorImage(Current.Commands, image.Handle, Native.GeneralLayout, black, 1, &range);
        image.LastBatch = Batch;
    }

    /// <summary>Copies a picture's pixels to a buffer, row by row.</summary>
    internal void Copy(GpuImage image, GpuBuffer target)
    {
        Begin();
        var region = new BufferImageCopy
        {
            Aspect = ImageRange.Colour, LayerCount = 1, Width = (uint)image.Width, Height = (uint)image.Height,
            Depth = 1
        };
        Native.vkCmdCopyImageToBuffer(Current.Commands, image.Handle, Native.GeneralLayout, target.Handle, 1, &region);
        image.LastBatch = target.LastBatch = Batch;
    }

    internal void Upload(ReadOnlySpan<byte> data, GpuBuffer target, long offset)
    {
        while (data.Length > 0)
        {
            int piece = Stage(data.Length, out long at);
            data[..piece].CopyTo(new Span<byte>(_staging.Mapped + at, piece));
            BeginUpload(target);
            Copy(_staging.Buffer, at, target.Handle, offset, piece);
            target.LastBatch = Batch;
            data = data[piece..];
            offset += piece;
        }
    }

    /// <summary>
    /// Copies bytes as they are after the commands recorded before, and submits. They are at <paramref name="target"/>
    /// once the batch, whose number is returned, is known to have run; the memory must last until then.
    /// </summary>
    internal long Download(GpuBuffer source, long offset, byte* target, long bytes)
    {
        while (bytes > 0)
        {
            int piece = Stage(bytes, out long at);
            Begin();
            Copy(source.Handle, offset, _staging.Buffer, at, piece);
            Current.AddDownload(_staging.Mapped + at, target, piece);
            source.LastBatch = Batch;
            target += piece;
            offset += piece;
            bytes -= piece;
        }
        Submit();
        return source.LastBatch;
    }

    /// <summary>Whether a batch has run. Does not wait.</summary>
    internal bool HasRun(long batch)
    {
        while (_lastRun < batch && _lastRun < Batch - 1)
        {
            var next = At(_lastRun + 1);
            int result = Native.vkGetFenceStatus(_device.Handle, next.Fence);
            if (result == Native.NotReady)
                return false;
            Complete(next, result);
        }
        return batch <= _lastRun;
    }

    /// <summary>Waits until a batch and those before it have run.</summary>
    internal void Finish(long batch)
    {
        if (batch >= Batch)
            Submit();
        while (_lastRun < batch && _lastRun < Batch - 1)
        {
            var next = At(_lastRun + 1);
            var patience = Patience * Math.Max(1, next.Dispatches);
            ulong fence = next.Fence;
            int result =
                Native.vkWaitForFences(_device.Handle, 1, in fence, 1, (ulong)patience.Ticks * 100);
            if (result == Native.Timeout)
            {
                _device.Abandon();
                throw new VulkanException($"could not {Run(next)}: no answer in {patience.TotalMinutes:0} minutes; "
                    + "use smaller dispatches or another device");
            }
            Complete(next, result);
        }
    }

    /// <summary>Submits the recorded commands.</summary>
    void Submit()
    {
        if (!_recording)
            return;
        _recording = false;
        _uploadTargets.Clear();
        Barrier();
        var batch = Current;
        nint commands = batch.Commands;
        VulkanException.Check(Native.vkEndCommandBuffer(commands), "record commands");
        var submit =
            new SubmitInfo { SType = StructureType.SubmitInfo, CommandBufferCount = 1, CommandBuffers = &commands };
        Check(Batch > LastBatch ? Native.DeviceLost : Native.vkQueueSubmit(_queue, 1, &submit, batch.Fence), batch);
        Batch++;
    }

    /// <summary>Takes what the oldest batch in flight leaves, or throws the error with which it ended.</summary>
    void Complete(CommandBatch batch, int result)
    {
        if (result < 0)
        {
            string run = Run(batch);
            _lastRun = Batch - 1; // a lost device runs nothing any more
            foreach (var lost in _ring)
                lost.Reset();
            VulkanException.Check(result, run);
        }
        _lastRun++;
        ulong fence = batch.Fence;
        Check(Native.vkResetFences(_device.Handle, 1, in fence), batch);
        _device.Clock.Add(batch);
        batch.Download();
    }

    void Check(int result, CommandBatch batch)
    {
        if (result < 0)
            VulkanException.Check(result, Run(batch));
    }

    string Run(CommandBatch batch) => $"run {batch.Dispatches} dispatches on {_device.Info.Name}";

    CommandBatch At(long batch) => _ring[batch % Batches];

    /// <summary>Begins a batch, unless one is being recorded. Waits for the one whose place it takes.</summary>
    void Open()
    {
        if (_recording)
            return;
        Finish(Batch - Batches);
        var batch = Current;
        batch.Reset();
        // Flag 1: each recording is submitted once.
        var info = new CommandBufferBeginInfo { SType = StructureType.CommandBufferBeginInfo, Flags = 1 };
        VulkanException.Check(Native.vkBeginCommandBuffer(batch.Commands, &info), "record commands");
        _recording = true;
        _device.Clock.Begin(batch);
    }

    void Begin()
    {
        _uploadTargets.Clear();
        if (_recording)
            Barrier();
        else
            Open(); // the batch before ended with a barrier
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
        Native.vkCmdPipelineBarrier(
            Current.Commands, Stages, Stages | Native.HostStage, 0, 1, &barrier, 0, null, 0, null);
    }

    void Copy(ulong from, long fromOffset, ulong to, long toOffset, long bytes)
    {
        var copy = new BufferCopy { From = (ulong)fromOffset, To = (ulong)toOffset, Bytes = (ulong)bytes };
        Native.vkCmdCopyBuffer(Current.Commands, from, to, 1, &copy);
    }

    /// <summary>
    /// Takes the next free part of the batch's staging bytes, at most <paramref name="bytes"/>, and returns its length.
    /// </summary>
    int Stage(long bytes, out long at)
    {
        _staging ??= Allocation.ForHost(
            _device, Batches * StagingBytes, Native.TransferSource | Native.TransferTarget);
        if (_recording && Current.StagingUsed == StagingBytes)
            Submit();
        Open();
        var batch = Current;
        at = batch.Index * StagingBytes + batch.StagingUsed;
        int piece = (int)Math.Min(bytes, StagingBytes - batch.StagingUsed);
        batch.StagingUsed = Math.Min(StagingBytes, (batch.StagingUsed + piece + 15) / 16 * 16);
        return piece;
    }

    public void Dispose()
    {
        _uniforms?.Dispose();
        _staging?.Dispose();
        foreach (var batch in _ring)
            batch.Destroy(_device.Handle);
        Native.vkDestroyCommandPool(_device.Handle, _commandPool, null);
    }
}
