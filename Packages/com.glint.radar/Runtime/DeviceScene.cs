using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The scene on the device: trees over its meshes, the places of its instances, and a small tree over these.
    /// What a pose does not change stays.
    /// </summary>
    sealed class DeviceScene : IDisposable
    {
        /// <summary>
        /// Instances that are searched one after the other, without a tree: MOST_FEW in Shaders/Bindings.hlsl.
        /// </summary>
        public const int MostFew = 4;

        /// <summary>The row of the root of the tree over instances: ROOT in Shaders/BinaryTree.hlsl.</summary>
        public const int TopRootRow = 1;

        readonly DeviceTrees _trees;
        readonly DeviceBuffer<InstanceRecord> _instances = new DeviceBuffer<InstanceRecord>("instances");
        readonly List<(int instance, TreePart part)> _parts = new List<(int, TreePart)>(); // of each record
        readonly DeviceBuffer<uint4> _top = new DeviceBuffer<uint4>("rows of the tree over instances");
        RadarScene _scene;

        public DeviceScene(TreeShape shape, string owner, long mostRowsABank)
        {
            _trees = new DeviceTrees(shape, owner, mostRowsABank);
            _instances.Reserve(1);
            _top.Reserve(1);
        }

        /// <summary>Null before the first scene.</summary>
        public RadarScene Scene => _scene;

        public DeviceBuffer<InstanceRecord> Instances => _instances;

        public DeviceBuffer<uint4> Top => _top;

        /// <summary>Where the kernel begins: the top tree's first row, or the leaf of the only instance.</summary>
        public uint TopRoot { get; private set; }

        public bool IsEmpty { get; private set; }

        /// <summary>
        /// The instances when they are few and their trees stand in one buffer: then no tree over them is needed.
        /// </summary>
        public IReadOnlyList<InstanceRecord> Few { get; private set; }

        public bool HasFewInstances => Few.Count > 0;

        public IReadOnlyList<TreeBank> Banks => _trees.Banks;

        public long Bytes => _trees.Bytes + _instances.Bytes + _top.Bytes;

        /// <summary>
        /// Corners of the box around everything, metres; the lower one above the other when there is nothing.
        /// </summary>
        public double3 Low { get; private set; }

        public double3 High { get; private set; }

        /// <summary>Middle of the box: the origin of all that the kernel is given.</summary>
        public double3 Middle { get; private set; }

        /// <summary>Takes a scene; builds the trees of meshes that are new.</summary>
        /// <returns>True if a tree was built.</returns>
        public bool Set(RadarScene scene, TraceStatistics statistics, Func<TriangleMesh, TreeShape, MeshTree> build)
        {
            if (_scene != null && IsSame(_scene, scene))
            {
                _scene = scene; // its origin may be another
                return false;
            }
            _scene = null; // until all is there
            bool hasBuilt = _trees.Hold(new HashSet<TriangleMesh>(scene.Instances.Select(instance => instance.Mesh)),
                statistics, build);
            Place(scene, statistics);
            _scene = scene;
            return hasBuilt;
        }

        /// <summary>Marks where in the picture something of the scene can be seen.</summary>
        public void AddTo(PictureTiles tiles)
        {
            foreach (var instance in _scene.Instances)
                tiles.Add(_trees[instance.Mesh].Tree, instance.ToWorld);
        }

        /// <summary>
        /// The triangle of a reflection: its place among the scene's instances and its corners,
        /// as the instance's mesh has them.
        /// </summary>
        public void TriangleOf(in HitData hit, out int instance, out float3 a, out float3 b, out float3 c)
        {
            TreePart part;
            (instance, part) = _parts[(int)hit.Instance];
            part.GetTriangle((int)(hit.Triangle >> 1), (hit.Triangle & 1) != 0, out a, out b, out c);
        }

        public void Dispose()
        {
            _trees.Dispose();
            _instances.Dispose();
            _top.Dispose();
            _scene = null;
        }

        static bool IsSame(RadarScene a, RadarScene b)
        {
            if (a.Instances.Length != b.Instances.Length)
                return false;
            for (int i = 0; i < a.Instances.Length; i++)
                if (a.Instances[i].Mesh != b.Instances[i].Mesh
                    || !a.Instances[i].ToWorld.Equals(b.Instances[i].ToWorld))
                    return false;
            return true;
        }

        // One record for each tree of each instance.
        void Place(RadarScene scene, TraceStatistics statistics)
        {
            var lows = new List<double3>();
            var highs = new List<double3>();
            Low = double.PositiveInfinity;
            High = double.NegativeInfinity;
            foreach (var instance in scene.Instances)
                foreach (var part in _trees[instance.Mesh].Tree.Parts)
                {
                    Bound(part, instance.ToWorld, out var low, out var high);
                    lows.Add(low);
                    highs.Add(high);
                    Low = math.min(Low, low);
                    High = math.max(High, high);
                }
            IsEmpty = lows.Count == 0;
            Middle = IsEmpty ? 0 : (Low + High) / 2;

            var records = new List<InstanceRecord>();
            _parts.Clear();
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var tree = _trees[scene.Instances[i].Mesh];
                var toLocal = scene.Instances[i].ToWorld.Inverse();
                toLocal.Origin = toLocal.Point(Middle);
                for (int part = 0; part < tree.Tree.Parts.Length; part++)
                {
                    records.Add(InstanceRecord.Of(toLocal, tree.BankOf(part), tree.FirstRowOf(part)));
                    _parts.Add((i, tree.Tree.Parts[part]));
                }
            }
            Few = records.Count <= MostFew && _trees.Banks.Count == 1 ? records : new List<InstanceRecord>();
            TopRoot = uint.MaxValue; // DONE: nothing to search
            if (IsEmpty)
                return;
            var top = TopTree.Build(lows.Select(low => Down(low - Middle)).ToArray(),
                highs.Select(high => -Down(Middle - high)).ToArray(), TreeShape.Binary);
            // The root's first row ends with the reference to its first child: of one instance that is the leaf.
            TopRoot = records.Count == 1 ? top[TopRootRow].w : TopRootRow;
            _instances.Upload(records.ToArray());
            _top.Upload(top);
            statistics.BytesUploaded += records.Count * (long)_instances.Stride + top.Length * (long)_top.Stride;
        }

        static void Bound(TreePart part, in Affine toWorld, out double3 low, out double3 high)
        {
            low = double.PositiveInfinity;
            high = double.NegativeInfinity;
            for (int corner = 0; corner < 8; corner++)
            {
                double3 p = toWorld.Point(new Box(part.Low, part.High).Corner(corner));
                low = math.min(low, p);
                high = math.max(high, p);
            }
        }

        // Float32 numbers not above the given ones, by some float32 steps: the kernel's transforms round as well.
        static float3 Down(double3 v) => (float3)(v - 1e-6 * math.abs(v) - 1e-30);
    }
}
