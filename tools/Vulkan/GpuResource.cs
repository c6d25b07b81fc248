using System;

namespace Glint.Vulkan;

/// <summary>What a kernel reads or writes on the device.</summary>
public abstract class GpuResource : IDisposable
{
    private protected GpuResource(VulkanDevice device) => Device = device;

    /// <summary>True if it or its device was disposed.</summary>
    public abstract bool IsDisposed { get; }

    internal VulkanDevice Device { get; }

    /// <summary>Batch of the last recorded command that uses it.</summary>
    internal long LastBatch { get; set; }

    public void Dispose()
    {
        GC.SuppressFinalize(this);
        if (IsDisposed)
            return;
        try
        {
            Device.FinishIfAlive(LastBatch);
        }
        finally
        {
            Device.Forget(this);
            Destroy();
        }
    }

    /// <summary>Frees it, unless the device does not respond.</summary>
    internal abstract void Destroy();
}
