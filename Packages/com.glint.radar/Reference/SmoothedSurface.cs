using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>Normals of curved patches: mean normals at the corners, interpolated over each triangle.</summary>
    sealed class SmoothedSurface
    {
        readonly ReferenceBvh _bvh;

        // Of each triangle in the scene's order: its patch, counted over all instances, and whether that is flat.
        readonly List<int> _patches = new List<int>();
        readonly List<bool> _isFlat = new List<bool>();

        // Three a triangle, in the scene's frame.
        readonly List<double3> _cornerNormals = new List<double3>();

        /// <param name="patches">For each instance of the scene.</param>
        public SmoothedSurface(ReferenceBvh bvh, RadarScene scene, IReadOnlyList<SurfacePatches> patches)
        {
            _bvh = bvh;
            int firstPatch = 0;
            for (int i = 0; i < patches.Count; i++)
            {
                var placed = scene.Instances[i].ToWorld;
                // Normals transform like areas.
                var areas = new Affine
                {
                    X = math.cross(placed.Y, placed.Z), Y = math.cross(placed.Z, placed.X),
                    Z = math.cross(placed.X, placed.Y)
                };
                foreach (int patch in patches[i].PatchOf)
                {
                    _patches.Add(firstPatch + patch);
                    // A triangle without area is in no patch, and no ray hits it.
                    _isFlat.Add(patch == SurfacePatches.NoPatch || patches[i].IsFlat(patch));
                }
                foreach (var normal in patches[i].CornerNormals)
                    _cornerNormals.Add(math.normalizesafe(areas.Vector(normal)));
                firstPatch += patches[i].PatchCount;
            }
        }

        /// <summary>Patch of a triangle of the BVH.</summary>
        public int PatchOf(int triangle) => _patches[_bvh.Number(triangle)];

        /// <summary>The normal at a point of a triangle, on the side from which a ray arrives.</summary>
        public SurfaceNormal At(int triangle, double3 point, double3 direction)
        {
            double3 facet = _bvh.Normal(triangle);
            if (math.dot(facet, direction) > 0)
                facet = -facet;
            var flat = new SurfaceNormal { Facet = facet, Normal = facet };
            int first = 3 * _bvh.Number(triangle);
            if (_isFlat[_bvh.Number(triangle)])
                return flat;
            double3 na = _cornerNormals[first], nb = _cornerNormals[first + 1], nc = _cornerNormals[first + 2];

            // Weights of the corners at the point are 1 - b - c, b and c; across the facet they change by their
            // gradients.
            _bvh.Corners(triangle, out double3 a, out double3 ab, out double3 ac);
            double3 area = math.cross(ab, ac);
            double square = math.dot(area, area);
            double3 gradientB = math.cross(ac, area) / square, gradientC = math.cross(area, ab) / square;
            double b = math.dot(point - a, gradientB), c = math.dot(point - a, gradientC);
            double3 sum = (1 - b - c) * na + b * nb + c * nc;
            double side = math.dot(sum, facet) < 0 ? -1 : 1;
            double length = math.length(sum);
            double3 normal = side / length * sum;
            // A mean normal that looks away from the ray is of no use.
            if (!(math.dot(normal, direction) < 0))
                return flat;
            return new SurfaceNormal
            {
                Facet = facet, Normal = normal, IsCurved = true,
                GradientB = gradientB, GradientC = gradientC,
                ChangeB = side / length * (nb - na), ChangeC = side / length * (nc - na),
            };
        }
    }

    /// <summary>The normal at a hit and how it changes along the surface. Both normals look towards the ray.</summary>
    struct SurfaceNormal
    {
        /// <summary>Normal of the facet.</summary>
        public double3 Facet;

        /// <summary>Normal of the surface that the facets stand for.</summary>
        public double3 Normal;

        /// <summary>Whether the normal changes along the facet.</summary>
        public bool IsCurved;

        /// <summary>Gradients of the weights of the second and third corner.</summary>
        public double3 GradientB, GradientC;

        /// <summary>
        /// Change of the normal per change of these weights, with a component along the normal.
        /// </summary>
        public double3 ChangeB, ChangeC;

        /// <summary>Derivative of the unit normal along a vector of the facet's plane.</summary>
        public double3 Along(double3 step)
        {
            if (!IsCurved)
                return 0;
            double3 change = math.dot(GradientB, step) * ChangeB + math.dot(GradientC, step) * ChangeC;
            return change - math.dot(change, Normal) * Normal;
        }
    }
}
