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
        PlacedInstances[] _placed;

        public DeviceScene(BvhLayout layout, string owner, long maxRowsPerPage)
        {
            _bvhs = new DeviceBvhs(layout, owner, maxRowsPerPage);
            _instances.Reserve(1);
            _ranges.Reserve(1);
            _instanceBvh.Reserve(1);
        }

        /// <summary>Null before the first scene; the first one of several.</summary>
        public RadarScene Scene => _scene;

        public DeviceBuffer<InstanceRecord> Instances => _instances;

        /// <summary>Objects and surfaces of the instances: first triangle, object, surface.</summary>
        public DeviceBuffer<uint4> Ranges => _ranges;

        public DeviceBuffer<uint4> InstanceBvhRows => _instanceBvh;

        /// <summary>Start of the traversal: root of the instance BVH, or the leaf of the only instance.</summary>
        public uint InstanceBvhRoot { get; private set; }

        /// <summary>The scenes: several differ in the places of their instances alone.</summary>
        public IReadOnlyList<PlacedInstances> Placed => _placed;

        public bool IsEmpty => _placed[0].IsEmpty;

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
        public double3 Min => _placed[0].Min;

        public double3 Max => _placed[0].Max;

        /// <summary>Centre of the box: the origin of the kernel's coordinates.</summary>
        public double3 Centre => _placed[0].Centre;

        /// <summary>Sets the scene; builds the BVHs of new meshes.</summary>
        /// <returns>True if a BVH was built.</returns>
        public bool Set(RadarScene scene, TraceStatistics statistics, Func<TriangleMesh, BvhLayout, MeshBvh> build)
        {
            if (_scene != null && _placed.Length == 1 && scene.IsSame(_scene))
            {
                _scene = scene; // its origin may differ
                return false;
            }
            return Set(new[] { scene }, statistics, build);
        }

        /// <summary>
        /// Sets several scenes of the same instances at other places, each in coordinates about its own centre.
        /// </summary>
        /// <returns>True if a BVH was built.</returns>
        public bool Set(RadarScene[] scenes, TraceStatistics statistics, Func<TriangleMesh, BvhLayout, MeshBvh> build)
        {
            _scene = null; // until everything is complete
            bool hasBuilt =
                _bvhs.SetMeshes(new HashSet<TriangleMesh>(scenes[0].Instances.Select(instance => instance.Mesh)),
                    statistics, build);
            SetInstances(scenes, statistics);
            _scene = scenes[0];
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

        void SetInstances(RadarScene[] scenes, TraceStatistics statistics)
        {
            _placed = Array.ConvertAll(scenes, scene => new PlacedInstances(scene, _bvhs));
            InlineInstances = _placed[0].Records.Length <= MaxInlineInstances && _bvhs.Pages.Count == 1
                ? _placed[0].Records : Array.Empty<InstanceRecord>();
            InstanceBvhRoot = uint.MaxValue; // DONE: nothing to traverse
            if (IsEmpty)
                return;
            InstanceBvhRoot = _placed[0].Root;
            var records = _placed.SelectMany(placed => placed.Records).ToArray();
            var rows = _placed.SelectMany(placed => placed.BvhRows).ToArray();
            var ranges = scenes[0].Instances.SelectMany(instance => instance.Ranges).Select(
                range => new uint4((uint)range.FirstTriangle, (uint)range.Object, (uint)range.Surface, 0)).ToArray();
            _instances.Upload(records);
            _instanceBvh.Upload(rows);
            _ranges.Upload(ranges);
            statistics.BytesUploaded += records.Length * (long)_instances.Stride
                + rows.Length * (long)_instanceBvh.Stride + ranges.Length * (long)_ranges.Stride;
        }

        /// <summary>
        /// Moves the instances of the scene to where they are now, about the same centre. It allocates nothing.
        /// </summary>
        public void Move()
        {
            if (IsEmpty)
                return;
            _placed[0].Move(_scene);
            var (records, rows) = (_placed[0].Records, _placed[0].BvhRows);
            _instances.Write(records, 0, 0, records.Length);
            _instanceBvh.Write(rows, 0, 0, rows.Length);
        }
    }
}
