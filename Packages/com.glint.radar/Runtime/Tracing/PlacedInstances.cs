using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The instances of a scene as the kernels see them, one for each BVH of their meshes, about the centre of the scene.
    /// </summary>
    sealed class PlacedInstances
    {
        readonly DeviceBvhs _bvhs;
        readonly float3[] _boxMins, _boxMaxes;

        public PlacedInstances(RadarScene scene, DeviceBvhs bvhs)
        {
            _bvhs = bvhs;
            Min = double.PositiveInfinity;
            Max = double.NegativeInfinity;
            int count = 0;
            foreach (var instance in scene.Instances)
                foreach (var part in bvhs[instance.Mesh].Bvh.Parts)
                {
                    Bound(part, instance.ToWorld, out var boxMin, out var boxMax);
                    (Min, Max) = (math.min(Min, boxMin), math.max(Max, boxMax));
                    count++;
                }
            IsEmpty = count == 0;
            Centre = IsEmpty ? 0 : (Min + Max) / 2;
            (Records, _boxMins, _boxMaxes) = (new InstanceRecord[count], new float3[count], new float3[count]);
            Write(scene);
            BvhRows = InstanceBvh.Build(_boxMins, _boxMaxes, BvhLayout.Binary);
        }

        public bool IsEmpty { get; }

        /// <summary>
        /// Corners of the box around the scene, metres; the lower one is above the upper one for an empty scene.
        /// </summary>
        public double3 Min { get; }

        public double3 Max { get; }

        /// <summary>Centre of the box: the origin of the kernel's coordinates.</summary>
        public double3 Centre { get; }

        public InstanceRecord[] Records { get; }

        /// <summary>The BVH over the instances; empty for an empty scene.</summary>
        public uint4[] BvhRows { get; }

        /// <summary>Start of the traversal: root of the BVH, or the leaf of the only instance.</summary>
        // The root's first row ends with the reference to its first child, which is the leaf of a single instance.
        public uint Root => Records.Length == 1 ? BvhRows[DeviceScene.InstanceBvhRootRow].w : DeviceScene.InstanceBvhRootRow;

        /// <summary>
        /// Moves the instances to where those of the scene are now, about the same centre. It allocates nothing.
        /// </summary>
        public void Move(RadarScene scene)
        {
            Write(scene);
            InstanceBvh.Refit(BvhRows, _boxMins, _boxMaxes);
        }

        void Write(RadarScene scene)
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
                    Records[count] = RecordOf(scene.Instances[i], i, part, firstRange);
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
