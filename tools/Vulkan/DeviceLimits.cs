namespace Glint.Vulkan;

/// <summary>Limits of a device.</summary>
/// <param name="MaxStorageBufferRange">Largest storage buffer of a kernel, bytes.</param>
/// <param name="MaxUniformBufferRange">Largest block of uniforms, bytes.</param>
/// <param name="MaxGroupsX">Maximum number of thread groups of a dispatch along x.</param>
/// <param name="MaxGroupSizeX">Maximum number of threads of a group along x.</param>
/// <param name="MaxGroupInvocations">Maximum number of threads of a group.</param>
/// <param name="MemoryBytes">Size of the largest heap of the device's own memory.</param>
/// <param name="TimestampPeriodNs">Length of a tick of the device's clock, nanoseconds.</param>
/// <param name="MaxStorageBuffersPerStage">Maximum number of storage buffers of a kernel.</param>
/// <param name="TimestampBits">Valid bits of the device's clock; 0 if kernels cannot be timed.</param>
public sealed record DeviceLimits(
    long MaxStorageBufferRange,
    long MaxUniformBufferRange,
    uint MaxGroupsX, uint MaxGroupsY, uint MaxGroupsZ,
    uint MaxGroupSizeX, uint MaxGroupSizeY, uint MaxGroupSizeZ,
    uint MaxGroupInvocations,
    long MemoryBytes,
    float TimestampPeriodNs,
    int MaxStorageBuffersPerStage,
    int TimestampBits);
