namespace Glint.Vulkan;

/// <summary>What one device can take.</summary>
/// <param name="MaxStorageBufferRange">Largest buffer that a kernel can use, bytes.</param>
/// <param name="MaxUniformBufferRange">Largest block of uniforms, bytes.</param>
/// <param name="MaxGroupsX">Most thread groups of a dispatch along x.</param>
/// <param name="MaxGroupSizeX">Most threads of a group along x.</param>
/// <param name="MaxGroupInvocations">Most threads of a group in all.</param>
/// <param name="MemoryBytes">Size of the largest heap of the device's own memory.</param>
/// <param name="TimestampPeriodNs">Length of a tick of the device's clock, nanoseconds.</param>
/// <param name="MaxStorageBuffersPerStage">Most buffers that a kernel can use.</param>
/// <param name="TimestampBits">Bits of the device's clock that count; 0 when kernels cannot be timed.</param>
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
