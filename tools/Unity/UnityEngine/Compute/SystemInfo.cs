using System;
using Glint.Host;
using Glint.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class SystemInfo
{
    const int MegaByte = 1 << 20;

    static DeviceLimits Limits => GraphicsDevice.Current.Limits;

    static DeviceInfo Device => GraphicsDevice.Current.Info;

    public static string operatingSystem => Machine.OperatingSystem;

    public static string processorType => Machine.Processor;

    public static int processorCount => Environment.ProcessorCount;

    public static int systemMemorySize => (int)(GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / MegaByte);

    public static string deviceName => Environment.MachineName;

    public static GraphicsDeviceType graphicsDeviceType => GraphicsDevice.Type;

    public static string graphicsDeviceName => GraphicsDevice.IsNull ? "Null Device" : Device.Name;

    public static string graphicsDeviceVendor => GraphicsDevice.IsNull ? "" : Machine.Vendor(Device.VendorId);

    public static int graphicsDeviceVendorID => GraphicsDevice.IsNull ? 0 : (int)Device.VendorId;

    public static int graphicsDeviceID => GraphicsDevice.IsNull ? 0 : (int)Device.DeviceId;

    public static string graphicsDeviceVersion =>
        GraphicsDevice.IsNull ? "NULL 1.0" : $"Vulkan {Device.ApiVersion} [{Device.Driver}]";

    public static int graphicsMemorySize =>
        GraphicsDevice.IsNull ? 0 : (int)Math.Min(Limits.MemoryBytes / MegaByte, int.MaxValue);

    public static long maxGraphicsBufferSize => GraphicsDevice.IsNull ? 0 : Limits.MaxStorageBufferRange;

    public static int maxConstantBufferSize =>
        GraphicsDevice.IsNull ? 0 : (int)Math.Min(Limits.MaxUniformBufferRange, int.MaxValue);

    public static bool supportsComputeShaders => !GraphicsDevice.IsNull;

    public static bool supportsAsyncGPUReadback => !GraphicsDevice.IsNull && GraphicsDevice.HasAsyncReadback;

    public static bool supportsIndirectArgumentsBuffer =>
        !GraphicsDevice.IsNull && GraphicsDevice.HasIndirectArguments;

    /// <summary>Whether textures of a format can be used so: the host has one kind.</summary>
    public static bool IsFormatSupported(GraphicsFormat format, GraphicsFormatUsage usage) =>
        !GraphicsDevice.IsNull && GraphicsDevice.HasStoredTextures && format == GraphicsFormat.R8G8B8A8_UNorm
        && usage == GraphicsFormatUsage.LoadStore;

    public static int maxComputeBufferInputsCompute => GraphicsDevice.IsNull ? 0 : Limits.MaxStorageBuffersPerStage;

    public static int maxComputeWorkGroupSize => GraphicsDevice.IsNull ? 0 : (int)Limits.MaxGroupInvocations;

    public static int maxComputeWorkGroupSizeX => GraphicsDevice.IsNull ? 0 : (int)Limits.MaxGroupSizeX;

    public static int maxComputeWorkGroupSizeY => GraphicsDevice.IsNull ? 0 : (int)Limits.MaxGroupSizeY;

    public static int maxComputeWorkGroupSizeZ => GraphicsDevice.IsNull ? 0 : (int)Limits.MaxGroupSizeZ;
}
