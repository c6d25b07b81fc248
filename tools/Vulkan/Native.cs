using System;
using System.Runtime.InteropServices;

namespace Glint.Vulkan;

/// <summary>Functions of the Vulkan loader. Those that return int return a VkResult: negative is an error.</summary>
static unsafe class Native
{
    const string Loader = "vulkan";

    /// <summary>File name of the loader on this operating system.</summary>
    internal static readonly string LoaderFile = OperatingSystem.IsWindows() ? "vulkan-1.dll" : "libvulkan.so.1";

    internal const uint StorageImage = 3, StorageBuffer = 7, DynamicUniformBuffer = 8;                    // VkDescriptorType
    internal const uint DeviceLocal = 1, HostVisible = 2, HostCoherent = 4, HostCached = 8; // VkMemoryPropertyFlags
    // VkBufferUsageFlags
    internal const uint TransferSource = 1, TransferTarget = 2, UniformUsage = 16, StorageUsage = 32,
        IndirectUsage = 256;
    internal const uint HostAllocation = 0x80;                              // VkExternalMemoryHandleTypeFlags
    internal const uint ImageStorageUsage = 8;                                          // VkImageUsageFlags
    internal const uint Image2D = 1, View2D = 1;                            // VkImageType, VkImageViewType
    internal const uint Rgba8 = 37;                                                     // VkFormat
    internal const uint UndefinedLayout = 0, GeneralLayout = 1;                         // VkImageLayout
    internal const uint IgnoredFamily = uint.MaxValue;
    // VkPipelineStageFlags
    internal const uint IndirectStage = 2, ComputeStage = 0x800, TransferStage = 0x1000, BottomOfPipe = 0x2000,
        HostStage = 0x4000;
    internal const uint MemoryRead = 0x8000, MemoryWrite = 0x10000;                     // VkAccessFlags
    internal const uint ComputeShader = 0x20;                                           // VkShaderStageFlags
    internal const uint ComputeQueue = 2;                                               // VkQueueFlags
    internal const int TimestampQuery = 2;                                              // VkQueryType
    internal const uint Query64Bit = 1, QueryWait = 2;                                  // VkQueryResultFlags
    internal const int NotReady = 1, Timeout = 2, OutOfHostMemory = -1, DeviceLost = -4; // VkResult

    [DllImport(Loader)]
    internal static extern int vkCreateInstance(InstanceCreateInfo* info, void* allocator, out nint instance);
    [DllImport(Loader)] internal static extern void vkDestroyInstance(nint instance, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkEnumeratePhysicalDevices(nint instance, ref uint count, nint* devices);
    [DllImport(Loader)]
    internal static extern void vkGetPhysicalDeviceProperties2(nint physical, PhysicalDeviceProperties2* properties);
    [DllImport(Loader)]
    internal static extern void vkGetPhysicalDeviceMemoryProperties(nint physical, out MemoryProperties properties);
    [DllImport(Loader)]
    internal static extern void vkGetPhysicalDeviceQueueFamilyProperties(nint physical,
        ref uint count, QueueFamilyProperties* families);

    [DllImport(Loader)]
    internal static extern int vkEnumerateDeviceExtensionProperties(nint physical, byte* layer,
        ref uint count, ExtensionProperties* extensions);

    [DllImport(Loader)]
    internal static extern int vkCreateDevice(nint physical, DeviceCreateInfo* info, void* allocator, out nint device);
    [DllImport(Loader)] internal static extern void vkDestroyDevice(nint device, void* allocator);
    [DllImport(Loader)] internal static extern nint vkGetDeviceProcAddr(nint device, byte* name);
    [DllImport(Loader)] internal static extern int vkDeviceWaitIdle(nint device);
    [DllImport(Loader)]
    internal static extern void vkGetDeviceQueue(nint device, uint family, uint index, out nint queue);
    [DllImport(Loader)]
    internal static extern int vkQueueSubmit(nint queue, uint count, SubmitInfo* submits, ulong fence);

    [DllImport(Loader)]
    internal static extern int vkAllocateMemory(nint device, MemoryAllocateInfo* info,
        void* allocator, out ulong memory);
    [DllImport(Loader)] internal static extern void vkFreeMemory(nint device, ulong memory, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkMapMemory(nint device, ulong memory, ulong offset, ulong bytes,
        uint flags, out byte* data);
    [DllImport(Loader)]
    internal static extern int vkCreateBuffer(nint device, BufferCreateInfo* info, void* allocator, out ulong buffer);
    [DllImport(Loader)] internal static extern void vkDestroyBuffer(nint device, ulong buffer, void* allocator);
    [DllImport(Loader)]
    internal static extern void vkGetBufferMemoryRequirements(nint device, ulong buffer,
        out MemoryRequirements requirements);
    [DllImport(Loader)]
    internal static extern int vkBindBufferMemory(nint device, ulong buffer, ulong memory, ulong offset);

    [DllImport(Loader)]
    internal static extern int vkCreateImage(nint device, ImageCreateInfo* info, void* allocator, out ulong image);
    [DllImport(Loader)] internal static extern void vkDestroyImage(nint device, ulong image, void* allocator);
    [DllImport(Loader)]
    internal static extern void vkGetImageMemoryRequirements(nint device, ulong image,
        out MemoryRequirements requirements);
    [DllImport(Loader)]
    internal static extern int vkBindImageMemory(nint device, ulong image, ulong memory, ulong offset);
    [DllImport(Loader)]
    internal static extern int vkCreateImageView(nint device, ImageViewCreateInfo* info, void* allocator,
        out ulong view);
    [DllImport(Loader)] internal static extern void vkDestroyImageView(nint device, ulong view, void* allocator);

    [DllImport(Loader)]
    internal static extern int vkCreateShaderModule(nint device, ShaderModuleCreateInfo* info,
        void* allocator, out ulong module);
    [DllImport(Loader)] internal static extern void vkDestroyShaderModule(nint device, ulong module, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkCreateDescriptorSetLayout(nint device,
        DescriptorSetLayoutCreateInfo* info, void* allocator, out ulong layout);
    [DllImport(Loader)]
    internal static extern void vkDestroyDescriptorSetLayout(nint device, ulong layout, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkCreatePipelineLayout(nint device, PipelineLayoutCreateInfo* info,
        void* allocator, out ulong layout);
    [DllImport(Loader)] internal static extern void vkDestroyPipelineLayout(nint device, ulong layout, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkCreatePipelineCache(nint device, PipelineCacheCreateInfo* info,
        void* allocator, out ulong cache);
    [DllImport(Loader)]
    internal static extern int vkGetPipelineCacheData(nint device, ulong cache, ref nuint bytes, void* data);
    [DllImport(Loader)] internal static extern void vkDestroyPipelineCache(nint device, ulong cache, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkCreateComputePipelines(nint device, ulong cache, uint count,
        ComputePipelineCreateInfo* infos, void* allocator, out ulong pipeline);
    [DllImport(Loader)] internal static extern void vkDestroyPipeline(nint device, ulong pipeline, void* allocator);

    [DllImport(Loader)]
    internal static extern int vkCreateDescriptorPool(nint device, DescriptorPoolCreateInfo* info,
        void* allocator, out ulong pool);
    [DllImport(Loader)] internal static extern void vkDestroyDescriptorPool(nint device, ulong pool, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkAllocateDescriptorSets(nint device, DescriptorSetAllocateInfo* info, out ulong set);
    [DllImport(Loader)]
    internal static extern void vkUpdateDescriptorSets(nint device, uint writes,
        WriteDescriptorSet* write, uint copies, void* copy);

    [DllImport(Loader)]
    internal static extern int vkCreateCommandPool(nint device, CommandPoolCreateInfo* info,
        void* allocator, out ulong pool);
    [DllImport(Loader)] internal static extern void vkDestroyCommandPool(nint device, ulong pool, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkAllocateCommandBuffers(nint device,
        CommandBufferAllocateInfo* info, out nint commands);
    [DllImport(Loader)] internal static extern int vkBeginCommandBuffer(nint commands, CommandBufferBeginInfo* info);
    [DllImport(Loader)] internal static extern int vkEndCommandBuffer(nint commands);
    [DllImport(Loader)]
    internal static extern int vkCreateFence(nint device, FenceCreateInfo* info, void* allocator, out ulong fence);
    [DllImport(Loader)] internal static extern void vkDestroyFence(nint device, ulong fence, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkCreateQueryPool(nint device, QueryPoolCreateInfo* info,
        void* allocator, out ulong pool);
    [DllImport(Loader)] internal static extern void vkDestroyQueryPool(nint device, ulong pool, void* allocator);
    [DllImport(Loader)]
    internal static extern int vkGetQueryPoolResults(nint device, ulong pool, uint first,
        uint count, nuint bytes, void* data, ulong stride, uint flags);
    [DllImport(Loader)]
    internal static extern int vkWaitForFences(nint device, uint count, in ulong fence, uint all, ulong nanoseconds);
    [DllImport(Loader)] internal static extern int vkGetFenceStatus(nint device, ulong fence);
    [DllImport(Loader)] internal static extern int vkResetFences(nint device, uint count, in ulong fence);

    [DllImport(Loader)] internal static extern void vkCmdBindPipeline(nint commands, int bindPoint, ulong pipeline);
    [DllImport(Loader)]
    internal static extern void vkCmdBindDescriptorSets(nint commands, int bindPoint, ulong layout,
        uint first, uint count, in ulong set, uint dynamicCount, uint* dynamicOffsets);
    [DllImport(Loader)] internal static extern void vkCmdDispatch(nint commands, uint x, uint y, uint z);
    [DllImport(Loader)] internal static extern void vkCmdDispatchIndirect(nint commands, ulong buffer, ulong offset);
    [DllImport(Loader)]
    internal static extern void vkCmdPipelineBarrier(nint commands, uint from, uint to, uint flags,
        uint memoryCount, MemoryBarrier* memory, uint bufferCount, void* buffers, uint imageCount, void* images);
    [DllImport(Loader)]
    internal static extern void vkCmdCopyBuffer(nint commands, ulong from, ulong to, uint count, BufferCopy* copies);
    [DllImport(Loader)]
    internal static extern void vkCmdClearColorImage(nint commands, ulong image, uint layout, uint* colour,
        uint rangeCount, ImageRange* ranges);
    [DllImport(Loader)]
    internal static extern void vkCmdCopyImageToBuffer(nint commands, ulong image, uint layout, ulong buffer,
        uint count, BufferImageCopy* regions);
    [DllImport(Loader)]
    internal static extern void vkCmdResetQueryPool(nint commands, ulong pool, uint first, uint count);
    [DllImport(Loader)]
    internal static extern void vkCmdWriteTimestamp(nint commands, uint stage, ulong pool, uint query);
    [DllImport(Loader)]
    internal static extern void vkCmdFillBuffer(nint commands, ulong buffer, ulong offset, ulong bytes, uint value);

    static Native() => NativeLibrary.SetDllImportResolver(typeof(Native).Assembly,
        (name, assembly, folders) => name == Loader ? NativeLibrary.Load(LoaderFile, assembly, folders) : 0);

    /// <summary>A zero-terminated UTF-8 string.</summary>
    internal static string Text(byte* text) => Marshal.PtrToStringUTF8((IntPtr)text);
}
