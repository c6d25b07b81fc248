using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Vulkan;

/// <summary>The connection to the Vulkan loader, and its devices.</summary>
sealed unsafe class Instance : IDisposable
{
    // On Windows the GPU's driver brings the loader too.
    static readonly string NoDriver = OperatingSystem.IsWindows()
        ? "no Vulkan driver; install the graphics driver of the GPU's maker"
        : "no Vulkan driver; install Mesa's, which also has a software device: apt-get install mesa-vulkan-drivers";
    static readonly string NoLoader = OperatingSystem.IsWindows()
        ? "the Vulkan loader vulkan-1.dll is missing; install the graphics driver of the GPU's maker"
        : "the Vulkan loader libvulkan.so.1 is missing; install it and a driver: "
            + "apt-get install libvulkan1 mesa-vulkan-drivers";

    const uint Vulkan11 = 1u << 22 | 1u << 12, Vulkan12 = 1u << 22 | 2u << 12;
    const int IncompatibleDriver = -9;

    nint _handle;

    internal IReadOnlyList<PhysicalDevice> Devices { get; private set; } = [];

    internal Instance()
    {
        var application = new ApplicationInfo { SType = StructureType.ApplicationInfo, ApiVersion = Vulkan12 };
        var info = new InstanceCreateInfo { SType = StructureType.InstanceCreateInfo, Application = &application };
        int result;
        SoftwareVectors.Widen();
        try
        {
            result = Native.vkCreateInstance(&info, null, out _handle);
        }
        catch (DllNotFoundException exception)
        {
            throw new VulkanException(NoLoader, exception);
        }

        if (result == IncompatibleDriver)
            return; // a loader without drivers has no devices
        if (result < 0)
            throw new VulkanException(
                $"no Vulkan device: the loader could not start: {VulkanException.Explain(result)}");

        uint count = 0;
        VulkanException.Check(Native.vkEnumeratePhysicalDevices(_handle, ref count, null), "list the Vulkan devices");
        var handles = new nint[count];
        fixed (nint* data = handles)
            VulkanException.Check(Native.vkEnumeratePhysicalDevices(_handle, ref count, data),
                "list the Vulkan devices");
        Devices = handles.Take((int)count)
            .Select(handle => new PhysicalDevice(handle))
            .Where(device => device.ApiVersion >= Vulkan11 && device.QueueFamily >= 0)
            .Select((device, index) => device.At(index))
            .ToList();
    }

    /// <summary>
    /// The preferred device if <paramref name="selector"/> is null or empty; else the device with that index, or that
    /// part of a name, which has more than digits.
    /// </summary>
    internal PhysicalDevice Select(string selector)
    {
        if (Devices.Count == 0)
            throw new VulkanException(DriverVariable.Blame(Environment.GetEnvironmentVariable) ?? NoDriver);
        var ranked = Devices.OrderBy(device => device.Rank);
        if (string.IsNullOrEmpty(selector))
            return ranked.First();

        if (int.TryParse(selector, out int index) && index >= 0 && index < Devices.Count)
            return Devices[index];
        // Names have numbers too, such as those of versions.
        bool isNumber = selector.All(char.IsAsciiDigit);
        return ranked.FirstOrDefault(device => !isNumber
                && device.Info.Name.Contains(selector, StringComparison.OrdinalIgnoreCase))
            ?? throw new VulkanException($"no Vulkan device \"{selector}\"; choose an index or a part of a name of: "
                + string.Join(", ",
                    Devices.Select(device => $"{device.Info.Index} {device.Info.Name} ({device.Info.Type})")));
    }

    public void Dispose()
    {
        if (_handle != 0)
            Native.vkDestroyInstance(_handle, null);
        _handle = 0;
    }
}
