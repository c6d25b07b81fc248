using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>A rectangle about a flat patch, in its plane, metres.</summary>
    readonly struct PatchRectangle
    {
        readonly double3 _centre, _along, _normal;
        readonly double2 _halfSize;

        PatchRectangle(double3 centre, double3 along, double3 normal, double2 halfSize) =>
            (_centre, _along, _normal, _halfSize) = (centre, along, normal, halfSize);

        public double Area => 4 * _halfSize.x * _halfSize.y;

        /// <summary>Of the shorter side.</summary>
        public double Width => 2 * math.cmin(_halfSize);

        /// <summary>MIRROR_ROWS in Shaders/TubeBindings.hlsl.</summary>
        public IEnumerable<float4> Rows() => new[]
        {
            TubePose.RowOf(_centre, _halfSize.x), TubePose.RowOf(_along, _halfSize.y), TubePose.RowOf(_normal)
        };

        /// <summary>Those about the flat patches of a mesh.</summary>
        /// <param name="placeOf">Of a corner of the mesh.</param>
        public static IEnumerable<PatchRectangle> Of(SurfacePatches patches, Func<int, double3> placeOf) =>
            patches.FlatPatches.Select(triangles => About(triangles
                .SelectMany(triangle => Enumerable.Range(3 * triangle, 3)).Select(placeOf).ToArray()));

        // Corners: three of each triangle. Along the longest side.
        static PatchRectangle About(double3[] corners)
        {
            double3 normal = 0, along = 0;
            for (int i = 0; i < corners.Length; i += 3)
            {
                normal += math.cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
                for (int side = 0; side < 3; side++)
                {
                    double3 step = corners[i + (side + 1) % 3] - corners[i + side];
                    along = math.lengthsq(step) > math.lengthsq(along) ? step : along;
                }
            }
            normal = math.normalizesafe(normal);
            along = math.normalizesafe(along - normal * math.dot(normal, along));
            double3 across = math.cross(normal, along);
            double2 lower = double.PositiveInfinity, upper = double.NegativeInfinity;
            foreach (var corner in corners)
            {
                var place = new double2(math.dot(corner - corners[0], along), math.dot(corner - corners[0], across));
                (lower, upper) = (math.min(lower, place), math.max(upper, place));
            }
            double2 centre = (lower + upper) / 2;
            return new PatchRectangle(corners[0] + centre.x * along + centre.y * across, along, normal, (upper - lower) / 2);
        }
    }
}
