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

        // Of the instances, one for each BVH: records, and boxes about the centre.
        InstanceRecord[] _records;
        float3[] _boxMins, _boxMaxes;
        uint4[] _instanceBvhOnHost;

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
            Measure(scene);
            var ranges = scene.Instances.SelectMany(instance => instance.Ranges).Select(
                range => new uint4((uint)range.FirstTriangle, (uint)range.Object, (uint)range.Surface, 0)).ToArray();
            WriteRecords(scene);
            InlineInstances = _records.Length <= MaxInlineInstances && _bvhs.Pages.Count == 1
                ? _records : Array.Empty<InstanceRecord>();
            InstanceBvhRoot = uint.MaxValue; // DONE: nothing to traverse
            if (IsEmpty)
                return;
            _instanceBvhOnHost = InstanceBvh.Build(_boxMins, _boxMaxes, BvhLayout.Binary);
            // The root's first row ends with the reference to its first child, which is the leaf of a single instance.
            InstanceBvhRoot = _records.Length == 1 ? _instanceBvhOnHost[InstanceBvhRootRow].w : InstanceBvhRootRow;
            _instances.Upload(_records);
            _instanceBvh.Upload(_instanceBvhOnHost);
            _ranges.Upload(ranges);
            statistics.BytesUploaded += _records.Length * (long)_instances.Stride
                + _instanceBvhOnHost.Length * (long)_instanceBvh.Stride + ranges.Length * (long)_ranges.Stride;
        }

        /// <summary>
        /// Moves the instances of the scene to where they are now, about the same centre. It allocates nothing.
        /// </summary>
        public void Move()
        {
            if (IsEmpty)
                return;
            WriteRecords(_scene);
            InstanceBvh.Refit(_instanceBvhOnHost, _boxMins, _boxMaxes);
            _instances.Write(_records, 0, 0, _records.Length);
            _instanceBvh.Write(_instanceBvhOnHost, 0, 0, _instanceBvhOnHost.Length);
        }

        // The box around the scene, and room for its records.
        void Measure(RadarScene scene)
        {
            Min = double.PositiveInfinity;
            Max = double.NegativeInfinity;
            int count = 0;
            foreach (var instance in scene.Instances)
                foreach (var part in _bvhs[instance.Mesh].Bvh.Parts)
                {
                    Bound(part, instance.ToWorld, out var boxMin, out var boxMax);
                    (Min, Max) = (math.min(Min, boxMin), math.max(Max, boxMax));
                    count++;
                }
            IsEmpty = count == 0;
            Centre = IsEmpty ? 0 : (Min + Max) / 2;
            (_records, _boxMins, _boxMaxes) = (new InstanceRecord[count], new float3[count], new float3[count]);
        }

        void WriteRecords(RadarScene scene)
        {
            int count = 0, firstRange = 0;
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var toWorld = scene.Instances[i].ToWorld;
                var parts = _bvhs[scene.Instances[i].Mesh].Bvh.Parts;
                for (int part = 0; part < parts.Length; part++, count++)
                {
                    Bound(parts[part], toWorld, out var boxMin, out var boxMax);
                    (_boxMins[count], _boxMaxes[count]) = (Down(boxMin - Centre), -Down(Centre - boxMax));
                    _records[count] = RecordOf(scene.Instances[i], i, part, firstRange);
                }
                firstRange += scene.Instances[i].Ranges.Length;
            }
        }

        // That of one BVH of the instance's mesh.
        InstanceRecord RecordOf(in MeshInstance instance, int number, int part, int firstRange)
        {
            var allocation = _bvhs[instance.Mesh];
            var toLocal = instance.ToWorld.Inverse();
            toLocal.Origin = toLocal.Point(Centre);
            var rows = allocation.Bvh.Parts[part];
            var record = InstanceRecord.Of(toLocal, allocation.PageOf(part), allocation.FirstRowOf(part));
            (record.FirstRecordRow, record.FirstIdentityRow) = ((uint)rows.FirstRecordRow, (uint)rows.FirstIdentityRow);
            (record.FirstRange, record.RangeCount) = ((uint)firstRange, (uint)instance.Ranges.Length);
            record.Instance = (uint)number;
            return record;
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
