using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;

namespace Glint.Vulkan;

/// <summary>
/// An opened device: makes buffers and programs, and runs dispatches one after the other. Not thread-safe.
/// </summary>
public sealed unsafe class VulkanDevice : IDisposable
{
    readonly Instance _instance;
    readonly HashSet<GpuResource> _resources = [];
    readonly HashSet<ComputeProgram> _programs = [];
    readonly List<Task> _begun = [];
    readonly bool _mapBuffers;
    CommandRecorder _recorder;
    nint _handle;

    VulkanDevice(Instance instance, PhysicalDevice physical, bool mapBuffers)
    {
        _instance = instance;
        _mapBuffers = mapBuffers;
        Physical = physical;
        Clock = new GpuClock(this);
        string open = $"open {Info.Name}";
        float priority = 1;
        var queueInfo = new DeviceQueueCreateInfo
        {
            SType = StructureType.DeviceQueueCreateInfo,
            QueueFamily = (uint)physical.QueueFamily, QueueCount = 1, Priorities = &priority,
        };
        // No features are enabled: bounds checks (robustBufferAccess) would slow a GPU's kernels.
        var info = new DeviceCreateInfo
        {
            SType = StructureType.DeviceCreateInfo, QueueInfoCount = 1, QueueInfos = &queueInfo
        };
        fixed (byte* name = HostMemory.Extension)
        {
            byte* extension = name;
            if (physical.HostMemoryAlignment > 0)
            {
                info.ExtensionCount = 1;
                info.Extensions = &extension;
            }
            VulkanException.Check(Native.vkCreateDevice(physical.Handle, &info, null, out _handle), open);
        }
        Native.vkGetDeviceQueue(_handle, (uint)physical.QueueFamily, 0, out nint queue);
        try
        {
            _recorder = new CommandRecorder(this, queue, (uint)physical.QueueFamily);
        }
        catch
        {
            Native.vkDestroyDevice(_handle, null);
            throw;
        }
    }

    public DeviceInfo Info => Physical.Info;

    public DeviceLimits Limits => Physical.Limits;

    /// <summary>Device time of dispatches.</summary>
    public GpuClock Clock { get; }

    internal PhysicalDevice Physical { get; }
    internal nint Handle => _handle;
    internal bool IsAbandoned { get; private set; }

    /// <summary>Folder of the kernels' <see cref="PipelineCacheFile"/>s; null: none.</summary>
    internal string PipelineCacheFolder { get; set; } =
        PipelineCacheFile.UserFolder(Environment.GetEnvironmentVariable);

    /// <summary>
    /// Compiled kernels by the names of their <see cref="PipelineCacheFile"/>s, until the device is disposed: programs
    /// of the same kernel share one. Some are compiled on other threads.
    /// </summary>
    internal ConcurrentDictionary<string, Lazy<ulong>> Pipelines { get; } = [];

    /// <summary>Buffers that are not disposed.</summary>
    internal IReadOnlyCollection<GpuBuffer> Buffers => _resources.OfType<GpuBuffer>().ToArray();

    internal CommandRecorder Recorder
    {
        get
        {
            ObjectDisposedException.ThrowIf(_recorder == null, this);
            return !IsAbandoned
                ? _recorder
                : throw new VulkanException($"{Info.Name} does not answer any more; start again");
        }
    }

    /// <summary>The machine's Vulkan devices in the loader's order; none if the loader has no driver.</summary>
    public static IReadOnlyList<DeviceInfo> List()
    {
        using var instance = new Instance();
        return instance.Devices.Select(device => device.Info).ToArray();
    }

    /// <summary>
    /// Opens a device by index or by part of its name in any case. If <paramref name="selector"/> is null, the
    /// preference is discrete GPU, integrated, virtual, CPU.
    /// </summary>
    public static VulkanDevice Open(string selector = null) => Open(selector, true);

    /// <summary>
    /// With <paramref name="mapBuffers"/> false, buffers are filled through staging buffers even if the device shares
    /// the host's memory.
    /// </summary>
    internal static VulkanDevice Open(string selector, bool mapBuffers)
    {
        var instance = new Instance();
        try
        {
            return new VulkanDevice(instance, instance.Select(selector), mapBuffers);
        }
        catch
        {
            instance.Dispose();
            throw;
        }
    }

    /// <summary>A buffer of zeros.</summary>
    public GpuBuffer CreateBuffer(long bytes)
    {
        if (bytes <= 0)
            throw new ArgumentOutOfRangeException(nameof(bytes),
                $"a buffer of {bytes:N0} bytes; it needs at least one");
        _ = Recorder;
        if (bytes > Limits.MaxStorageBufferRange)
            throw new VulkanException($"a buffer of {bytes:N0} bytes is too large for {Info.Name}, "
                + $"which takes {Limits.MaxStorageBufferRange:N0}; use fewer rays or a smaller scene, "
                + "or choose another device with --device");
        var buffer = new GpuBuffer(this, bytes, _mapBuffers);
        _resources.Add(buffer);
        return buffer;
    }

    /// <summary>A picture of zeros.</summary>
    public GpuImage CreateImage(int width, int height)
    {
        if (width <= 0 || height <= 0)
            throw new ArgumentOutOfRangeException(nameof(width), $"a picture of {width} x {height} pixels");
        _ = Recorder;
        var image = new GpuImage(this, width, height);
        _resources.Add(image);
        return image;
    }

    public ComputeProgram CreateProgram(ReadOnlySpan<byte> spirv)
    {
        _ = Recorder;
        return Add(new ComputeProgram(this, spirv));
    }

    /// <summary>
    /// Begins to make a program and its pipeline on another thread, if the driver's code of it is stored. Else the
    /// result is null: compiling takes long, and not all programs are used.
    /// </summary>
    /// <param name="load">Gives the SPIR-V.</param>
    public Task<ComputeProgram> BeginStoredProgram(Func<byte[]> load)
    {
        _ = Recorder;
        var begun = Task.Run(() =>
        {
            byte[] spirv = load();
            if (!ComputeProgram.IsStored(this, spirv))
                return null;
            var program = Add(new ComputeProgram(this, spirv));
            _ = program.Pipeline;
            return program;
        });
        _begun.Add(begun);
        return begun;
    }

    ComputeProgram Add(ComputeProgram program)
    {
        lock (_programs)
            _programs.Add(program);
        return program;
    }

    /// <summary>
    /// Records a dispatch, to run after the commands recorded before it. It runs at the latest when the host reads or
    /// waits.
    /// </summary>
    /// <param name="uniforms">The program's <see cref="ComputeProgram.UniformBytes"/> bytes; copied.</param>
    /// <param name="buffers">Buffers by name; surplus ones are allowed.</param>
    public void Dispatch(
        ComputeProgram program, ReadOnlySpan<byte> uniforms, IReadOnlyDictionary<string, GpuBuffer> buffers,
        uint groupsX, uint groupsY, uint groupsZ)
    {
        var bound = new GpuBuffer[program.Slots.Count];
        for (int i = 0; i < bound.Length; i++)
            bound[i] = buffers.GetValueOrDefault(program.Slots[i].Name);
        Dispatch(program, uniforms, bound, groupsX, groupsY, groupsZ);
    }

    /// <summary>
    /// Records a dispatch, to run after the commands recorded before it. It runs at the latest when the host reads or
    /// waits.
    /// </summary>
    /// <param name="uniforms">The program's <see cref="ComputeProgram.UniformBytes"/> bytes; copied.</param>
    /// <param name="buffers">Buffers and pictures in the order of <see cref="ComputeProgram.Slots"/>.</param>
    public void Dispatch(ComputeProgram program, ReadOnlySpan<byte> uniforms, ReadOnlySpan<GpuResource> buffers,
        uint groupsX, uint groupsY, uint groupsZ)
    {
        var recorder = Recorder;
        if (groupsX > Limits.MaxGroupsX || groupsY > Limits.MaxGroupsY || groupsZ > Limits.MaxGroupsZ)
            throw new VulkanException($"kernel {program.Name}: {groupsX} x {groupsY} x {groupsZ} groups, {Info.Name} "
                + $"takes {Limits.MaxGroupsX} x {Limits.MaxGroupsY} x {Limits.MaxGroupsZ}; use several dispatches");
        Check(program, uniforms, buffers);
        if (groupsX > 0 && groupsY > 0 && groupsZ > 0)
            recorder.Dispatch(program, uniforms, buffers, new GroupCounts(groupsX, groupsY, groupsZ));
    }

    /// <summary>
    /// Records a dispatch whose numbers of groups, three uint, are read from a buffer when it runs. The device does not
    /// check them.
    /// </summary>
    /// <param name="buffers">Buffers in the order of <see cref="ComputeProgram.Slots"/>.</param>
    public void DispatchIndirect(ComputeProgram program, ReadOnlySpan<byte> uniforms,
        ReadOnlySpan<GpuResource> buffers, GpuBuffer arguments, long offset)
    {
        var recorder = Recorder;
        Check(program, uniforms, buffers);
        CheckBuffer(program, "with the numbers of groups", arguments);
        if (offset % 4 != 0 || offset < 0 || offset > arguments.Bytes - GroupCounts.Bytes)
            throw new VulkanException($"kernel {program.Name}: no numbers of groups at byte {offset:N0} of a buffer "
                + $"of {arguments.Bytes:N0} bytes; use a multiple of 4 with {GroupCounts.Bytes} bytes after it");
        recorder.Dispatch(program, uniforms, buffers, new GroupCounts(arguments, offset));
    }

    void Check(ComputeProgram program, ReadOnlySpan<byte> uniforms, ReadOnlySpan<GpuResource> buffers)
    {
        if (program.Device != this)
            throw new VulkanException($"kernel {program.Name} was made for another device");
        if (uniforms.Length != program.UniformBytes)
            throw new VulkanException($"kernel {program.Name} takes {program.UniformBytes} bytes of uniforms, "
                + $"{uniforms.Length} are given");
        for (int i = 0; i < buffers.Length; i++)
            CheckBuffer(program, program.Slots[i].Name, buffers[i]);
        _ = program.Pipeline;
    }

    void CheckBuffer(ComputeProgram program, string name, GpuResource buffer)
    {
        if (buffer == null)
            throw new VulkanException($"kernel {program.Name}: buffer {name} is not set");
        if (buffer.IsDisposed)
            throw new VulkanException($"kernel {program.Name}: buffer {name} was disposed");
        if (buffer.Device != this)
            throw new VulkanException($"kernel {program.Name}: buffer {name} is on another device");
    }

    /// <summary>Runs the recorded commands and waits for their end.</summary>
    public void Wait() => Recorder.Finish(Recorder.Batch);

    /// <summary>Waits until a batch has run.</summary>
    /// <param name="batch">Number that <see cref="GpuBuffer.BeginRead"/> returned.</param>
    public void Wait(long batch) => Recorder.Finish(batch);

    /// <summary>Whether a batch has run.</summary>
    /// <param name="batch">Number that <see cref="GpuBuffer.BeginRead"/> returned.</param>
    public bool HasRun(long batch) => Recorder.HasRun(batch);

    /// <summary>Closes the device and disposes its remaining buffers and programs.</summary>
    public void Dispose()
    {
        if (_recorder == null)
            return;
        Task.WhenAll(_begun).ContinueWith(_ => { }, TaskScheduler.Default).Wait();
        if (!IsAbandoned)
        {
            Native.vkDeviceWaitIdle(_handle); // a lost device returns an error and can still be destroyed
            foreach (var program in _programs)
                program.Destroy();
            foreach (var pipeline in Pipelines.Values.Where(made => made.IsValueCreated))
                Native.vkDestroyPipeline(_handle, pipeline.Value, null);
            // A picture disposes the buffer that it is copied to.
            foreach (var resource in _resources.OrderByDescending(resource => resource is GpuImage).ToArray())
                resource.Destroy();
            _recorder.Dispose();
            Clock.Destroy();
            Native.vkDestroyDevice(_handle, null);
            _instance.Dispose();
        }
        _programs.Clear();
        Pipelines.Clear();
        _resources.Clear();
        _recorder = null;
        _handle = 0;
    }

    /// <summary>True if the device does not respond. Its objects may be in use and are never destroyed.</summary>
    internal void Abandon() => IsAbandoned = true;

    /// <summary>Waits until a batch has run, unless the device does not respond.</summary>
    internal void FinishIfAlive(long batch)
    {
        if (!IsAbandoned)
            Recorder.Finish(batch);
    }

    internal void Forget(GpuResource resource) => _resources.Remove(resource);

    internal void Forget(ComputeProgram program)
    {
        lock (_programs)
            _programs.Remove(program);
    }
}
