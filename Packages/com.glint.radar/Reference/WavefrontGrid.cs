using System;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// The wavefront's grid from which tubes start: the plane through the phase centre across the view axis, turned so
    /// that no edge of a usual target is along its rows. Positions are the BVH's.
    /// </summary>
    sealed class WavefrontGrid
    {
        // Between the grid's first axis and the radar's right, degrees.
        const double TurnDegrees = 27.3;

        readonly double3 _toRadar, _u, _v, _phaseCentre;
        readonly double _range, _radius;

        public WavefrontGrid(CrossSectionPose pose, ReferenceBvh bvh)
        {
            double turn = math.radians(TurnDegrees), cos = Math.Cos(turn), sin = Math.Sin(turn);
            _toRadar = pose.Radar.ToRadar;
            _u = cos * pose.Radar.Right + sin * pose.Radar.Up;
            _v = cos * pose.Radar.Up - sin * pose.Radar.Right;
            _phaseCentre = pose.PhaseCentre - bvh.Centre;
            _range = pose.Range;
            _radius = bvh.Radius;
            Min = double.PositiveInfinity;
            Max = double.NegativeInfinity;
            foreach (var instance in pose.Scene.Instances)
                foreach (int index in instance.Mesh.Indices)
                    Cover(instance.ToWorld.Point(instance.Mesh.Vertices[index]) - bvh.Centre);
        }

        /// <summary>Corners of the rectangle on the grid that covers the scene, metres.</summary>
        public double2 Min { get; private set; }

        /// <inheritdoc cref="Min"/>
        public double2 Max { get; private set; }

        /// <summary>The ray through a point of the grid, with its differentials per metre of the grid.</summary>
        public TubeRay Start(double2 at)
        {
            double3 beside = at.x * _u + at.y * _v;
            var ray = new TubeRay { Direction = -_toRadar, Pu = _u, Pv = _v, StartSection = 1 };
            double3 start = _phaseCentre + beside;
            if (!double.IsInfinity(_range))
            {
                start = _phaseCentre + _range * _toRadar;
                double3 toGrid = beside - _range * _toRadar;
                double distance = math.length(toGrid);
                ray.Direction = toGrid / distance;
                ray.Du = (_u - math.dot(_u, ray.Direction) * ray.Direction) / distance;
                ray.Dv = (_v - math.dot(_v, ray.Direction) * ray.Direction) / distance;
                (ray.Pu, ray.Pv) = (0, 0);
                ray.StartSection = _range * _range * math.dot(math.cross(ray.Du, ray.Dv), ray.Direction);
                ray.Length = -_range;
            }
            // A ray of a plane wave starts before the scene, and one from afar is brought there: small coordinates keep
            // rounding small.
            double step = -math.dot(start, ray.Direction) - 2 * _radius;
            if (!double.IsInfinity(_range))
                step = Math.Max(0, step);
            ray.Position = start;
            ray.Advance(step);
            return ray;
        }

        void Cover(double3 point)
        {
            double3 from = point - _phaseCentre;
            double2 at = new double2(math.dot(from, _u), math.dot(from, _v));
            if (!double.IsInfinity(_range))
            {
                double depth = _range - math.dot(from, _toRadar);
                if (!(depth > 0))
                    throw new GlintException(
                        FormattableString.Invariant($"the radar, {_range} m from the phase centre, is ")
                        + "beside or within the target: choose a greater range, or the far field");
                at *= _range / depth;
            }
            (Min, Max) = (math.min(Min, at), math.max(Max, at));
        }
    }

    /// <summary>A ray with its differentials by the coordinates of the grid.</summary>
    struct TubeRay
    {
        /// <summary>Position and unit direction.</summary>
        public double3 Position, Direction;

        /// <summary>Derivatives of position and direction by the grid's coordinates.</summary>
        public double3 Pu, Pv, Du, Dv;

        /// <summary>From the wavefront through the phase centre, metres.</summary>
        public double Length;

        /// <summary>Section of the wavefront where the field is 1, per area of the grid.</summary>
        public double StartSection;

        /// <summary>Moves the ray along itself.</summary>
        public void Advance(double distance)
        {
            Position += distance * Direction;
            Length += distance;
            Pu += distance * Du;
            Pv += distance * Dv;
        }

        /// <summary>Section of the tube, per area of the grid; its sign changes at caustics.</summary>
        public double Section => math.dot(math.cross(Pu, Pv), Direction);

        /// <summary>Caustic lines that the ray meets within a distance: roots of the section.</summary>
        public int CausticsWithin(double distance)
        {
            double a = math.dot(math.cross(Du, Dv), Direction), c = Section,
                b = math.dot(math.cross(Pu, Dv) + math.cross(Du, Pv), Direction);
            // Both roots are real, as wavefronts have two radii of curvature; rounding can hide that where they are the
            // same.
            double root = Math.Sqrt(Math.Max(0, b * b - 4 * a * c)), q = -0.5 * (b < 0 ? b - root : b + root);
            double first = q / a, second = c / q;
            return (first > 0 && first < distance ? 1 : 0) + (second > 0 && second < distance ? 1 : 0);
        }
    }
}
