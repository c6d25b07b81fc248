using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The traced scene: instances of meshes.
    /// The BVHs over a mesh are kept while the same TriangleMesh recurs; changing a transform costs nothing.
    /// </summary>
    public sealed class RadarScene
    {
        /// <summary>A scene of instances.</summary>
        /// <param name="instances">Kept, not copied.</param>
        public RadarScene(params MeshInstance[] instances) => Instances = instances;

        /// <summary>A scene of one mesh in the world's axes.</summary>
        public RadarScene(TriangleMesh mesh)
            : this(new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity })
        {
        }

        /// <summary>The instances, in the order in which triangles are counted.</summary>
        public MeshInstance[] Instances { get; }

        /// <summary>
        /// Surfaces that ranges of the instances' triangles refer to; the first is the perfect conductor.
        /// </summary>
        public IReadOnlyList<SurfaceMaterial> Surfaces { get; set; } = new[] { SurfaceMaterial.PerfectConductor };

        /// <summary>Seas with a diffuse echo; empty if all are mirrors.</summary>
        public IReadOnlyList<RadarSea> Seas { get; set; } = Array.Empty<RadarSea>();

        /// <summary>
        /// Position of the scene's origin in the world, metres, for output; the axes are the world's. Tracing does not
        /// use it.
        /// </summary>
        public double3 Origin { get; set; }

        /// <summary>
        /// Whether both have the same meshes at the same places, with the same motions, ranges, surfaces and
        /// seas.
        /// </summary>
        public bool IsSame(RadarScene other) =>
            Instances.AsSpan().SequenceEqual(other.Instances) && Surfaces.SequenceEqual(other.Surfaces)
            && Seas.SequenceEqual(other.Seas);

        /// <summary>The box around all triangles, metres; its corners are infinite if there are none.</summary>
        public (double3 Min, double3 Max) Bound() => Bound(Instances);

        /// <summary>The instances that are tiles of seas.</summary>
        public HashSet<int> SeaInstances() =>
            new HashSet<int>(Seas.SelectMany(sea => sea.Tiles).Select(tile => tile.Instance));

        /// <summary>
        /// The box around what is no sea, metres: the size of the target, whatever the extent of the water around it.
        /// Of seas alone, and without any, that around all triangles.
        /// </summary>
        /// <param name="all">The box around all triangles.</param>
        public (double3 Min, double3 Max) BoundTarget((double3 Min, double3 Max) all)
        {
            if (Seas.Count == 0)
                return all;
            var tiles = SeaInstances();
            var others = Instances.Where((instance, number) => !tiles.Contains(number)).ToArray();
            return others.Length == 0 ? all : Bound(others);
        }

        static (double3 Min, double3 Max) Bound(MeshInstance[] instances)
        {
            double3 boxMin = double.PositiveInfinity, boxMax = double.NegativeInfinity;
            // Tiles of a sea have one mesh and one direction.
            foreach (var group in instances.GroupBy(it => (it.Mesh, it.ToWorld.X, it.ToWorld.Y, it.ToWorld.Z)))
            {
                var toWorld = group.First().ToWorld;
                double3 low = double.PositiveInfinity, high = double.NegativeInfinity;
                foreach (int index in group.Key.Mesh.Indices)
                {
                    double3 vector = toWorld.Vector(group.Key.Mesh.Vertices[index]);
                    (low, high) = (math.min(low, vector), math.max(high, vector));
                }
                foreach (var instance in group)
                    (boxMin, boxMax) = (math.min(boxMin, low + instance.ToWorld.Origin),
                        math.max(boxMax, high + instance.ToWorld.Origin));
            }
            return (boxMin, boxMax);
        }

        /// <summary>Whether an instance moves.</summary>
        public bool IsMoving => Instances.Any(instance => !instance.Motion.IsNone);

        /// <summary>The scene with a motion of all its instances.</summary>
        public RadarScene MovingBy(RigidMotion motion) => new RadarScene(Array.ConvertAll(Instances, instance =>
        {
            instance.Motion = motion;
            return instance;
        }))
        { Surfaces = Surfaces, Seas = Seas, Origin = Origin };

        /// <summary>Triangles of all instances.</summary>
        public long TriangleCount => Instances.Sum(instance => (long)instance.Mesh.TriangleCount);
    }
}
