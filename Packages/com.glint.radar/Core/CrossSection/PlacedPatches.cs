using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>An instance of a scene with the patches of its mesh, measured in the scene's frame.</summary>
    public readonly struct PlacedPatches
    {
        readonly Affine _toWorld;
        readonly double3 _acrossX, _acrossY, _acrossZ; // images of the areas across the unit vectors

        /// <summary>An instance with its patches.</summary>
        /// <exception cref="GlintException">The patches are not those of its mesh.</exception>
        public PlacedPatches(in MeshInstance instance, SurfacePatches patches)
        {
            if (patches.Welded.Mesh != instance.Mesh)
                throw new GlintException(
                    $"patches of a mesh of {patches.Welded.Mesh.TriangleCount} triangles were given for an instance of "
                    + $"another one, of {instance.Mesh.TriangleCount}; find the patches of the scene's meshes");
            Patches = patches;
            _toWorld = instance.ToWorld;
            _acrossX = math.cross(_toWorld.Y, _toWorld.Z);
            _acrossY = math.cross(_toWorld.Z, _toWorld.X);
            _acrossZ = math.cross(_toWorld.X, _toWorld.Y);
        }

        /// <summary>The patches.</summary>
        public SurfacePatches Patches { get; }

        /// <summary>The mesh with its edges.</summary>
        public WeldedMesh Welded => Patches.Welded;

        /// <summary>All instances of a scene with their patches.</summary>
        /// <exception cref="GlintException">The patches are not those of the scene's meshes.</exception>
        public static PlacedPatches[] Of(RadarScene scene, IReadOnlyList<SurfacePatches> patches)
        {
            if (patches.Count != scene.Instances.Length)
                throw new GlintException($"patches of {patches.Count} meshes were given for a scene of "
                    + $"{scene.Instances.Length} instances; give one for each");
            var placed = new PlacedPatches[patches.Count];
            for (int i = 0; i < placed.Length; i++)
                placed[i] = new PlacedPatches(scene.Instances[i], patches[i]);
            return placed;
        }

        /// <summary>Position of a corner, metres.</summary>
        public double3 Point(int corner) => _toWorld.Point(Welded.Mesh.Vertices[Welded.Corners[corner]]);

        /// <summary>Unit vector along a side.</summary>
        public double3 Along(int side) => math.normalizesafe(Point(WeldedMesh.EndOf(side)) - Point(side));

        /// <summary>Unit normal of a triangle by its winding; 0 if it has none.</summary>
        public double3 Normal(int triangle)
        {
            double3 normal = Patches.Normals[triangle];
            return math.normalizesafe(normal.x * _acrossX + normal.y * _acrossY + normal.z * _acrossZ);
        }

        /// <summary>Twice the area of a triangle, m2.</summary>
        public double TwiceArea(int triangle)
        {
            double3 a = Point(3 * triangle);
            return math.length(math.cross(Point(3 * triangle + 1) - a, Point(3 * triangle + 2) - a));
        }

        /// <summary>Width of a facet across one of its sides: the height over it, metres.</summary>
        public double Width(int side) =>
            TwiceArea(side / 3) / math.distance(Point(side), Point(WeldedMesh.EndOf(side)));

        /// <summary>The bend at an edge of two triangles, radians from 0 (flat) to pi (folded).</summary>
        public double Bend(int side, int other)
        {
            double3 a = Normal(side / 3), b = Normal(other / 3);
            if (!Welded.AreOpposed(side, other))
                b = -b;
            return math.atan2(math.length(math.cross(a, b)), math.dot(a, b));
        }
    }
}
