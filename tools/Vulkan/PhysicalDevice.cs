using System;

namespace Glint.Vulkan;

/// <summary>A device from the loader's list, not yet opened.</summary>
sealed unsafe class PhysicalDevice
{
    const uint Vulkan12 = 1u << 22 | 2u << 12;
    static readonly string[] TypeNames = ["other", "integrated GPU", "discrete GPU", "virtual GPU", "CPU"];
    static readonly int[] Ranks = [4, 1, 0, 2, 3];
    const int Cpu = 4; // of both

    readonly int _type;

    internal nint Handle { get; }
    internal DeviceInfo Info { get; private set; }
    internal DeviceLimits Limits { get; }
    internal MemoryProperties Memory { get; }
    internal uint ApiVersion { get; }
    internal uint DriverVersion { get; }

    /// <summary>Header of the device's pipeline cache data.</summary>
    internal byte[] PipelineCacheHeader { get; }

    /// <summary>
    /// Alignment of the <see cref="HostMemory"/> that it uses as its own; 0 if it does not. Only a device that is the
    /// host's processor is asked: to others that memory is far.
    /// </summary>
    internal ulong HostMemoryAlignment { get; }

    /// <summary>First queue family that runs kernels; -1 if there is none.</summary>
    internal int QueueFamily { get; }

    /// <summary>Order of preference: discrete, integrated, virtual, CPU.</summary>
    internal int Rank => Ranks[_type];

    internal PhysicalDevice(nint handle)
    {
        Handle = handle;
        var driver = new DriverProperties { SType = StructureType.PhysicalDeviceDriverProperties };
        var allocation =
            new Maintenance3Properties { SType = StructureType.PhysicalDeviceMaintenance3Properties, Next = null };
        var properties = new PhysicalDeviceProperties2 { SType = StructureType.PhysicalDeviceProperties2 };
        Native.vkGetPhysicalDeviceProperties2(handle, &properties);
        ApiVersion = properties.ApiVersion;
        if (ApiVersion >= Vulkan12)
            allocation.Next = &driver;
        properties.Next = &allocation;
        Native.vkGetPhysicalDeviceProperties2(handle, &properties);

        DriverVersion = properties.DriverVersion;
        PipelineCacheHeader = PipelineCacheFile.Header(properties.VendorId, properties.DeviceId,
            new ReadOnlySpan<byte>(properties.PipelineCacheUuid, 16));

        Native.vkGetPhysicalDeviceMemoryProperties(handle, out var memory);
        Memory = memory;
        long memoryBytes = 0;
        for (int heap = 0; heap < memory.HeapCount; heap++)
            if (memory.HeapIsDeviceLocal(heap))
                memoryBytes = Math.Max(memoryBytes, (long)memory.HeapSize(heap));

        _type = properties.DeviceType >= 0 && properties.DeviceType < TypeNames.Length ? properties.DeviceType : 0;
        HostMemoryAlignment = _type == Cpu ? HostMemory.AlignmentOn(handle) : 0;
        QueueFamily = FindQueueFamily(handle, out int timestampBits);
        string driverText = ApiVersion >= Vulkan12
            ? $"{Native.Text(driver.Name)} {Native.Text(driver.Info)}".Trim()
            : Version(properties.DriverVersion);
        Info = new DeviceInfo(0, Native.Text(properties.DeviceName), TypeNames[_type], Version(ApiVersion), driverText,
            properties.VendorId, properties.DeviceId);
        Limits = new DeviceLimits(
            Math.Min(Math.Min(properties.MaxStorageBufferRange, memoryBytes),
                (long)Math.Min(allocation.MaxMemoryAllocationSize, long.MaxValue)),
            properties.MaxUniformBufferRange,
            properties.MaxGroupCount[0], properties.MaxGroupCount[1], properties.MaxGroupCount[2],
            properties.MaxGroupSize[0], properties.MaxGroupSize[1], properties.MaxGroupSize[2],
            properties.MaxGroupInvocations, memoryBytes, properties.TimestampPeriod,
            (int)Math.Min(properties.MaxStorageBuffersPerStage, int.MaxValue),
            timestampBits);
    }

    internal PhysicalDevice At(int index)
    {
        Info = Info with { Index = index };
        return this;
    }

    /// <summary>
    /// First memory type among <paramref name="allowed"/> with all of <paramref name="flags"/>; -1 if there is none.
    /// </summary>
    internal int FindMemory(uint allowed, uint flags)
    {
        for (int type = 0; type < Memory.TypeCount; type++)
            if ((allowed >> type & 1) != 0 && (Memory.TypeFlags(type) & flags) == flags)
                return type;
        return -1;
    }

    static int FindQueueFamily(nint handle, out int timestampBits)
    {
        uint count = 0;
        Native.vkGetPhysicalDeviceQueueFamilyProperties(handle, ref count, null);
        var families = new QueueFamilyProperties[count];
        fixed (QueueFamilyProperties* data = families)
            Native.vkGetPhysicalDeviceQueueFamilyProperties(handle, ref count, data);
        int index = Array.FindIndex(families, family => (family.Flags & Native.ComputeQueue) != 0);
        timestampBits = index < 0 ? 0 : (int)families[index].TimestampBits;
        return index;
    }

    static string Version(uint version) => $"{version >> 22}.{version >> 12 & 0x3ff}.{version & 0xfff}";
}
