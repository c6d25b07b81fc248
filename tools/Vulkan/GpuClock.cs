namespace Glint.Vulkan;

/// <summary>
/// Sums the device time of dispatches, from timestamps that the device writes before and after each.
/// Copies and idle time do not count. It is off by default and then costs nothing.
/// </summary>
public sealed unsafe class GpuClock
{
    const int Queries = 2 * CommandRecorder.MaxDispatches;

    readonly VulkanDevice _device;
    ulong _pool;
    int _stamps;
    double _milliseconds;
    bool _isOn;

    internal GpuClock(VulkanDevice device) => _device = device;

    /// <summary>Whether the device can time dispatches.</summary>
    public bool IsSupported => _device.Limits.TimestampBits > 0;

    /// <summary>Whether dispatches are timed. Changing it waits for what is recorded.</summary>
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

    /// <summary>Begins at zero again; what was recorded before no longer counts.</summary>
    public void Reset()
    {
        _device.Wait();
        _milliseconds = 0;
    }

    /// <summary>
    /// Milliseconds of device time of the dispatches since <see cref="Reset"/>; waits for what is recorded.
    /// </summary>
    public double Read()
    {
        _device.Wait();
        return _milliseconds;
    }

    internal void BeginBatch(nint commands)
    {
        _stamps = 0;
        if (!_isOn)
            return;
        if (_pool == 0)
            CreatePool();
        Native.vkCmdResetQueryPool(commands, _pool, 0, Queries);
    }

    /// <summary>
    /// Once before and once after a dispatch. The stage is the last:
    /// all that was recorded before must be done, a copy too.
    /// </summary>
    internal void Stamp(nint commands)
    {
        if (_isOn)
            Native.vkCmdWriteTimestamp(commands, Native.BottomOfPipe, _pool, (uint)_stamps++);
    }

    /// <summary>Takes the times of a batch that has run.</summary>
    internal void EndBatch()
    {
        if (_stamps == 0)
            return;
        var ticks = stackalloc ulong[Queries];
        VulkanException.Check(
            Native.vkGetQueryPoolResults(_device.Handle, _pool, 0, (uint)_stamps, (nuint)(_stamps * sizeof(ulong)),
                ticks, sizeof(ulong), Native.Query64Bit | Native.QueryWait),
            "read the device's clock");
        // The clock has this many bits and begins again at 0 after the last.
        ulong mask = ulong.MaxValue >> (64 - _device.Limits.TimestampBits);
        for (int i = 0; i < _stamps; i += 2)
            _milliseconds += ((ticks[i + 1] - ticks[i]) & mask) * (double)_device.Limits.TimestampPeriodNs * 1e-6;
        _stamps = 0;
    }

    internal void Destroy() => Native.vkDestroyQueryPool(_device.Handle, _pool, null);

    void CreatePool()
    {
        var info = new QueryPoolCreateInfo
        {
            SType = StructureType.QueryPoolCreateInfo, QueryType = Native.TimestampQuery, Count = Queries
        };
        VulkanException.Check(Native.vkCreateQueryPool(_device.Handle, &info, null, out _pool), "make a clock");
    }
}
