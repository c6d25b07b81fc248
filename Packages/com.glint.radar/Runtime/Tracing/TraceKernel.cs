using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>The kernels of Shaders/Trace.compute, or of TraceWide.compute, and their inputs.</summary>
    sealed class TraceKernel
    {
        // GROUPS_A_ROW in Shaders/Constants.hlsl.
        internal const int GroupsARow = 64;

        // Leaves whose horizons one dispatch finds: well below a second on a slow GPU.
        const int LeavesADispatch = 1 << 15;

        /// <summary>Maximum tiles of one dispatch, by the limit of thread groups.</summary>
        public const int MaxTiles = 65535 * GroupsARow;

        readonly ComputeShader _shader;
        readonly bool _isWide;
        readonly string _name;
        readonly string _refineName;
        readonly int _entryPointsKernel, _pathsKernel;
        int _kernel, _refineKernel;

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
                    + "compute shaders: use Vulkan or Direct3D 11 or 12");
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLES3)
                throw new GlintException($"{SystemInfo.graphicsDeviceName} (OpenGLES3) does not guarantee the rounding "
                    + "that path lengths need, as OpenGL ES has no 'precise': use Vulkan");
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
            _entryPointsKernel = _shader.FindKernel("EntryPoints" + suffix);
            _refineName = "Refine" + suffix;
            _refineKernel = _shader.FindKernel(_refineName);
            _pathsKernel = _shader.FindKernel("Paths" + suffix);
            foreach (int kernel in new[] { _kernel, _entryPointsKernel, _refineKernel, _pathsKernel })
                if (!_shader.IsSupported(kernel))
                    throw new GlintException($"a kernel of compute shader '{_shader.name}' does not run on "
                        + $"{SystemInfo.graphicsDeviceName}: see the shader's import messages");
            DeviceArithmetic.Check(shader);
        }

        /// <summary>Chooses the kernels for a scene; the other methods set and run these.</summary>
        public void Choose(DeviceScene scene, bool countsVisits)
        {
            // The loop over instances costs a software device a tenth of its time, even for one instance.
            string kind = countsVisits ? "Count"
                : !scene.HasInlineInstances ? scene.Pages.Count > 1 ? "Paged" : ""
                : _isWide && scene.InlineInstances.Count == 1 ? "SingleInstance" : "InlineInstances";
            _kernel = _shader.FindKernel(_name + kind);
            _refineKernel = _shader.FindKernel(_refineName + (scene.Pages.Count > 1 ? "Paged" : ""));
        }

        public void SetRadar(in RadarSettings settings, in RadarView view, RayGrid grid, double3 origin,
            float lengthUnits, Culling culling)
        {
            SetVector(ShaderIDs._Origin, grid.Origin);
            SetVector(ShaderIDs._OriginDx, grid.OriginDx);
            SetVector(ShaderIDs._OriginDy, grid.OriginDy);
            SetVector(ShaderIDs._Direction, grid.Direction);
            SetVector(ShaderIDs._DirectionDx, grid.DirectionDx);
            SetVector(ShaderIDs._DirectionDy, grid.DirectionDy);
            SetVector(ShaderIDs._ReceiverCentre, view.ReceiverCentre - grid.SceneCentre);
            SetVector(ShaderIDs._ReceiverRight, view.ReceiverRight);
            SetVector(ShaderIDs._ReceiverUp, view.ReceiverUp);
            SetVector(ShaderIDs._ReceiverForward, view.ReceiverForward);
            double2 half = view.ReceiverSize / 2;
            _shader.SetVector(ShaderIDs._ReceiverHalfSize,
                new Vector4((float)half.x, DoubleFloat.Lo(half.x), (float)half.y, DoubleFloat.Lo(half.y)));
            SetNumber(ShaderIDs._OriginDepth, grid.OriginDepth);
            SetNumber(ShaderIDs._WaveNumberTurns, 1 / settings.Wavelength);
            _shader.SetVector(ShaderIDs._ReferencePixel,
                new Vector4(grid.ReferencePixel.x, grid.ReferencePixel.y, 0, 0));
            double3 centre = grid.SceneCentre + origin;
            _shader.SetVector(ShaderIDs._SceneCentreExtent,
                new Vector4((float)centre.x, (float)centre.y, (float)centre.z, (float)grid.SceneExtent));
            _shader.SetInt(ShaderIDs._RaysAcross, settings.RaysAcross);
            var region = settings.TracedRegion;
            _shader.SetInts(ShaderIDs._Region,
                region.Left, region.Left + region.Width, region.Bottom, region.Bottom + region.Height);
            _shader.SetInt(ShaderIDs._MaxBounces, settings.MaxBounces);
            _shader.SetFloat(ShaderIDs._LengthUnits, lengthUnits);
            _shader.SetInt(ShaderIDs._Culling, (int)culling);
        }

        public void SetScene(DeviceScene scene)
        {
            if (scene.HasInlineInstances)
            {
                var rows = new Vector4[4 * DeviceScene.MaxInlineInstances];
                var firstRows = new int[DeviceScene.MaxInlineInstances];
                for (int i = 0; i < scene.InlineInstances.Count; i++)
                {
                    var record = scene.InlineInstances[i];
                    (rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]) =
                        (record.ToLocalX, record.ToLocalY, record.ToLocalZ);
                    rows[4 * i + 3] = new Vector4(record.Stretch, record.Rounding);
                    firstRows[i] = (int)record.FirstRow;
                }
                _shader.SetVectorArray(ShaderIDs._InlineToLocal, rows);
                _shader.SetInts(ShaderIDs._InlineFirstRow, firstRows);
                _shader.SetInt(ShaderIDs._InstanceCount, scene.InlineInstances.Count);
            }
            SetBvhs(_kernel, scene);
            SetBvhs(_refineKernel, scene);
        }

        public void SetBuffers(DeviceBuffer<uint> tiles, DeviceBuffer<uint> sums)
        {
            _shader.SetBuffer(_kernel, ShaderIDs._Tiles, tiles.Buffer);
            _shader.SetBuffer(_kernel, ShaderIDs._Sums, sums.Buffer);
            _shader.SetBuffer(_refineKernel, ShaderIDs._Sums, sums.Buffer);
        }

        public void SetEntryPoints(DeviceBuffer<uint4> entryPoints) =>
            _shader.SetBuffer(_kernel, ShaderIDs._EntryPoints, entryPoints.Buffer);

        /// <summary>Finds the entry points of some tiles.</summary>
        public void FindEntryPoints(DeviceScene scene, DeviceBuffer<uint> tiles, int firstTile, int count,
            DeviceBuffer<uint4> entryPoints)
        {
            _shader.SetBuffer(_entryPointsKernel, ShaderIDs._Bvh[0], scene.Pages[0].Rows.Buffer);
            _shader.SetBuffer(_entryPointsKernel, ShaderIDs._Tiles, tiles.Buffer);
            _shader.SetBuffer(_entryPointsKernel, ShaderIDs._FoundEntryPoints, entryPoints.Buffer);
            _shader.SetInt(ShaderIDs._FirstTile, firstTile);
            _shader.SetInt(ShaderIDs._TileCount, count);
            DispatchThreads(_entryPointsKernel, (long)count * scene.InlineInstances.Count);
        }

        /// <summary>Finds the horizons of a BVH in the binary layout and returns the number of dispatches.</summary>
        public int FindHorizons(BvhPage page, int firstRow, BvhPart part)
        {
            int kernel = _shader.FindKernel("FindHorizons"), dispatches = 0;
            _shader.SetBuffer(kernel, ShaderIDs._Bvh[0], page.Rows.Buffer);
            _shader.SetInt(ShaderIDs._BvhFirstRow, firstRow);
            _shader.SetInt(ShaderIDs._BvhFirstLeafRow, part.FirstRecordRow);
            _shader.SetFloat(ShaderIDs._HorizonMargin, (float)part.Margin);
            for (int first = 0; first < part.LeafCount; first += LeavesADispatch, dispatches++)
            {
                int count = math.min(LeavesADispatch, part.LeafCount - first);
                _shader.SetInt(ShaderIDs._FirstLeaf, first);
                _shader.SetInt(ShaderIDs._LeafCount, count);
                DispatchThreads(kernel, 2L * count);
            }
            return dispatches;
        }

        /// <summary>Traces the rays of some tiles and lists candidates.</summary>
        /// <param name="rays">Receives the other rays if all are read back.</param>
        public void Dispatch(int firstTile, int count, RayReadback readback, DeviceBuffer<ReceivedRay> candidates,
            DeviceBuffer<RayData> rays)
        {
            _shader.SetInt(ShaderIDs._FirstTile, firstTile);
            _shader.SetInt(ShaderIDs._TileCount, count);
            SetOutput(_kernel, readback, candidates, rays);
            DispatchThreads(_kernel, (long)count * PictureTiles.Rays);
        }

        /// <summary>Traces listed rays again in double-float arithmetic.</summary>
        /// <param name="subRays">Sub-rays along the side of a pixel: 1 for the ray itself, or 2 to 8.</param>
        public void DispatchRefine(int first, int count, int subRays, RayReadback readback,
            DeviceBuffer<ReceivedRay> candidates,
            DeviceBuffer<RayData> rays)
        {
            _shader.SetInt(ShaderIDs._FirstCandidate, first);
            _shader.SetInt(ShaderIDs._CandidateCount, count);
            _shader.SetInt(ShaderIDs._SubRays, subRays);
            SetOutput(_refineKernel, readback, candidates, rays);
            DispatchThreads(_refineKernel, (long)count * subRays * subRays);
        }

        /// <summary>Traces listed rays in double-float arithmetic and records their reflections.</summary>
        /// <param name="listed">
        /// In: pixel, 0. Out: bounces, with RAY_RECEIVED, and the bits of the distance from the last hit to the
        /// receiver's plane.
        /// </param>
        /// <param name="hits"><see cref="RadarSettings.MaxBounces"/> elements a ray.</param>
        public void DispatchPaths(DeviceScene scene, int count, DeviceBuffer<uint2> listed, DeviceBuffer<HitData> hits)
        {
            SetBvhs(_pathsKernel, scene);
            _shader.SetInt(ShaderIDs._CandidateCount, count);
            _shader.SetBuffer(_pathsKernel, ShaderIDs._Candidates, listed.Buffer);
            _shader.SetBuffer(_pathsKernel, ShaderIDs._Hits, hits.Buffer);
            DispatchThreads(_pathsKernel, count);
        }

        void SetBvhs(int kernel, DeviceScene scene)
        {
            _shader.SetInt(ShaderIDs._InstanceBvhRoot, (int)scene.InstanceBvhRoot);
            _shader.SetBuffer(kernel, ShaderIDs._InstanceBvh, scene.InstanceBvhRows.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Instances, scene.Instances.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Ranges, scene.Ranges.Buffer);
            // Every page that a kernel declares needs a buffer, even if it is not read.
            for (int page = 0; page < DeviceBvhs.MaxPages; page++)
                _shader.SetBuffer(kernel, ShaderIDs._Bvh[page],
                    scene.Pages[page < scene.Pages.Count ? page : 0].Rows.Buffer);
        }

        void SetOutput(int kernel, RayReadback readback, DeviceBuffer<ReceivedRay> candidates,
            DeviceBuffer<RayData> rays)
        {
            _shader.SetInt(ShaderIDs._Readback, (int)readback);
            _shader.SetBuffer(kernel, ShaderIDs._Candidates, candidates.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Rays, rays.Buffer);
        }

        void DispatchThreads(int kernel, long threads)
        {
            _shader.GetKernelThreadGroupSizes(kernel, out uint size, out _, out _);
            int groups = (int)((threads + size - 1) / size);
            _shader.Dispatch(kernel, math.min(groups, GroupsARow), (groups + GroupsARow - 1) / GroupsARow, 1);
        }

        void SetVector((int value, int lo) id, double3 v)
        {
            _shader.SetVector(id.value, new Vector4((float)v.x, (float)v.y, (float)v.z, 0));
            _shader.SetVector(id.lo, new Vector4(DoubleFloat.Lo(v.x), DoubleFloat.Lo(v.y), DoubleFloat.Lo(v.z), 0));
        }

        void SetNumber(int id, double value) =>
            _shader.SetVector(id, new Vector4((float)value, DoubleFloat.Lo(value), 0, 0));
    }

    // Names as in Shaders/Bindings.hlsl.
    static class ShaderIDs
    {
        public static readonly int[] _Bvh = Enumerable.Range(0, DeviceBvhs.MaxPages)
            .Select(page => Shader.PropertyToID("_Bvh" + page)).ToArray();
        public static readonly int _BvhFirstRow = Shader.PropertyToID("_BvhFirstRow");
        public static readonly int _BvhFirstLeafRow = Shader.PropertyToID("_BvhFirstLeafRow");
        public static readonly int _FirstLeaf = Shader.PropertyToID("_FirstLeaf");
        public static readonly int _LeafCount = Shader.PropertyToID("_LeafCount");
        public static readonly int _HorizonMargin = Shader.PropertyToID("_HorizonMargin");
        public static readonly int _InstanceBvh = Shader.PropertyToID("_InstanceBvh");
        public static readonly int _Instances = Shader.PropertyToID("_Instances");
        public static readonly int _Ranges = Shader.PropertyToID("_Ranges");
        public static readonly int _InlineToLocal = Shader.PropertyToID("_InlineToLocal");
        public static readonly int _InlineFirstRow = Shader.PropertyToID("_InlineFirstRow");
        public static readonly int _InstanceCount = Shader.PropertyToID("_InstanceCount");
        public static readonly int _InstanceBvhRoot = Shader.PropertyToID("_InstanceBvhRoot");

        public static readonly (int value, int lo) _Origin = WithLo(nameof(_Origin));
        public static readonly (int value, int lo) _OriginDx = WithLo(nameof(_OriginDx));
        public static readonly (int value, int lo) _OriginDy = WithLo(nameof(_OriginDy));
        public static readonly (int value, int lo) _Direction = WithLo(nameof(_Direction));
        public static readonly (int value, int lo) _DirectionDx = WithLo(nameof(_DirectionDx));
        public static readonly (int value, int lo) _DirectionDy = WithLo(nameof(_DirectionDy));
        public static readonly (int value, int lo) _ReceiverCentre = WithLo(nameof(_ReceiverCentre));
        public static readonly (int value, int lo) _ReceiverRight = WithLo(nameof(_ReceiverRight));
        public static readonly (int value, int lo) _ReceiverUp = WithLo(nameof(_ReceiverUp));
        public static readonly (int value, int lo) _ReceiverForward = WithLo(nameof(_ReceiverForward));
        public static readonly int _ReceiverHalfSize = Shader.PropertyToID("_ReceiverHalfSize");
        public static readonly int _OriginDepth = Shader.PropertyToID("_OriginDepth");
        public static readonly int _ReferencePixel = Shader.PropertyToID("_ReferencePixel");
        public static readonly int _SceneCentreExtent = Shader.PropertyToID("_SceneCentreExtent");
        public static readonly int _RaysAcross = Shader.PropertyToID("_RaysAcross");
        public static readonly int _Region = Shader.PropertyToID("_Region");
        public static readonly int _MaxBounces = Shader.PropertyToID("_MaxBounces");
        public static readonly int _WaveNumberTurns = Shader.PropertyToID("_WaveNumberTurns");

        public static readonly int _Tiles = Shader.PropertyToID("_Tiles");
        public static readonly int _EntryPoints = Shader.PropertyToID("_EntryPoints");
        public static readonly int _FoundEntryPoints = Shader.PropertyToID("_FoundEntryPoints");
        public static readonly int _Hits = Shader.PropertyToID("_Hits");
        public static readonly int _FirstTile = Shader.PropertyToID("_FirstTile");
        public static readonly int _TileCount = Shader.PropertyToID("_TileCount");
        public static readonly int _Culling = Shader.PropertyToID("_Culling");
        public static readonly int _Readback = Shader.PropertyToID("_Readback");
        public static readonly int _FirstCandidate = Shader.PropertyToID("_FirstCandidate");
        public static readonly int _CandidateCount = Shader.PropertyToID("_CandidateCount");
        public static readonly int _SubRays = Shader.PropertyToID("_SubRays");
        public static readonly int _LengthUnits = Shader.PropertyToID("_LengthUnits");

        public static readonly int _Candidates = Shader.PropertyToID("_Candidates");
        public static readonly int _Rays = Shader.PropertyToID("_Rays");
        public static readonly int _Sums = Shader.PropertyToID("_Sums");

        static (int, int) WithLo(string name) => (Shader.PropertyToID(name), Shader.PropertyToID(name + "Lo"));
    }
}
