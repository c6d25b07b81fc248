using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>Follows the centre rays of tubes from mirror to mirror.</summary>
    sealed class TubeTracer
    {
        // Cosine of incidence below which a surface is seen edge-on: the ray ends.
        const double EdgeOn = 1e-6;

        // Most rays of most grids hit nothing.
        static readonly List<TubeHit> s_noHits = new List<TubeHit>();

        readonly WavefrontGrid _grid;
        readonly ReferenceBvh _bvh;
        readonly SmoothedSurface _surface;
        readonly CrossSectionReceiver[] _receivers;
        readonly int _maxBounces;

        public TubeTracer(CrossSectionPose pose, WavefrontGrid grid, ReferenceBvh bvh, SmoothedSurface surface,
            CrossSectionReceiver[] receivers)
        {
            _grid = grid;
            _bvh = bvh;
            _surface = surface;
            _receivers = receivers;
            _maxBounces = pose.OnlyBounce > 0 ? Math.Min(pose.OnlyBounce, pose.MaxBounces) : pose.MaxBounces;
        }

        /// <summary>The path of the ray through a point of the grid.</summary>
        public TubePath Trace(double2 at)
        {
            var ray = _grid.Start(at);
            var path = new TubePath { Hits = s_noHits, Direction = ray.Direction };
            int caustics = 0;
            for (int bounce = 1; bounce <= _maxBounces; bounce++)
            {
                int triangle = _bvh.ClosestHit(ray.Position, ray.Direction, out double distance);
                if (triangle < 0)
                    break;
                caustics += ray.CausticsWithin(distance);
                double3 onFacet = ray.Position + distance * ray.Direction;
                double lead = _surface.LeadOf(triangle, onFacet, ray.Direction);
                var normal = _surface.At(triangle, onFacet - lead * ray.Direction, ray.Direction);
                lead = normal.IsCurved ? lead : 0;
                ray.Advance(distance - lead);
                if (-math.dot(ray.Direction, normal.Normal) < EdgeOn)
                    break;
                var hit = Hit(ray, triangle, normal, bounce, onFacet);
                hit.Caustics = caustics;
                if (bounce == 1)
                    path.Hits = new List<TubeHit>();
                path.Hits.Add(hit);
                Mirror(ref ray, normal);
                // The ray that is followed leaves the facet, with the phase of the one that leaves the surface.
                ray.Position = onFacet;
                ray.Length += lead * math.dot(hit.Direction, ray.Direction);
                // The mirrored ray would go through its own facet.
                if (!(math.dot(ray.Direction, normal.Facet) > 0))
                    break;
            }
            return path;
        }

        TubeHit Hit(in TubeRay ray, int triangle, in SurfaceNormal normal, int bounce, double3 onFacet)
        {
            double along = math.dot(ray.Direction, normal.Normal);
            var hit = new TubeHit
            {
                Position = ray.Position, Length = ray.Length, Direction = ray.Direction, Normal = normal.Normal,
                Patch = _surface.PatchOf(triangle), Surface = _bvh.RangeOf(triangle).Surface,
                Pu = ray.Pu - math.dot(ray.Pu, normal.Normal) / along * ray.Direction,
                Pv = ray.Pv - math.dot(ray.Pv, normal.Normal) / along * ray.Direction,
                Amplitude = Math.Sqrt(Math.Abs(ray.StartSection / ray.Section)),
                Radiates = new bool[_receivers.Length],
            };
            if (normal.IsCurved)
            {
                double3 tangent = math.normalize(ray.Direction - along * normal.Normal);
                double3 step = tangent - math.dot(tangent, normal.Facet) * normal.Facet;
                hit.Curvature = math.dot(normal.Along(step), tangent);
            }
            for (int i = 0; i < _receivers.Length; i++)
                hit.Radiates[i] = Radiates(_receivers[i], onFacet, normal.Facet, bounce);
            return hit;
        }

        // The current of the first bounce radiates through the body too, where it makes the shadow.
        bool Radiates(CrossSectionReceiver receiver, double3 position, double3 facet, int bounce)
        {
            double3 toReceiver = receiver.From(position, out double reach);
            if (math.dot(facet, toReceiver) > 0)
                return bounce == 1 && receiver.IsRadar || !_bvh.AnyHit(position, toReceiver, reach);
            return bounce == 1;
        }

        static void Mirror(ref TubeRay ray, in SurfaceNormal normal)
        {
            double3 n = normal.Normal, d = ray.Direction;
            double along = math.dot(d, n);
            ray.Pu -= math.dot(ray.Pu, n) / along * d;
            ray.Pv -= math.dot(ray.Pv, n) / along * d;
            double3 changeU = normal.Along(ray.Pu), changeV = normal.Along(ray.Pv);
            ray.Du -= 2 * (along * changeU + (math.dot(ray.Du, n) + math.dot(d, changeU)) * n);
            ray.Dv -= 2 * (along * changeV + (math.dot(ray.Dv, n) + math.dot(d, changeV)) * n);
            ray.Direction = math.normalize(d - 2 * along * n);
        }
    }
}
