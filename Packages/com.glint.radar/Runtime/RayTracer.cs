using System;
using System.Diagnostics;
using Glint.Core;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>
    /// Traces a radar's rays through triangles on the GPU. It owns the buffers and knows no scene: a test can make one from a kernel and an array of triangles.
    /// </summary>
    public sealed class RayTracer : IDisposable
    {
        // As many received rays as most scenes return; a scene that returns more is traced once again with room for all.
        const int FirstRayCapacity = 65536;

        static readonly ProfilerMarker s_build = new ProfilerMarker("Glint.Build");
        static readonly ProfilerMarker s_trace = new ProfilerMarker("Glint.Trace");
        static readonly ProfilerMarker s_sum = new ProfilerMarker("Glint.Sum");

        readonly string _owner;
        readonly ComputeShader _shader;
        readonly int _kernel;
        readonly int _groupWidth, _groupHeight;
        readonly DeviceBuffer<BvhNode> _nodes = new DeviceBuffer<BvhNode>("tree nodes");
        readonly DeviceBuffer<TriangleRecord> _triangles = new DeviceBuffer<TriangleRecord>("triangles");
        readonly DeviceBuffer<RayData> _rays = new DeviceBuffer<RayData>("rays kept one by one");
        readonly DeviceBuffer<uint> _rayCounter = new DeviceBuffer<uint>("counters");
        readonly DeviceBuffer<GroupSum> _groupSums = new DeviceBuffer<GroupSum>("groups of 64 rays");
        readonly uint[] _zero = new uint[1];
        int _triangleCount = -1;
        double _buildMs, _uploadMs;

        /// <param name="shader">Shaders/Trace.compute.</param>
        /// <param name="owner">Whose it is, for messages.</param>
        /// <exception cref="GlintException">There is no graphics device, or it cannot run the kernel.</exception>
        public RayTracer(ComputeShader shader, string owner = nameof(RayTracer))
        {
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null)
                throw new GlintException("there is no graphics device (graphics device type Null): start Unity without -nographics");
            if (!SystemInfo.supportsComputeShaders)
                throw new GlintException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) runs no compute shaders: use Direct3D 11 or 12, Vulkan or Metal");
            if (shader == null)
                throw new GlintException($"{owner} has no kernel: assign Packages/com.glint.radar/Shaders/Trace.compute");
            if (!shader.HasKernel("Trace"))
                throw new GlintException($"{owner}: compute shader '{shader.name}' has no kernel 'Trace': assign Packages/com.glint.radar/Shaders/Trace.compute");
            _owner = owner;
            _shader = shader;
            _kernel = shader.FindKernel("Trace");
            if (!shader.IsSupported(_kernel))
                throw new GlintException($"kernel 'Trace' of compute shader '{shader.name}' does not run on {SystemInfo.graphicsDeviceName}: see the shader's import messages");
            shader.GetKernelThreadGroupSizes(_kernel, out uint width, out uint height, out _);
            _groupWidth = (int)width;
            _groupHeight = (int)height;
            _rayCounter.Reserve(1);
            _rays.Reserve(FirstRayCapacity);
        }

        /// <summary>Takes the triangles to trace from now on: builds the tree and fills the buffers.</summary>
        /// <exception cref="GlintException">The device cannot hold them.</exception>
        public void SetScene(TriangleMesh scene)
        {
            var watch = Stopwatch.StartNew();
            Bvh bvh;
            TriangleRecord[] records;
            using (s_build.Auto())
            {
                bvh = BvhBuilder.Build(scene);
                records = bvh.Records(scene);
            }
            _buildMs = watch.Elapsed.TotalMilliseconds;

            watch.Restart();
            _triangleCount = -1; // until both are there
            _nodes.Upload(bvh.Nodes);
            _triangles.Upload(records);
            _triangleCount = records.Length;
            _uploadMs = watch.Elapsed.TotalMilliseconds;
        }

        /// <summary>One pose: dispatches the kernel and sums what comes back.</summary>
        /// <exception cref="GlintException">A setting is out of its range, or the device cannot hold as many rays as are to be kept.</exception>
        public RadarResult Trace(in RadarSettings settings, in RadarView view, KeptRays keep)
        {
            if (_triangleCount < 0)
                throw new InvalidOperationException("RayTracer.Trace without a scene: call SetScene first");
            settings.Validate(_owner);
            view.Validate(_owner);
            bool keepAll = keep == KeptRays.All;
            var groups = new int2(DivideUp(settings.RaysAcross, _groupWidth), DivideUp(settings.RaysDown, _groupHeight));
            MakeRoom(settings, groups, keepAll);

            var watch = Stopwatch.StartNew();
            int written;
            using (s_trace.Auto())
                written = TraceRays(settings, view, groups, keepAll);
            double rayMs = watch.Elapsed.TotalMilliseconds;
            RadarResult result;
            using (s_sum.Auto())
                result = Sum(settings, groups, written, keepAll);
            result.Timings = new Timings
            {
                BuildMs = _buildMs,
                UploadMs = _uploadMs,
                TraceMs = watch.Elapsed.TotalMilliseconds,
                ReadBackMs = watch.Elapsed.TotalMilliseconds - rayMs,
            };
            return result;
        }

        public void Dispose()
        {
            _groupSums.Dispose();
            _rayCounter.Dispose();
            _rays.Dispose();
            _triangles.Dispose();
            _nodes.Dispose();
        }

        void Bind(in RadarSettings settings, in RadarView view, bool keepAll)
        {
            double halfHeight = view.TanHalfFov;
            SetVector(ShaderIDs._CameraPosition, view.Position);
            SetVector(ShaderIDs._CameraRight, view.Right * halfHeight * settings.Aspect);
            SetVector(ShaderIDs._CameraUp, view.Up * halfHeight);
            SetVector(ShaderIDs._CameraForward, view.Forward);
            SetVector(ShaderIDs._ReceiverCentre, view.ReceiverCentre);
            SetVector(ShaderIDs._ReceiverRight, view.ReceiverRight / (view.ReceiverSize.x / 2));
            SetVector(ShaderIDs._ReceiverUp, view.ReceiverUp / (view.ReceiverSize.y / 2));
            SetVector(ShaderIDs._ReceiverForward, view.ReceiverForward);
            _shader.SetInt(ShaderIDs._RaysAcross, settings.RaysAcross);
            _shader.SetInt(ShaderIDs._RaysDown, settings.RaysDown);
            _shader.SetInt(ShaderIDs._MaxBounces, settings.MaxBounces);
            _shader.SetFloat(ShaderIDs._WaveNumberTurns, (float)(1 / settings.Wavelength));
            _shader.SetInt(ShaderIDs._KeepAll, keepAll ? 1 : 0);
            _shader.SetInt(ShaderIDs._RayCapacity, _rays.Capacity);
            _shader.SetInt(ShaderIDs._TriangleCount, _triangleCount);
            _shader.SetBuffer(_kernel, ShaderIDs._Nodes, _nodes.Buffer);
            _shader.SetBuffer(_kernel, ShaderIDs._Triangles, _triangles.Buffer);
            _shader.SetBuffer(_kernel, ShaderIDs._Rays, _rays.Buffer);
            _shader.SetBuffer(_kernel, ShaderIDs._RayCounter, _rayCounter.Buffer);
            _shader.SetBuffer(_kernel, ShaderIDs._GroupSums, _groupSums.Buffer);
        }

        void SetVector(int id, double3 v) => _shader.SetVector(id, new Vector4((float)v.x, (float)v.y, (float)v.z, 0));

        void MakeRoom(in RadarSettings settings, int2 groups, bool keepAll)
        {
            if (keepAll)
                _rays.Reserve(settings.RayCount);
            long most = DeviceBuffer<GroupSum>.Most;
            if ((long)groups.x * groups.y > most)
                throw new GlintException($"{settings.RaysAcross} x {settings.RaysDown} rays are too many for {SystemInfo.graphicsDeviceName}, which holds the sums of {most * _groupWidth * _groupHeight}: use fewer rays across or down");
            _groupSums.Reserve(groups.x * groups.y);
        }

        // Returns how many rays were written. When more are received than there is room for, they are traced once again with room for all.
        int TraceRays(in RadarSettings settings, in RadarView view, int2 groups, bool keepAll)
        {
            long written = Dispatch(settings, view, groups, keepAll);
            if (written > _rays.Capacity)
            {
                _rays.Reserve(written);
                written = Dispatch(settings, view, groups, keepAll);
            }
            return keepAll ? (int)settings.RayCount : (int)written;
        }

        // Returns how many received rays the kernel wrote, or would have with room enough.
        uint Dispatch(in RadarSettings settings, in RadarView view, int2 groups, bool keepAll)
        {
            Bind(settings, view, keepAll);
            _rayCounter.Buffer.SetData(_zero);
            _shader.Dispatch(_kernel, groups.x, groups.y, 1);
            return _rayCounter.ReadBack(1)[0];
        }

        RadarResult Sum(in RadarSettings settings, int2 groups, int written, bool keepAll)
        {
            var result = new RadarResult { RaysEmitted = settings.RayCount, Triangles = _triangleCount, Rays = _rays.ReadBack(written) };
            foreach (var sum in _groupSums.ReadBack(groups.x * groups.y))
            {
                result.RaysHit += sum.Hits;
                result.Bounces += sum.Bounces;
                result.PathLengthMeters += sum.PathLength;
            }
            // Received rays come in the order the GPU finished them: by pixel the sum is always the same.
            if (!keepAll)
                Array.Sort(result.Rays, (a, b) => a.Pixel.CompareTo(b.Pixel));
            result.AddReceived(result.Rays);
            return result;
        }

        static int DivideUp(int value, int divisor) => (value + divisor - 1) / divisor;
    }
}
