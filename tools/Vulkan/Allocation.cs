using System;

namespace Glint.Vulkan;

/// <summary>A Vulkan buffer with its own memory, mapped for the host on request or where that is cheap.</summary>
sealed unsafe class Allocation : IDisposable
{
    readonly VulkanDevice _device;
    ulong _buffer, _memory;
    HostMemory _host;

    internal ulong Buffer => _buffer;

    /// <summary>Mapped bytes; null if only the device has access.</summary>
    internal byte* Mapped { get; private set; }

    internal long Bytes { get; }

    /// <summary>Whether the bytes are zero, as far as nobody has written.</summary>
    internal bool IsZero => _host != null;

    Allocation(VulkanDevice device, long bytes) => (_device, Bytes) = (device, bytes);

    /// <summary>
    /// Device memory for kernels. It is mapped if the device shares the host's cached memory (a CPU, an integrated
    /// GPU), and the process's own if the device takes that. A discrete GPU's memory is not mapped, since the host reads it
    /// a hundred times slower than a staging buffer.
    /// </summary>
    internal static Allocation ForKernels(VulkanDevice device, long bytes, bool map) =>
        Create(device, bytes, "a buffer",
            Native.StorageUsage | Native.IndirectUsage | Native.TransferSource | Native.TransferTarget,
            map ? [Native.DeviceLocal | Native.HostVisible | Native.HostCoherent | Native.HostCached,
                Native.DeviceLocal, 0] : [Native.DeviceLocal, 0],
            map, map ? device.Physical.HostMemoryAlignment : 0);

    /// <summary>Host memory that the device can read and write: uniforms and staging buffers.</summary>
    internal static Allocation ForHost(VulkanDevice device, long bytes, uint usage) =>
        Create(device, bytes, "a staging buffer", usage,
            [Native.HostVisible | Native.HostCoherent | Native.HostCached,
                Native.HostVisible | Native.HostCoherent], true, 0);

    static Allocation Create(VulkanDevice device, long bytes, string what, uint usage,
        ReadOnlySpan<uint> memoryKinds, bool map, ulong hostAlignment)
    {
        string reserve = $"reserve {what} of {bytes:N0} bytes on {device.Info.Name}";
        var allocation = new Allocation(device, bytes);
        try
        {
            var external = new ExternalMemoryBufferCreateInfo
            {
                SType = StructureType.ExternalMemoryBufferCreateInfo, HandleTypes = Native.HostAllocation
            };
            var info = new BufferCreateInfo
            {
                SType = StructureType.BufferCreateInfo, Size = (ulong)(bytes + 3) / 4 * 4, Usage = usage,
                Next = hostAlignment > 0 ? &external : null
            };
            VulkanException.Check(Native.vkCreateBuffer(device.Handle, &info, null, out allocation._buffer), reserve);
            Native.vkGetBufferMemoryRequirements(device.Handle, allocation._buffer, out var needs);

            var request = new MemoryAllocateInfo { SType = StructureType.MemoryAllocateInfo, Size = needs.Size };
            var import = new ImportMemoryHostPointerInfo
            {
                SType = StructureType.ImportMemoryHostPointerInfo, HandleType = Native.HostAllocation
            };
            if (hostAlignment > 0)
            {
                var host = allocation._host = new HostMemory(needs.Size, hostAlignment);
                needs.TypeBits &= host.TypesOn(device);
                import.Pointer = host.Data;
                request.Size = host.Bytes;
                request.Next = &import;
            }
            int type = -1;
            uint kind = 0;
            for (int i = 0; i < memoryKinds.Length && type < 0; i++)
                type = device.Physical.FindMemory(needs.TypeBits, kind = memoryKinds[i]);
            if (type < 0)
                throw new VulkanException($"could not {reserve}: it lacks this kind of memory");
            request.TypeIndex = (uint)type;
            VulkanException.Check(
                Native.vkAllocateMemory(device.Handle, &request, null, out allocation._memory), reserve);
            VulkanException.Check(
                Native.vkBindBufferMemory(device.Handle, allocation._buffer, allocation._memory, 0), reserve);
            if (map && (kind & Native.HostVisible) != 0)
            {
                VulkanException.Check(
                    Native.vkMapMemory(device.Handle, allocation._memory, 0, ulong.MaxValue, 0, out byte* data),
                    reserve);
                allocation.Mapped = data;
            }
            return allocation;
        }
        catch (OutOfMemoryException exception)
        {
            allocation.Dispose();
            throw new VulkanException($"could not {reserve}: {VulkanException.Explain(Native.OutOfHostMemory)}", exception);
        }
        catch
        {
            allocation.Dispose();
            throw;
        }
    }

    public void Dispose()
    {
        Native.vkDestroyBuffer(_device.Handle, _buffer, null);
        Native.vkFreeMemory(_device.Handle, _memory, null); // also unmaps it
        _host?.Dispose();
        _buffer = _memory = 0;
        Mapped = null;
    }
}
