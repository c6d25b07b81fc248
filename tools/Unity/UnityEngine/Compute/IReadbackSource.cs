using Glint.Vulkan;
using Unity.Collections;

namespace Glint.Host;

/// <summary>What an asynchronous read-back copies from.</summary>
internal interface IReadbackSource
{
    /// <summary>False if it was released.</summary>
    bool IsValid { get; }

    VulkanDevice Device { get; }

    long Bytes { get; }

    /// <summary>Has the device copy bytes as they are now, and returns the number of the batch that does.</summary>
    long BeginGet(NativeArray<byte> data, long offset);
}
