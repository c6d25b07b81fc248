using System.Collections.Concurrent;
using System.Threading.Tasks;
using Glint.Vulkan;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host;

/// <summary>The device of compute shaders, opened on first use.</summary>
public static class GraphicsDevice
{
    static readonly ConcurrentQueue<(string Kind, GpuBuffer Buffer)> _leaked = new();
    static VulkanDevice _device;
    static string _selector;
    static Task<VulkanDevice> _opening;

    /// <summary>
    /// The type that SystemInfo reports. Null, like Unity's -nographics: nothing can be created; all others use Vulkan.
    /// </summary>
    public static GraphicsDeviceType Type { get; set; } = GraphicsDeviceType.Vulkan;

    /// <summary>What SystemInfo reports of asynchronous read-back. For tests of its absence.</summary>
    public static bool HasAsyncReadback { get; set; } = true;

    /// <summary>What SystemInfo reports of buffers with the group counts of a dispatch. For tests.</summary>
    public static bool HasIndirectArguments { get; set; } = true;

    /// <summary>What SystemInfo reports of textures that kernels write. For tests.</summary>
    public static bool HasStoredTextures { get; set; } = true;

    public static bool IsNull => Type == GraphicsDeviceType.Null;

    /// <summary>
    /// The device that <see cref="Engine.DeviceSelector"/> names; a new selector closes it and opens another.
    /// </summary>
    public static VulkanDevice Current
    {
        get
        {
            if (IsNull)
                throw new UnityException("there is no graphics device");
            if ((_device != null || _opening != null) && _selector != Engine.DeviceSelector)
                Close();
            return _device ??= Opened();
        }
    }

    /// <summary>The device, if it is open; else null.</summary>
    internal static VulkanDevice IfOpen => _device;

    /// <summary>
    /// Begins to open the device that <see cref="Engine.DeviceSelector"/> names on another thread: a driver takes a
    /// fifth of a second. <see cref="Current"/> throws what it cannot.
    /// </summary>
    public static void BeginOpening()
    {
        if (IsNull || _device != null || _opening != null)
            return;
        _selector = Engine.DeviceSelector;
        _opening = Open(_selector);
    }

    /// <summary>Closes the device and with it all buffers and programs.</summary>
    public static void Close()
    {
        _leaked.Clear();
        // One that could not be opened is not to be closed.
        _opening?.ContinueWith(opening => opening.Exception == null ? opening.Result : null).Result?.Dispose();
        _opening = null;
        _device?.Dispose();
        _device = null;
    }

    static Task<VulkanDevice> Open(string selector) => Task.Run(() => VulkanDevice.Open(selector));

    static VulkanDevice Opened()
    {
        BeginOpening();
        var opening = _opening;
        _opening = null;
        return opening.GetAwaiter().GetResult();
    }

    /// <summary>
    /// Stores a buffer found by the garbage collector's thread for <see cref="CollectLeaks"/> on the main one.
    /// </summary>
    internal static void Leak(string kind, GpuBuffer buffer) => _leaked.Enqueue((kind, buffer));

    /// <summary>Warns of buffers that were not released, as Unity does, and releases them.</summary>
    internal static void CollectLeaks()
    {
        while (_leaked.TryDequeue(out var leak))
        {
            leak.Buffer.Dispose();
            Debug.LogWarning($"GarbageCollector disposing of {leak.Kind}. "
                + $"Please use {leak.Kind}.Release() or .Dispose() to manually release the buffer.");
        }
    }
}
