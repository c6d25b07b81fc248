using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The scene on the device: mesh BVHs, instance records and instance BVH. A pose uploads only changes.
    /// </summary>
    sealed class DeviceScene : IDisposable
    {
        /// <summary>
        /// Maximum number of instances that are traversed in a loop, without an instance BVH: MAX_INLINE_INSTANCES in
        /// Shaders/Constants.hlsl.
        /// </summary>
        public const int MaxInlineInstances = 4;

        /// <summary>Row of the root of the instance BVH: ROOT in Shaders/Constants.hlsl.</summary>
        public const int InstanceBvhRootRow = 1;

        readonly DeviceBvhs _bvhs;
        readonly DeviceBuffer<InstanceRecord> _instances = new DeviceBuffer<InstanceRecord>("instances");
        readonly DeviceBuffer<uint4> _ranges = new DeviceBuffer<uint4>("ranges of triangles");
        readonly DeviceBuffer<uint4> _instanceBvh = new DeviceBuffer<uint4>("rows of the BVH over instances");
        RadarScene _scene;

        public DeviceScene(BvhLayout layout, string owner, long maxRowsPerPage)
        {
            _bvhs = new DeviceBvhs(layout, owner, maxRowsPerPage);
            _instances.Reserve(1);
            _ranges.Reserve(1);
            _instanceBvh.Reserve(1);
        }

        /// <summary>Null before the first scene.</summary>
        public RadarScene Scene => _scene;

        public DeviceBuffer<InstanceRecord> Instances => _instances;

        /// <summary>Objects and surfaces of the instances: first triangle, object, surface.</summary>
        public DeviceBuffer<uint4> Ranges => _ranges;

        public DeviceBuffer<uint4> InstanceBvhRows => _instanceBvh;

        /// <summary>Start of the traversal: root of the instance BVH, or the leaf of the only instance.</summary>
        public uint InstanceBvhRoot { get; private set; }

        public bool IsEmpty { get; private set; }

        /// <summary>
        /// The instances, if their number is small and their BVHs are in one page; they need no instance BVH.
        /// </summary>
        public IReadOnlyList<InstanceRecord> InlineInstances { get; private set; }

        public bool HasInlineInstances => InlineInstances.Count > 0;

        public IReadOnlyList<BvhPage> Pages => _bvhs.Pages;

        public long Bytes => _bvhs.Bytes + _instances.Bytes + _instanceBvh.Bytes + _ranges.Bytes;

        /// <summary>
        /// Corners of the box around the scene, metres; the lower one is above the upper one for an empty scene.
        /// </summary>
        public double3 Min { get; private set; }

        public double3 Max { get; private set; }

        /// <summary>Centre of the box: the origin of the kernel's coordinates.</summary>
        public double3 Centre { get; private set; }

        /// <summary>Sets the scene; builds the BVHs of new meshes.</summary>
        /// <returns>True if a BVH was built.</returns>
        public bool Set(RadarScene scene, TraceStatistics statistics, Func<TriangleMesh, BvhLayout, MeshBvh> build)
        {
            if (_scene != null && scene.IsSame(_scene))
            {
                _scene = scene; // its origin may differ
                return false;
            }
            _scene = null; // until everything is complete
            bool hasBuilt =
                _bvhs.SetMeshes(new HashSet<TriangleMesh>(scene.Instances.Select(instance => instance.Mesh)),
                    statistics, build);
            SetInstances(scene, statistics);
            _scene = scene;
            return hasBuilt;
        }

        /// <summary>Refuses a scene whose BVHs need several buffers.</summary>
        /// <param name="subject">What takes one: "a cross section takes".</param>
        /// <param name="wayOut">What to do, beside tracing fewer triangles; may be empty.</param>
        /// <exception cref="GlintException">They need several.</exception>
        public void RequireOnePage(string owner, string subject, string wayOut = "")
        {
            if (Pages.Count > 1)
                throw new GlintException($"{owner}: the BVHs of {_scene.TriangleCount} triangles take {Pages.Count} "
                    + $"buffers of {UnityEngine.SystemInfo.graphicsDeviceName}, and {subject} one: trace fewer "
                    + $"triangles{wayOut}");
        }

        /// <summary>Adds the tiles that may see the scene.</summary>
        public void AddTo(PictureTiles tiles)
        {
            foreach (var instance in _scene.Instances)
                tiles.Add(_bvhs[instance.Mesh].Bvh, instance.ToWorld);
        }

        public void Dispose()
        {
            _bvhs.Dispose();
            _instances.Dispose();
            _instanceBvh.Dispose();
            _ranges.Dispose();
            _scene = null;
        }

        // One record for each BVH of each instance.
        void SetInstances(RadarScene scene, TraceStatistics statistics)
        {
            var mins = new List<double3>();
            var maxes = new List<double3>();
            Min = double.PositiveInfinity;
            Max = double.NegativeInfinity;
            foreach (var instance in scene.Instances)
                foreach (var part in _bvhs[instance.Mesh].Bvh.Parts)
                {
                    Bound(part, instance.ToWorld, out var boxMin, out var boxMax);
                    mins.Add(boxMin);
                    maxes.Add(boxMax);
                    Min = math.min(Min, boxMin);
                    Max = math.max(Max, boxMax);
                }
            IsEmpty = mins.Count == 0;
            Centre = IsEmpty ? 0 : (Min + Max) / 2;

            var records = new List<InstanceRecord>();
            var ranges = new List<uint4>();
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                AddRecords(scene.Instances[i], i, ranges.Count, records);
                ranges.AddRange(scene.Instances[i].Ranges.Select(
                    range => new uint4((uint)range.FirstTriangle, (uint)range.Object, (uint)range.Surface, 0)));
            }
            InlineInstances =
                records.Count <= MaxInlineInstances && _bvhs.Pages.Count == 1 ? records : new List<InstanceRecord>();
            InstanceBvhRoot = uint.MaxValue; // DONE: nothing to traverse
            if (IsEmpty)
                return;
            var instanceBvh = InstanceBvh.Build(mins.Select(lower => Down(lower - Centre)).ToArray(),
                maxes.Select(upper => -Down(Centre - upper)).ToArray(), BvhLayout.Binary);
            // The root's first row ends with the reference to its first child, which is the leaf of a single instance.
            InstanceBvhRoot = records.Count == 1 ? instanceBvh[InstanceBvhRootRow].w : InstanceBvhRootRow;
            _instances.Upload(records.ToArray());
            _instanceBvh.Upload(instanceBvh);
            _ranges.Upload(ranges.ToArray());
            statistics.BytesUploaded += records.Count * (long)_instances.Stride
                + instanceBvh.Length * (long)_instanceBvh.Stride + ranges.Count * (long)_ranges.Stride;
        }

        // One for each BVH of the instance's mesh.
        void AddRecords(in MeshInstance instance, int number, int firstRange, List<InstanceRecord> records)
        {
            var allocation = _bvhs[instance.Mesh];
            var toLocal = instance.ToWorld.Inverse();
            toLocal.Origin = toLocal.Point(Centre);
            for (int i = 0; i < allocation.Bvh.Parts.Length; i++)
            {
                var part = allocation.Bvh.Parts[i];
                var record = InstanceRecord.Of(toLocal, allocation.PageOf(i), allocation.FirstRowOf(i));
                (record.FirstRecordRow, record.FirstIdentityRow) =
                    ((uint)part.FirstRecordRow, (uint)part.FirstIdentityRow);
                (record.FirstRange, record.RangeCount) = ((uint)firstRange, (uint)instance.Ranges.Length);
                record.Instance = (uint)number;
                records.Add(record);
            }
        }

        static void Bound(BvhPart part, in Affine toWorld, out double3 boxMin, out double3 boxMax)
        {
            boxMin = double.PositiveInfinity;
            boxMax = double.NegativeInfinity;
            for (int corner = 0; corner < 8; corner++)
            {
                double3 p = toWorld.Point(new Box(part.Min, part.Max).Corner(corner));
                boxMin = math.min(boxMin, p);
                boxMax = math.max(boxMax, p);
            }
        }

        // Float32 numbers below the given ones by some float32 steps, as the kernel's transforms round too.
        static float3 Down(double3 v) => (float3)(v - 1e-6 * math.abs(v) - 1e-30);
    }
}
