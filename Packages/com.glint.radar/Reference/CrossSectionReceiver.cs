using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>A receiver, far away or at a point. Positions are the BVH's.</summary>
    sealed class CrossSectionReceiver
    {
        readonly RadarAspect _aspect;
        readonly double3 _phaseCentre;
        readonly double _range;

        public CrossSectionReceiver(in RadarAspect aspect, CrossSectionPose pose, double3 centre)
        {
            _aspect = aspect;
            _phaseCentre = pose.PhaseCentre - centre;
            _range = pose.Range;
            IsRadar = aspect.ToRadar.Equals(pose.Radar.ToRadar);
        }

        /// <summary>Whether it is where the radar is: it sees what the radar lights.</summary>
        public bool IsRadar { get; }

        /// <summary>Unit vector from a point to the receiver, and the distance.</summary>
        public double3 From(double3 point, out double distance)
        {
            distance = _range;
            if (double.IsInfinity(_range))
                return _aspect.ToRadar;
            double3 way = _phaseCentre + _range * _aspect.ToRadar - point;
            distance = math.length(way);
            return way / distance;
        }

        /// <summary>Length of the way from a point to the receiver less that from the phase centre, metres.</summary>
        public double Length(double3 point)
        {
            if (double.IsInfinity(_range))
                return -math.dot(_aspect.ToRadar, point - _phaseCentre);
            From(point, out double distance);
            return distance - _range;
        }

        /// <summary>Amplitude of a wave from a point over that of one from the phase centre.</summary>
        public double Amplitude(double3 point)
        {
            if (double.IsInfinity(_range))
                return 1;
            From(point, out double distance);
            return _range / distance;
        }

        /// <summary>What the antennas receive of waves that travel against a direction: V and H.</summary>
        public (double3 v, double3 h) Polarisations(double3 toReceiver) => Across(_aspect, toReceiver);

        /// <summary>V and H of an aspect, turned to be perpendicular to a direction.</summary>
        public static (double3 v, double3 h) Across(in RadarAspect aspect, double3 direction)
        {
            double3 v = math.normalize(aspect.Up - math.dot(aspect.Up, direction) * direction);
            double3 h = aspect.Right - math.dot(aspect.Right, direction) * direction;
            return (v, math.normalize(h - math.dot(h, v) * v));
        }
    }
}
