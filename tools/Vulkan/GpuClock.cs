namespace Glint.Vulkan;

/// <summary>
/// Sums the device time of dispatches, from timestamps before and after each. Copies and idle time do not count. The
/// clock is off by default and then has no cost.
/// </summary>
public sealed unsafe class GpuClock
{
    const int Queries = 2 * CommandRecorder.MaxDispatches; // of a batch

    readonly VulkanDevice _device;
    ulong _pool;
    double _milliseconds;
    bool _isOn;

    internal GpuClock(VulkanDevice device) => _device = device;

    /// <summary>True if the device can time dispatches.</summary>
    public bool IsSupported => _device.Limits.TimestampBits > 0;

    /// <summary>True if dispatches are timed. A change waits for the recorded commands.</summary>
    public bool IsOn
    {
        get => _isOn;
        set
        {
            if (value == _isOn)
                return;
            if (value && !IsSupported)
                throw new VulkanException($"{_device.Info.Name} has no clock for its kernels; measure wall time");
            _device.Wait();
            _isOn = value;
        }
    }

    /// <summary>Resets the time to zero; commands recorded before do not count.</summary>
    public void Reset()
    {
        _device.Wait();
        _milliseconds = 0;
    }

    /// <summary>
    /// Device time in milliseconds of the dispatches since <see cref="Reset"/>. Waits for the recorded commands.
    /// </summary>
    public double Read()
    {
        _device.Wait();
        return _milliseconds;
    }

    internal void Begin(CommandBatch batch)
    {
        if (!_isOn)
            return;
        if (_pool == 0)
            CreatePool();
        Native.vkCmdResetQueryPool(batch.Commands, _pool, First(batch), Queries);
    }

    /// <summary>
    /// Records a timestamp before or after a dispatch. Its stage is the last, so that all earlier commands, copies
    /// included, are complete.
    /// </summary>
    internal void Stamp(CommandBatch batch)
    {
        if (_isOn)
            Native.vkCmdWriteTimestamp(
                batch.Commands, Native.BottomOfPipe, _pool, First(batch) + (uint)batch.Stamps++);
    }

    /// <summary>Adds the times of a batch that has run.</summary>
    internal void Add(CommandBatch batch)
    {
        if (batch.Stamps == 0)
            return;
        var ticks = stackalloc ulong[Queries];
        VulkanException.Check(
            Native.vkGetQueryPoolResults(_device.Handle, _pool, First(batch), (uint)batch.Stamps,
                (nuint)(batch.Stamps * sizeof(ulong)), ticks, sizeof(ulong), Native.Query64Bit | Native.QueryWait),
            "read the device's clock");
        // The clock has this many bits and wraps around.
        ulong mask = ulong.MaxValue >> (64 - _device.Limits.TimestampBits);
        for (int i = 0; i < batch.Stamps; i += 2)
            _milliseconds += ((ticks[i + 1] - ticks[i]) & mask) * (double)_device.Limits.TimestampPeriodNs * 1e-6;
    }

    internal void Destroy() => Native.vkDestroyQueryPool(_device.Handle, _pool, null);

    static uint First(CommandBatch batch) => (uint)(batch.Index * Queries);

    void CreatePool()
    {
        var info = new QueryPoolCreateInfo
        {
            SType = StructureType.QueryPoolCreateInfo, QueryType = Native.TimestampQuery,
            Count = CommandRecorder.Batches * Queries
        };
        VulkanException.Check(Native.vkCreateQueryPool(_device.Handle, &info, null, out _pool), "make a clock");
    }
}
