using System;
using System.Runtime.CompilerServices;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>The kernels of Shaders/Trace.compute, or of TraceWide.compute, and their inputs.</summary>
    sealed class TraceKernel
    {
        // GROUPS_A_ROW in Shaders/Constants.hlsl.
        internal const int GroupsARow = 64;

        /// <summary>Maximum tiles of one dispatch, by the limit of thread groups.</summary>
        public const int MaxTiles = 65535 * GroupsARow;

        // By Trace.compute: how often its inputs were set.
        static readonly ConditionalWeakTable<ComputeShader, StrongBox<int>> s_settings =
            new ConditionalWeakTable<ComputeShader, StrongBox<int>>();

        readonly ComputeShader _shader;
        readonly StrongBox<int> _settings;
        readonly string _name;
        readonly string _refineName, _fused;
        readonly int _entryPointsKernel, _pathsKernel;
        int _kernel, _refineKernel;
        bool _hasLengths;
        int2 _cellSize;

        /// <param name="shader">Shaders/Trace.compute.</param>
        /// <param name="isWide">Take the kernels of <see cref="SoftwareDevice.WideShader"/> instead.</param>
        /// <exception cref="GlintException">
        /// There is no graphics device, the shader is another one, or the device cannot run it.
        /// </exception>
        public TraceKernel(ComputeShader shader, bool isWide, string owner)
        {
            DeviceCheck.Require(shader, "Trace", "Trace", owner);
            IsWide = isWide;
            _settings = s_settings.GetOrCreateValue(shader);
            _shader = isWide ? SoftwareDevice.WideShader : shader;
            if (_shader == null)
                throw new InvalidOperationException("the wide kernels are not there: only the headless host has them");
            string suffix = isWide ? "Wide" : "";
            _name = "Trace" + suffix;
            _kernel = _shader.FindKernel(_name);
            _entryPointsKernel = _shader.FindKernel("EntryPoints" + suffix);
            _refineName = "Refine" + suffix;
            DeviceArithmetic.Check(shader);
            _fused = !isWide && DeviceArithmetic.IsFused(shader) ? "Fused" : "";
            _refineKernel = _shader.FindKernel(_refineName + _fused);
            _pathsKernel = _shader.FindKernel("Paths" + suffix);
            DeviceCheck.RequireSupported(_shader, _kernel, _entryPointsKernel, _refineKernel, _pathsKernel);
        }

        /// <summary>
        /// Number of the kernels' inputs. They belong to the shader, an asset that tracers share: whoever is about to set
        /// them counts up, and those of a pose are set while the number is that of its own.
        /// </summary>
        public int Inputs
        {
            get => _settings.Value;
            set => _settings.Value = value;
        }

        /// <summary>Whether the kernels are those for software devices.</summary>
        public bool IsWide { get; }

        /// <summary>Chooses the kernels for a scene; the other methods set and run these.</summary>
        public void Choose(DeviceScene scene, bool countsVisits)
        {
            // The loop over instances costs a software device a tenth of its time, even for one instance.
            string kind = countsVisits ? "Count"
                : !scene.HasInlineInstances ? scene.Pages.Count > 1 ? "Paged" : ""
                : IsWide && scene.InlineInstances.Count == 1 ? "SingleInstance" : "InlineInstances";
            _kernel = _shader.FindKernel(_name + kind);
            _refineKernel = _shader.FindKernel(_refineName + (scene.Pages.Count > 1 ? "Paged" : _fused));
        }

        public void SetRadar(in RadarSettings settings, in RadarView view, RayGrid grid, double3 origin,
            float lengthUnits, Culling culling)
        {
            _shader.SetRays(grid);
            _shader.SetReceiver(view, grid);
            _shader.SetNumber(ShaderIDs._WaveNumberTurns, 1 / settings.Wavelength);
            double3 centre = grid.SceneCentre + origin;
            _shader.SetVector(ShaderIDs._SceneCentreExtent,
                new Vector4((float)centre.x, (float)centre.y, (float)centre.z, (float)grid.SceneExtent));
            _shader.SetInt(ShaderIDs._RaysAcross, settings.RaysAcross);
            _shader.SetInts(ShaderIDs._Region, RegionOf(settings));
            _shader.SetInt(ShaderIDs._MaxBounces, settings.MaxBounces);
            _shader.SetFloat(ShaderIDs._LengthUnits, lengthUnits);
            _shader.SetInt(ShaderIDs._Culling, (int)culling);
        }

        public void SetScene(DeviceScene scene)
        {
            if (scene.HasInlineInstances)
            {
                var rows = new Vector4[4 * DeviceScene.MaxInlineInstances];
                var inlineRows = new int[4 * DeviceScene.MaxInlineInstances];
                for (int i = 0; i < scene.InlineInstances.Count; i++)
                {
                    var record = scene.InlineInstances[i];
                    (rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]) =
                        (record.ToLocalX, record.ToLocalY, record.ToLocalZ);
                    rows[4 * i + 3] = new Vector4(record.Stretch, record.Rounding);
                    new[]
                    {
                        (int)record.FirstRow, (int)record.FirstRecordRow, (int)record.FirstIdentityRow,
                        (int)record.Instance
                    }.CopyTo(inlineRows, 4 * i);
                }
                _shader.SetVectorArray(ShaderIDs._InlineToLocal, rows);
                _shader.SetInts(ShaderIDs._InlineRows, inlineRows);
                _shader.SetInt(ShaderIDs._InstanceCount, scene.InlineInstances.Count);
            }
            _shader.SetBvhs(_kernel, scene);
            _shader.SetBvhs(_refineKernel, scene);
        }

        /// <inheritdoc cref="StageKernels.SetLists"/>
        public void SetLists(CandidateList ofRays, CandidateList ofSubRays)
        {
            _shader.SetInts(ShaderIDs._KnownCapacity, ofRays.KnownCapacity, ofSubRays.KnownCapacity, 0, 0);
            _shader.SetInt(ShaderIDs._MaxSpread, ofRays.MaxSpread);
        }

        /// <summary>Threads of a group of the kernel that traces, and of the one that refines.</summary>
        public int TraceGroup => _shader.GroupOf(_kernel);

        /// <inheritdoc cref="TraceGroup"/>
        public int RefineGroup => _shader.GroupOf(_refineKernel);

        /// <summary>First and end column, first and end row of the rays traced.</summary>
        public static int[] RegionOf(in RadarSettings settings)
        {
            var region = settings.TracedRegion;
            return new[] { region.Left, region.Left + region.Width, region.Bottom, region.Bottom + region.Height };
        }

        /// <summary>Sets the number of tiles across and down a cell.</summary>
        public void SetCellSize(int2 size)
        {
            _cellSize = size;
            _shader.SetVector(ShaderIDs._CellInverse, new Vector4(1f / (size.x * size.y), 1f / size.x));
        }

        /// <summary>Sets the buffers of a slice.</summary>
        /// <param name="lengths">Lengths by pixel; null: they are not kept.</param>
        public void SetBuffers(DeviceBuffer<uint> cells, SliceOutput output, DeviceBuffer<RayData> rays,
            DeviceBuffer<uint> subRayPixels, DeviceBuffer<uint> lengths, RayReadback readback)
        {
            _shader.SetBuffer(_kernel, ShaderIDs._Cells, cells.Buffer);
            _shader.SetBuffer(_kernel, ShaderIDs._SubRayPixels, subRayPixels.Buffer);
            _shader.SetBuffer(_refineKernel, ShaderIDs._Lengths, (lengths ?? subRayPixels).Buffer);
            foreach (int kernel in new[] { _kernel, _refineKernel })
            {
                _shader.SetBuffer(kernel, ShaderIDs._Sums, output.Buffer.Buffer);
                _shader.SetBuffer(kernel, ShaderIDs._Rays, rays.Buffer);
            }
            _shader.SetInt(ShaderIDs._Readback, (int)readback);
            _shader.SetInt(ShaderIDs._ReceivedCapacity, output.Capacity);
            _hasLengths = lengths != null;
        }

        public void SetEntryPoints(DeviceBuffer<uint4> entryPoints) =>
            _shader.SetBuffer(_kernel, ShaderIDs._EntryPoints, entryPoints.Buffer);

        /// <summary>Finds the entry points of the plan's slice.</summary>
        public void FindEntryPoints(DeviceScene scene, DeviceBuffer<uint> cells, DispatchPlan plan,
            DeviceBuffer<uint4> entryPoints)
        {
            _shader.SetBuffer(_entryPointsKernel, ShaderIDs._Bvh[0], scene.Pages[0].Rows.Buffer);
            _shader.SetBuffer(_entryPointsKernel, ShaderIDs._Cells, cells.Buffer);
            _shader.SetBuffer(_entryPointsKernel, ShaderIDs._FoundEntryPoints, entryPoints.Buffer);
            SetTiles(plan.First, plan.Count);
            _shader.DispatchThreads(_entryPointsKernel, (long)plan.Cells * scene.InlineInstances.Count);
        }

        /// <summary>Traces the rays of some tiles and lists candidates.</summary>
        public void TraceTiles(int firstTile, int count, CandidateList candidates)
        {
            SetTiles(firstTile, count);
            SetCandidates(_kernel, candidates, hasSubRays: false);
            _shader.DispatchThreads(_kernel, (long)count * PictureTiles.Rays);
        }

        /// <summary>Traces the sub-rays of chosen pixels and lists candidates.</summary>
        /// <param name="pixels">Number of pixels; null: that of the device, by <paramref name="arguments"/>.</param>
        public void TraceSubRays(CandidateList candidates, GraphicsBuffer arguments, int? pixels = null)
        {
            SetCandidates(_kernel, candidates, hasSubRays: true);
            if (pixels.HasValue)
                _shader.DispatchThreads(_kernel, (long)pixels.Value * SamplingEstimate.SubGrids);
            else
                _shader.DispatchIndirect(_kernel, arguments, SliceArguments.SubRays);
        }

        /// <summary>Follows candidates in double-float arithmetic.</summary>
        /// <param name="first">The candidates to search before it were followed by earlier dispatches.</param>
        /// <param name="firstReceived">Rays received by these.</param>
        /// <param name="threads">Number of threads; null: by <paramref name="arguments"/>.</param>
        public void Refine(CandidateList candidates, bool areSubRays, GraphicsBuffer arguments, int? threads = null,
            int first = 0, int firstReceived = 0)
        {
            SetCandidates(_refineKernel, candidates, areSubRays);
            _shader.SetInt(ShaderIDs._FirstSearched, first);
            _shader.SetInt(ShaderIDs._FirstReceived, firstReceived);
            _shader.SetInt(ShaderIDs._HasLengths, _hasLengths && first == 0 ? 1 : 0);
            if (threads.HasValue)
                _shader.DispatchThreads(_refineKernel, threads.Value);
            else
                _shader.DispatchIndirect(_refineKernel, arguments,
                    areSubRays ? SliceArguments.RefineSubRays : SliceArguments.Refine);
        }

        /// <summary>Traces listed rays in double-float arithmetic and records their reflections.</summary>
        /// <param name="listed">
        /// In: pixel, 0. Out: bounces, with RAY_RECEIVED, and the bits of the distance from the last hit to the
        /// receiver's plane.
        /// </param>
        /// <param name="hits"><see cref="RadarSettings.MaxBounces"/> elements a ray.</param>
        public void DispatchPaths(DeviceScene scene, int count, DeviceBuffer<uint2> listed, DeviceBuffer<HitData> hits)
        {
            _shader.SetBvhs(_pathsKernel, scene);
            _shader.SetInt(ShaderIDs._PathCount, count);
            _shader.SetBuffer(_pathsKernel, ShaderIDs._Candidates, listed.Buffer);
            _shader.SetBuffer(_pathsKernel, ShaderIDs._Hits, hits.Buffer);
            _shader.DispatchThreads(_pathsKernel, count);
        }

        void SetTiles(int first, int count)
        {
            int tilesPerCell = _cellSize.x * _cellSize.y;
            _shader.SetInts(ShaderIDs._CellSize, _cellSize.x, _cellSize.y, first / tilesPerCell, first % tilesPerCell);
            _shader.SetInt(ShaderIDs._TileCount, count);
        }

        void SetCandidates(int kernel, CandidateList candidates, bool hasSubRays)
        {
            _shader.SetInt(ShaderIDs._HasSubRays, hasSubRays ? 1 : 0);
            _shader.SetBuffer(kernel, ShaderIDs._Candidates, candidates.Rays.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Met, candidates.Met.Buffer);
        }
    }
}
