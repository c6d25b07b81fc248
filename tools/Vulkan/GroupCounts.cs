namespace Glint.Vulkan;

/// <summary>Numbers of thread groups of a dispatch: given, or three uint in a buffer when the dispatch runs.</summary>
readonly struct GroupCounts
{
    internal const int Bytes = 12;

    readonly uint _x, _y, _z;
    readonly long _offset;

    internal GroupCounts(uint x, uint y, uint z) : this() => (_x, _y, _z) = (x, y, z);

    internal GroupCounts(GpuBuffer buffer, long offset) : this() => (Buffer, _offset) = (buffer, offset);

    /// <summary>The buffer with the numbers; null if they are given.</summary>
    internal GpuBuffer Buffer { get; }

    internal void Dispatch(nint commands)
    {
        if (Buffer == null)
            Native.vkCmdDispatch(commands, _x, _y, _z);
        else
            Native.vkCmdDispatchIndirect(commands, Buffer.Handle, (ulong)_offset);
    }
}
