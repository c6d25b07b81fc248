using System.Runtime.InteropServices;

namespace Glint.Vulkan;

#pragma warning disable CS0649 // fields that only Vulkan reads, and only as zero

// Vulkan's structures in its field order, for 64-bit processes. A handle is nint where Vulkan has a pointer and ulong
// where it has a number. SType, first in most of them, holds a number of StructureType.

static class StructureType
{
    internal const int ApplicationInfo = 0, InstanceCreateInfo = 1, DeviceQueueCreateInfo = 2,
        DeviceCreateInfo = 3, SubmitInfo = 4,
        MemoryAllocateInfo = 5, FenceCreateInfo = 8, QueryPoolCreateInfo = 11, BufferCreateInfo = 12,
        ImageCreateInfo = 14, ImageViewCreateInfo = 15,
        ShaderModuleCreateInfo = 16, PipelineCacheCreateInfo = 17, PipelineShaderStageCreateInfo = 18,
        ComputePipelineCreateInfo = 29, PipelineLayoutCreateInfo = 30,
        DescriptorSetLayoutCreateInfo = 32, DescriptorPoolCreateInfo = 33,
        DescriptorSetAllocateInfo = 34, WriteDescriptorSet = 35,
        CommandPoolCreateInfo = 39, CommandBufferAllocateInfo = 40,
        CommandBufferBeginInfo = 42, ImageMemoryBarrier = 45, MemoryBarrier = 46, PhysicalDeviceProperties2 = 1000059001,
        ExternalMemoryBufferCreateInfo = 1000072000,
        PhysicalDeviceMaintenance3Properties = 1000168000,
        ImportMemoryHostPointerInfo = 1000178000, MemoryHostPointerProperties = 1000178001,
        PhysicalDeviceExternalMemoryHostProperties = 1000178002,
        PhysicalDeviceDriverProperties = 1000196000;
}

unsafe struct ApplicationInfo
{
    internal int SType; internal void* Next; internal byte* ApplicationName; internal uint ApplicationVersion;
    internal byte* EngineName; internal uint EngineVersion, ApiVersion;
}

unsafe struct InstanceCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags; internal ApplicationInfo* Application;
    internal uint LayerCount; internal byte** Layers; internal uint ExtensionCount; internal byte** Extensions;
}

unsafe struct DeviceQueueCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags, QueueFamily, QueueCount; internal float* Priorities;
}

unsafe struct DeviceCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags,
        QueueInfoCount; internal DeviceQueueCreateInfo* QueueInfos;
    internal uint LayerCount; internal byte** Layers; internal uint ExtensionCount;
    internal byte** Extensions; internal void* Features;
}

/// <summary>VkPhysicalDeviceProperties2 with the used limits at their offsets.</summary>
[StructLayout(LayoutKind.Explicit, Size = 840)]
unsafe struct PhysicalDeviceProperties2
{
    [FieldOffset(0)] internal int SType;
    [FieldOffset(8)] internal void* Next;
    [FieldOffset(16)] internal uint ApiVersion;
    [FieldOffset(20)] internal uint DriverVersion;
    [FieldOffset(24)] internal uint VendorId;
    [FieldOffset(28)] internal uint DeviceId;
    [FieldOffset(32)] internal int DeviceType;
    [FieldOffset(36)] internal fixed byte DeviceName[256];
    [FieldOffset(292)] internal fixed byte PipelineCacheUuid[16];
    [FieldOffset(336)] internal uint MaxUniformBufferRange;
    [FieldOffset(340)] internal uint MaxStorageBufferRange;
    [FieldOffset(388)] internal uint MaxStorageBuffersPerStage;
    [FieldOffset(532)] internal fixed uint MaxGroupCount[3];
    [FieldOffset(544)] internal uint MaxGroupInvocations;
    [FieldOffset(548)] internal fixed uint MaxGroupSize[3];
    [FieldOffset(736)] internal float TimestampPeriod;
}

unsafe struct Maintenance3Properties
{
    internal int SType; internal void* Next; internal uint MaxPerSetDescriptors; internal ulong MaxMemoryAllocationSize;
}

unsafe struct ExtensionProperties
{
    internal fixed byte Name[256]; internal uint Version;
}

unsafe struct ExternalMemoryHostProperties
{
    internal int SType; internal void* Next; internal ulong MinAlignment;
}

unsafe struct DriverProperties
{
    internal int SType; internal void* Next; internal int DriverId; internal fixed byte Name[256],
        Info[256]; internal uint Conformance;
}

struct QueueFamilyProperties
{
    internal uint Flags, Count, TimestampBits, GranularityX, GranularityY, GranularityZ;
}

/// <summary>
/// Up to 32 memory types (flags, heap) and 16 heaps (64-bit size, flags, padding), read through methods, for example
/// <see cref="TypeFlags"/>.
/// </summary>
[StructLayout(LayoutKind.Explicit, Size = 520)]
unsafe struct MemoryProperties
{
    [FieldOffset(0)] internal uint TypeCount;
    [FieldOffset(4)] fixed uint _types[64];
    [FieldOffset(260)] internal uint HeapCount;
    [FieldOffset(264)] fixed ulong _heaps[32];

    internal uint TypeFlags(int type) => _types[2 * type];
    internal int TypeHeap(int type) => (int)_types[2 * type + 1];
    internal ulong HeapSize(int heap) => _heaps[2 * heap];
    internal bool HeapIsDeviceLocal(int heap) => (_heaps[2 * heap + 1] & 1) != 0;
}

struct MemoryRequirements
{
    internal ulong Size, Alignment; internal uint TypeBits;
}

unsafe struct MemoryAllocateInfo
{
    internal int SType; internal void* Next; internal ulong Size; internal uint TypeIndex;
}

unsafe struct ImportMemoryHostPointerInfo
{
    internal int SType; internal void* Next; internal uint HandleType; internal void* Pointer;
}

unsafe struct MemoryHostPointerProperties
{
    internal int SType; internal void* Next; internal uint TypeBits;
}

unsafe struct ExternalMemoryBufferCreateInfo
{
    internal int SType; internal void* Next; internal uint HandleTypes;
}

unsafe struct BufferCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags; internal ulong Size; internal uint Usage, SharingMode,
        QueueFamilyCount; internal uint* QueueFamilies;
}

/// <summary>Part of a picture: aspect, levels of detail, layers.</summary>
struct ImageRange
{
    internal const uint Colour = 1;

    internal uint Aspect, FirstLevel, LevelCount, FirstLayer, LayerCount;

    internal static ImageRange Whole => new() { Aspect = Colour, LevelCount = 1, LayerCount = 1 };
}

unsafe struct ImageCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags, ImageType, Format, Width, Height, Depth, MipLevels,
        ArrayLayers, Samples, Tiling, Usage, SharingMode, QueueFamilyCount; internal uint* QueueFamilies;
    internal uint InitialLayout;
}

unsafe struct ImageViewCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags; internal ulong Image; internal uint ViewType, Format;
    internal uint Red, Green, Blue, Alpha; internal ImageRange Range;
}

unsafe struct ImageMemoryBarrier
{
    internal int SType; internal void* Next; internal uint From, To, OldLayout, NewLayout, FromFamily, ToFamily;
    internal ulong Image; internal ImageRange Range;
}

struct BufferImageCopy
{
    internal ulong Offset; internal uint RowLength, ImageHeight, Aspect, Level, FirstLayer, LayerCount;
    internal int X, Y, Z; internal uint Width, Height, Depth;
}

struct DescriptorImageInfo
{
    internal ulong Sampler, View; internal uint Layout;
}

unsafe struct QueryPoolCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags;
    internal int QueryType; internal uint Count, Statistics;
}

unsafe struct PipelineCacheCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags; internal nuint DataBytes; internal void* Data;
}

unsafe struct ShaderModuleCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags; internal nuint CodeBytes; internal uint* Code;
}

unsafe struct PipelineShaderStageCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags, Stage; internal ulong Module;
    internal byte* Name; internal void* Specialization;
}

unsafe struct ComputePipelineCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags; internal PipelineShaderStageCreateInfo Stage;
    internal ulong Layout, BasePipeline; internal int BaseIndex;
}

unsafe struct PipelineLayoutCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags, SetLayoutCount; internal ulong* SetLayouts;
    internal uint PushRangeCount; internal void* PushRanges;
}

unsafe struct DescriptorSetLayoutBinding
{
    internal uint Binding, Type, Count, Stages; internal void* Samplers;
}

unsafe struct DescriptorSetLayoutCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags, BindingCount;
    internal DescriptorSetLayoutBinding* Bindings;
}

struct DescriptorPoolSize
{
    internal uint Type, Count;
}

unsafe struct DescriptorPoolCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags, MaxSets,
        SizeCount; internal DescriptorPoolSize* Sizes;
}

unsafe struct DescriptorSetAllocateInfo
{
    internal int SType; internal void* Next; internal ulong Pool; internal uint Count; internal ulong* Layouts;
}

struct DescriptorBufferInfo
{
    internal ulong Buffer, Offset, Range;
}

unsafe struct WriteDescriptorSet
{
    internal int SType; internal void* Next; internal ulong Set; internal uint Binding, ArrayElement, Count, Type;
    internal DescriptorImageInfo* Image; internal DescriptorBufferInfo* Buffer; internal void* TexelBuffer;
}

unsafe struct CommandPoolCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags, QueueFamily;
}

unsafe struct CommandBufferAllocateInfo
{
    internal int SType; internal void* Next; internal ulong Pool; internal int Level; internal uint Count;
}

unsafe struct CommandBufferBeginInfo
{
    internal int SType; internal void* Next; internal uint Flags; internal void* Inheritance;
}

unsafe struct SubmitInfo
{
    internal int SType; internal void* Next; internal uint WaitCount;
    internal void* WaitSemaphores; internal void* WaitStages;
    internal uint CommandBufferCount; internal nint* CommandBuffers;
    internal uint SignalCount; internal void* SignalSemaphores;
}

unsafe struct FenceCreateInfo
{
    internal int SType; internal void* Next; internal uint Flags;
}

unsafe struct MemoryBarrier
{
    internal int SType; internal void* Next; internal uint From, To;
}

struct BufferCopy
{
    internal ulong From, To, Bytes;
}
