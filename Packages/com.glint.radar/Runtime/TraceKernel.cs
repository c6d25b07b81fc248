using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>The kernels of Shaders/Trace.compute, or of TraceWide.compute, and what they are given.</summary>
    sealed class TraceKernel
    {
        // GROUPS_A_ROW in Shaders/Constants.hlsl.
        internal const int GroupsARow = 64;

        /// <summary>Tiles that one dispatch takes at most: those of so many groups of 64 threads.</summary>
        public const int MostTiles = 65535 * GroupsARow;

        readonly ComputeShader _shader;
        readonly bool _isWide;
        readonly string _name;
        readonly string _exactName;
        readonly int _startsKernel, _pathsKernel;
        int _kernel, _exactKernel;

        /// <param name="shader">Shaders/Trace.compute.</param>
        /// <param name="isWide">Take the kernels of <see cref="SoftwareDevice.WideShader"/> instead.</param>
        /// <exception cref="GlintException">
        /// There is no graphics device, the shader is another one, or the device cannot run it.
        /// </exception>
        public TraceKernel(ComputeShader shader, bool isWide, string owner)
        {
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null)
                throw new GlintException("there is no graphics device (graphics device type Null): "
                    + "start Unity without -nographics");
            if (!SystemInfo.supportsComputeShaders)
                throw new GlintException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) runs no "
                    + "compute shaders: use Direct3D 11 or 12, Vulkan or Metal");
            if (shader == null)
                throw new GlintException($"{owner} has no kernel: "
                    + "assign Packages/com.glint.radar/Shaders/Trace.compute");
            if (!shader.HasKernel("Trace"))
                throw new GlintException($"{owner}: compute shader '{shader.name}' has no kernel 'Trace': "
                    + "assign Packages/com.glint.radar/Shaders/Trace.compute");
            _isWide = isWide;
            _shader = isWide ? SoftwareDevice.WideShader : shader;
            if (_shader == null)
                throw new InvalidOperationException("the wide kernels are not there: only the headless host has them");
            string suffix = isWide ? "Wide" : "";
            _name = "Trace" + suffix;
            _kernel = _shader.FindKernel(_name);
            _startsKernel = _shader.FindKernel("Starts" + suffix);
            _exactName = "Exact" + suffix;
            _exactKernel = _shader.FindKernel(_exactName);
            _pathsKernel = _shader.FindKernel("Paths" + suffix);
            foreach (int kernel in new[] { _kernel, _startsKernel, _exactKernel, _pathsKernel })
                if (!_shader.IsSupported(kernel))
                    throw new GlintException($"a kernel of compute shader '{_shader.name}' does not run on "
                        + $"{SystemInfo.graphicsDeviceName}: see the shader's import messages");
        }

        /// <summary>Takes the kernels for a scene; the other calls set and run those.</summary>
        public void Choose(DeviceScene scene, bool countsVisits)
        {
            // The loop over instances costs a software device a tenth of its time, even for a single one.
            string kind = countsVisits ? "Count"
                : !scene.HasFewInstances ? scene.Banks.Count > 1 ? "Banks" : ""
                : _isWide && scene.Few.Count == 1 ? "One" : "Few";
            _kernel = _shader.FindKernel(_name + kind);
            _exactKernel = _shader.FindKernel(_exactName + (scene.Banks.Count > 1 ? "Banks" : ""));
        }

        public void SetRadar(in RadarSettings settings, in RadarView view, RayGrid grid, double3 origin,
            float lengthUnits, Shortcuts shortcuts)
        {
            SetVector(ShaderIDs._Start, grid.Start);
            SetVector(ShaderIDs._StartRight, grid.StartRight);
            SetVector(ShaderIDs._StartUp, grid.StartUp);
            SetVector(ShaderIDs._Course, grid.Course);
            SetVector(ShaderIDs._CourseRight, grid.CourseRight);
            SetVector(ShaderIDs._CourseUp, grid.CourseUp);
            SetVector(ShaderIDs._ReceiverCentre, view.ReceiverCentre - grid.Middle);
            SetVector(ShaderIDs._ReceiverRight, view.ReceiverRight);
            SetVector(ShaderIDs._ReceiverUp, view.ReceiverUp);
            SetVector(ShaderIDs._ReceiverForward, view.ReceiverForward);
            double2 half = view.ReceiverSize / 2;
            _shader.SetVector(ShaderIDs._ReceiverHalfSize,
                new Vector4((float)half.x, TwoFloat.Rest(half.x), (float)half.y, TwoFloat.Rest(half.y)));
            SetNumber(ShaderIDs._StartDepth, grid.StartDepth);
            SetNumber(ShaderIDs._WaveNumberTurns, 1 / settings.Wavelength);
            _shader.SetVector(ShaderIDs._ReferenceRay, new Vector4(grid.Reference.x, grid.Reference.y, 0, 0));
            double3 middle = grid.Middle + origin;
            _shader.SetVector(ShaderIDs._Middle,
                new Vector4((float)middle.x, (float)middle.y, (float)middle.z, (float)grid.Size));
            _shader.SetInt(ShaderIDs._RaysAcross, settings.RaysAcross);
            var region = settings.Region;
            _shader.SetInts(ShaderIDs._Region, region.IsWhole
                ? new[] { 0, settings.RaysAcross, 0, settings.RaysDown }
                : new[] { region.Left, region.Left + region.Width, region.Bottom, region.Bottom + region.Height });
            _shader.SetInt(ShaderIDs._MaxBounces, settings.MaxBounces);
            _shader.SetFloat(ShaderIDs._LengthUnits, lengthUnits);
            _shader.SetInt(ShaderIDs._Shortcuts, (int)shortcuts);
        }

        public void SetScene(DeviceScene scene)
        {
            if (scene.HasFewInstances)
            {
                var rows = new Vector4[4 * DeviceScene.MostFew];
                var firstRows = new int[DeviceScene.MostFew];
                for (int i = 0; i < scene.Few.Count; i++)
                {
                    var record = scene.Few[i];
                    (rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]) =
                        (record.ToLocalX, record.ToLocalY, record.ToLocalZ);
                    rows[4 * i + 3] = new Vector4(record.Stretch, record.Rounding);
                    firstRows[i] = (int)record.FirstRow;
                }
                _shader.SetVectorArray(ShaderIDs._FewToLocal, rows);
                _shader.SetInts(ShaderIDs._FewFirstRow, firstRows);
                _shader.SetInt(ShaderIDs._InstanceCount, scene.Few.Count);
            }
            SetTrees(_kernel, scene);
            SetTrees(_exactKernel, scene);
        }

        public void SetBuffers(DeviceBuffer<uint> tiles, DeviceBuffer<uint> sums)
        {
            _shader.SetBuffer(_kernel, ShaderIDs._Tiles, tiles.Buffer);
            _shader.SetBuffer(_kernel, ShaderIDs._Sums, sums.Buffer);
            _shader.SetBuffer(_exactKernel, ShaderIDs._Sums, sums.Buffer);
        }

        public void SetStarts(DeviceBuffer<uint4> starts) =>
            _shader.SetBuffer(_kernel, ShaderIDs._Starts, starts.Buffer);

        /// <summary>Finds where the rays of some tiles begin their search.</summary>
        public void FindStarts(DeviceScene scene, DeviceBuffer<uint> tiles, int firstTile, int count,
            DeviceBuffer<uint4> starts)
        {
            _shader.SetBuffer(_startsKernel, ShaderIDs._Tree[0], scene.Banks[0].Rows.Buffer);
            _shader.SetBuffer(_startsKernel, ShaderIDs._Tiles, tiles.Buffer);
            _shader.SetBuffer(_startsKernel, ShaderIDs._FoundStarts, starts.Buffer);
            _shader.SetInt(ShaderIDs._FirstTile, firstTile);
            _shader.SetInt(ShaderIDs._TileCount, count);
            DispatchThreads(_startsKernel, (long)count * scene.Few.Count);
        }

        /// <summary>Follows the rays of some of the tiles; lists those that may be received.</summary>
        /// <param name="rays">Takes the others when all are to be kept.</param>
        public void Dispatch(int firstTile, int count, KeptRays keep, DeviceBuffer<ReceivedRay> returning,
            DeviceBuffer<RayData> rays)
        {
            _shader.SetInt(ShaderIDs._FirstTile, firstTile);
            _shader.SetInt(ShaderIDs._TileCount, count);
            SetOutput(_kernel, keep, returning, rays);
            DispatchThreads(_kernel, (long)count * PictureTiles.Rays);
        }

        /// <summary>Follows listed rays once more, in two-float arithmetic.</summary>
        /// <param name="subRays">Along the side of a ray's place: 1, or 2 to 8 to divide it.</param>
        public void DispatchExact(int first, int count, int subRays, KeptRays keep, DeviceBuffer<ReceivedRay> returning,
            DeviceBuffer<RayData> rays)
        {
            _shader.SetInt(ShaderIDs._FirstReturning, first);
            _shader.SetInt(ShaderIDs._ReturningCount, count);
            _shader.SetInt(ShaderIDs._SubRays, subRays);
            SetOutput(_exactKernel, keep, returning, rays);
            DispatchThreads(_exactKernel, (long)count * subRays * subRays);
        }

        /// <summary>Follows listed rays, in two-float arithmetic, and notes their reflections.</summary>
        /// <param name="listed">
        /// Pixel, 0; then bounces, and the bits of the length from the last one to the receiver's plane,
        /// 0 for a ray that is not received.
        /// </param>
        /// <param name="hits">Takes <see cref="RadarSettings.MaxBounces"/> places a ray.</param>
        public void DispatchPaths(DeviceScene scene, int count, DeviceBuffer<uint2> listed, DeviceBuffer<HitData> hits)
        {
            SetTrees(_pathsKernel, scene);
            _shader.SetInt(ShaderIDs._ReturningCount, count);
            _shader.SetBuffer(_pathsKernel, ShaderIDs._Returning, listed.Buffer);
            _shader.SetBuffer(_pathsKernel, ShaderIDs._Hits, hits.Buffer);
            DispatchThreads(_pathsKernel, count);
        }

        void SetTrees(int kernel, DeviceScene scene)
        {
            _shader.SetInt(ShaderIDs._TopRoot, (int)scene.TopRoot);
            _shader.SetBuffer(kernel, ShaderIDs._Top, scene.Top.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Instances, scene.Instances.Buffer);
            // Every bank that a kernel declares wants a buffer, read or not.
            for (int bank = 0; bank < DeviceTrees.MostBanks; bank++)
                _shader.SetBuffer(kernel, ShaderIDs._Tree[bank],
                    scene.Banks[bank < scene.Banks.Count ? bank : 0].Rows.Buffer);
        }

        void SetOutput(int kernel, KeptRays keep, DeviceBuffer<ReceivedRay> returning, DeviceBuffer<RayData> rays)
        {
            _shader.SetInt(ShaderIDs._Keep, (int)keep);
            _shader.SetBuffer(kernel, ShaderIDs._Returning, returning.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Rays, rays.Buffer);
        }

        void DispatchThreads(int kernel, long threads)
        {
            _shader.GetKernelThreadGroupSizes(kernel, out uint size, out _, out _);
            int groups = (int)((threads + size - 1) / size);
            _shader.Dispatch(kernel, math.min(groups, GroupsARow), (groups + GroupsARow - 1) / GroupsARow, 1);
        }

        void SetVector((int value, int rest) id, double3 v)
        {
            _shader.SetVector(id.value, new Vector4((float)v.x, (float)v.y, (float)v.z, 0));
            _shader.SetVector(id.rest, new Vector4(TwoFloat.Rest(v.x), TwoFloat.Rest(v.y), TwoFloat.Rest(v.z), 0));
        }

        void SetNumber(int id, double value) =>
            _shader.SetVector(id, new Vector4((float)value, TwoFloat.Rest(value), 0, 0));
    }
}
