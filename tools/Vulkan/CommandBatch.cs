using System;
using System.Collections.Generic;

namespace Glint.Vulkan;

/// <summary>
/// One place of the recorder's ring: the command buffer of a batch, and the staging and uniform bytes, timestamps and
/// downloads that belong to it until it has run.
/// </summary>
sealed unsafe class CommandBatch
{
    readonly List<(nint Source, nint Target, long Bytes)> _downloads = [];
    readonly nint _commands;
    readonly ulong _fence;

    /// <param name="index">Position in the ring.</param>
    internal CommandBatch(nint device, ulong commandPool, int index)
    {
        Index = index;
        var bufferInfo = new CommandBufferAllocateInfo
        {
            SType = StructureType.CommandBufferAllocateInfo, Pool = commandPool, Count = 1
        };
        VulkanException.Check(Native.vkAllocateCommandBuffers(device, &bufferInfo, out _commands),
            "make a command buffer");
        var info = new FenceCreateInfo { SType = StructureType.FenceCreateInfo };
        VulkanException.Check(Native.vkCreateFence(device, &info, null, out _fence), "make a fence");
    }

    internal int Index { get; }
    internal nint Commands => _commands;
    internal ulong Fence => _fence;

    /// <summary>Dispatches recorded.</summary>
    internal int Dispatches { get; set; }

    /// <summary>Timestamps recorded.</summary>
    internal int Stamps { get; set; }

    internal long StagingUsed { get; set; }
    internal long UniformsUsed { get; set; }

    /// <summary>Copies staging bytes to the host's memory once the batch has run.</summary>
    internal void AddDownload(byte* source, byte* target, long bytes) =>
        _downloads.Add(((nint)source, (nint)target, bytes));

    internal void Download()
    {
        foreach (var (source, target, bytes) in _downloads)
            Buffer.MemoryCopy((byte*)source, (byte*)target, bytes, bytes);
    }

    /// <summary>Empties the place for the next batch.</summary>
    internal void Reset()
    {
        _downloads.Clear();
        Dispatches = Stamps = 0;
        StagingUsed = UniformsUsed = 0;
    }

    internal void Destroy(nint device) => Native.vkDestroyFence(device, _fence, null);
}
