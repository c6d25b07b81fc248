using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// The curved surfaces that facets stand for: mean normals at the corners, interpolated over each triangle, and a
    /// height over it that fits them.
    /// </summary>
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

        /// <summary>
        /// Distance by which a ray meets the curved surface before a triangle, metres; below 0: behind it.
        /// </summary>
        /// <param name="point">Where it meets the triangle.</param>
        public double LeadOf(int triangle, double3 point, double3 direction)
        {
            int first = 3 * _bvh.Number(triangle);
            if (_isFlat[_bvh.Number(triangle)])
                return 0;
            var over = new Barycentric(_bvh, triangle);
            double3 facet = Facing(triangle, direction);
            double3 na = _cornerNormals[first], nb = _cornerNormals[first + 1], nc = _cornerNormals[first + 2];
            double3 sum = over.Interpolate(point, na, nb, nc);
            double size = math.length(sum) * (math.dot(sum, facet) < 0 ? -1 : 1);

            // Along a side from i to j the surface leaves the plane by half of (n_j - n_i).(j - i), and returns as steeply.
            double riseB = math.dot(nb - na, over.AB) / (2 * size), riseC = math.dot(nc - na, over.AC) / (2 * size),
                riseBC = math.dot(nc - nb, over.AC - over.AB) / (2 * size);
            double Gap(double back)
            {
                over.WeightsAt(point - back * direction, out double b, out double c);
                return (1 - b - c) * (b * riseB + c * riseC) + b * c * riseBC + back * math.dot(direction, facet);
            }

            // The gap between ray and surface is a quadratic function of the way back: 3 values give it.
            double step = math.length(over.AB), here = Gap(0), back = Gap(step), ahead = Gap(-step);
            double bend = (2 * here - back - ahead) / (step * step), closing = (ahead - back) / (2 * step);
            double square = closing * closing + 2 * bend * here, lead = 0;
            if (closing > 0)
                lead = 2 * here / (closing + Math.Sqrt(Math.Max(square, closing * closing / 4)));
            // A ray that meets the part of a facet where the surface looks away has met it before.
            else if (bend > 0 && square > 0)
                lead = (Math.Sqrt(square) - closing) / bend;
            // The surface is known over the facet only: there weights change by less than 1.
            double stepB = math.dot(direction, over.GradientB), stepC = math.dot(direction, over.GradientC);
            double reach = 1 / Math.Max(Math.Max(Math.Abs(stepB), Math.Abs(stepC)), Math.Abs(stepB + stepC));
            return Math.Clamp(lead, -reach, reach);
        }

        /// <summary>The normal at a point over a triangle, on the side from which a ray arrives.</summary>
        public SurfaceNormal At(int triangle, double3 point, double3 direction)
        {
            double3 facet = Facing(triangle, direction);
            var flat = new SurfaceNormal { Facet = facet, Normal = facet };
            int first = 3 * _bvh.Number(triangle);
            if (_isFlat[_bvh.Number(triangle)])
                return flat;
            var over = new Barycentric(_bvh, triangle);
            double3 na = _cornerNormals[first], nb = _cornerNormals[first + 1], nc = _cornerNormals[first + 2];
            double3 sum = over.Interpolate(point, na, nb, nc);
            double side = math.dot(sum, facet) < 0 ? -1 : 1;
            double length = math.length(sum);
            double3 normal = side / length * sum;
            // A mean normal that looks away from the ray is of no use.
            if (!(math.dot(normal, direction) < 0))
                return flat;
            return new SurfaceNormal
            {
                Facet = facet, Normal = normal, IsCurved = true,
                GradientB = over.GradientB, GradientC = over.GradientC,
                ChangeB = side / length * (nb - na), ChangeC = side / length * (nc - na),
            };
        }

        double3 Facing(int triangle, double3 direction)
        {
            double3 facet = _bvh.Normal(triangle);
            return math.dot(facet, direction) > 0 ? -facet : facet;
        }

        // Weights of the corners over a triangle: 1 - b - c, b and c.
        readonly struct Barycentric
        {
            readonly double3 _a;
            public readonly double3 AB, AC, GradientB, GradientC;

            public Barycentric(ReferenceBvh bvh, int triangle)
            {
                bvh.Corners(triangle, out _a, out AB, out AC);
                double3 area = math.cross(AB, AC);
                double square = math.dot(area, area);
                GradientB = math.cross(AC, area) / square;
                GradientC = math.cross(area, AB) / square;
            }

            public void WeightsAt(double3 point, out double b, out double c) =>
                (b, c) = (math.dot(point - _a, GradientB), math.dot(point - _a, GradientC));

            public double3 Interpolate(double3 point, double3 atA, double3 atB, double3 atC)
            {
                WeightsAt(point, out double b, out double c);
                return (1 - b - c) * atA + b * atB + c * atC;
            }
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

        /// <summary>Derivative of the unit normal along a vector of the surface.</summary>
        public double3 Along(double3 step)
        {
            if (!IsCurved)
                return 0;
            double3 change = math.dot(GradientB, step) * ChangeB + math.dot(GradientC, step) * ChangeC;
            return change - math.dot(change, Normal) * Normal;
        }
    }
}
