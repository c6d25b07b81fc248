using System;

namespace Glint.Vulkan;

/// <summary>
/// A failure of the device, its driver, a buffer or a compiled kernel. The message is one line with the way out.
/// </summary>
public sealed class VulkanException : Exception
{
    public VulkanException(string message, Exception inner = null) : base(message, inner) { }

    /// <summary>
    /// Throws if a Vulkan call failed. <paramref name="what"/> names the operation and its value, for example "reserve
    /// 12 bytes".
    /// </summary>
    internal static void Check(int result, string what)
    {
        if (result < 0)
            throw new VulkanException($"could not {what}: {Explain(result)}");
    }

    internal static string Explain(int result) => result switch
    {
        -1 => "out of host memory",
        -2 => "out of device memory; use fewer rays or a smaller scene, or choose another device with --device",
        -3 => "the driver could not initialise the device",
        -4 => "the device was lost (it is gone, or its driver reset it, often because one dispatch ran too long); "
            + "try again, a sweep with --resume, or choose another device with --device",
        -5 => "the driver could not map the memory",
        -9 => "no Vulkan driver answers; install the GPU's, or Mesa's (apt-get install mesa-vulkan-drivers)",
        -10 => "too many objects of this kind, release buffers that are no longer used",
        _ => $"Vulkan error {result}",
    };
}
