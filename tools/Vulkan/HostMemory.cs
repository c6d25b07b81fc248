using System;
using System.Linq;
using System.Runtime.InteropServices;

namespace Glint.Vulkan;

/// <summary>
/// Memory of the process that a device uses as its own (VK_EXT_external_memory_host). Its bytes are zero, and the
/// operating system provides a page when it is first touched: a list that could hold many poses costs what a single one
/// fills. What the driver reserves has to be cleared as a whole.
/// </summary>
sealed unsafe class HostMemory : IDisposable
{
    internal static ReadOnlySpan<byte> Extension => "VK_EXT_external_memory_host"u8;

    void* _reserved;

    /// <param name="bytes">At least one.</param>
    /// <param name="alignment">Of the first byte and of the size: a power of 2.</param>
    internal HostMemory(ulong bytes, ulong alignment)
    {
        Bytes = (bytes + alignment - 1) & ~(alignment - 1);
        _reserved = NativeMemory.AllocZeroed((nuint)(Bytes + alignment));
        Data = (byte*)(((ulong)_reserved + alignment - 1) & ~(alignment - 1));
    }

    internal byte* Data { get; private set; }

    internal ulong Bytes { get; }

    /// <summary>Memory types by which a device takes these bytes, a bit each.</summary>
    internal uint TypesOn(VulkanDevice device)
    {
        var properties = new MemoryHostPointerProperties { SType = StructureType.MemoryHostPointerProperties };
        fixed (byte* name = "vkGetMemoryHostPointerPropertiesEXT"u8)
        {
            var get = (delegate* unmanaged<nint, uint, void*, MemoryHostPointerProperties*, int>)
                Native.vkGetDeviceProcAddr(device.Handle, name);
            VulkanException.Check(get(device.Handle, Native.HostAllocation, Data, &properties),
                $"use {Bytes:N0} bytes of this process on {device.Info.Name}");
        }
        return properties.TypeBits;
    }

    /// <summary>Alignment that a physical device asks for; 0 if it does not have the extension.</summary>
    internal static ulong AlignmentOn(nint physical)
    {
        uint count = 0;
        Native.vkEnumerateDeviceExtensionProperties(physical, null, ref count, null);
        var extensions = new ExtensionProperties[count];
        fixed (ExtensionProperties* data = extensions)
            Native.vkEnumerateDeviceExtensionProperties(physical, null, ref count, data);
        if (!extensions.Any(extension => IsThis(extension)))
            return 0;
        var host = new ExternalMemoryHostProperties { SType = StructureType.PhysicalDeviceExternalMemoryHostProperties };
        var properties = new PhysicalDeviceProperties2 { SType = StructureType.PhysicalDeviceProperties2, Next = &host };
        Native.vkGetPhysicalDeviceProperties2(physical, &properties);
        return host.MinAlignment;
    }

    static bool IsThis(ExtensionProperties extension) =>
        MemoryMarshal.CreateReadOnlySpanFromNullTerminated(extension.Name).SequenceEqual(Extension);

    public void Dispose()
    {
        NativeMemory.Free(_reserved);
        _reserved = Data = null;
    }
}
