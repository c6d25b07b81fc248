using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Places of a radar on a straight, level track, from each of which it looks at the phase centre: spotlight SAR. The
    /// middle of the track is nearest to the phase centre. Immutable.
    /// </summary>
    public sealed class RadarTrack
    {
        // Of the identity.
        const string PlacesName = "track_m", RangeName = "track_range_m";

        readonly double[] _places;

        /// <param name="places">From the middle of the track, metres, to the right of the radar there.</param>
        /// <param name="azimuthDegrees">Of the middle: <see cref="RadarAspect.At"/>.</param>
        /// <param name="elevationDegrees">Of the middle.</param>
        /// <param name="range">From the phase centre to the middle, metres.</param>
        /// <exception cref="UsageException">The elevation is not between -90 and 90 degrees.</exception>
        public RadarTrack(double[] places, double azimuthDegrees, double elevationDegrees, double range)
        {
            if (!(Math.Abs(elevationDegrees) < 90))
                throw new UsageException($"a track at an elevation of {Numbers.Format(elevationDegrees)} degrees leads over "
                    + "the target, and has no side to it: give an elevation between -90 and 90 degrees");
            _places = places;
            (AzimuthDegrees, ElevationDegrees, Range) = (azimuthDegrees, elevationDegrees, range);
        }

        /// <summary>Number of places.</summary>
        public int Count => _places.Length;

        /// <summary>Places along the track, metres from its middle.</summary>
        public IReadOnlyList<double> Places => _places;

        /// <summary>Azimuth of the middle, degrees.</summary>
        public double AzimuthDegrees { get; }

        /// <summary>Elevation of the middle, degrees.</summary>
        public double ElevationDegrees { get; }

        /// <summary>From the phase centre to the middle, metres.</summary>
        public double Range { get; }

        /// <summary>Directions to a place and its distance: azimuth and elevation in degrees, metres.</summary>
        /// <param name="index">Of the place.</param>
        public (double azimuth, double elevation, double range) this[int index]
        {
            get
            {
                double elevation = math.radians(ElevationDegrees), along = _places[index],
                    ground = Range * Math.Cos(elevation), range = math.length(new double2(Range, along));
                return (AzimuthDegrees - math.degrees(Math.Atan2(along, ground)),
                    math.degrees(Math.Asin(Range * Math.Sin(elevation) / range)), range);
            }
        }

        internal void AddTo(SweepIdentity identity)
        {
            identity.Add(PlacesName, string.Join(",", _places.Select(Numbers.Format)));
            identity.Add(RangeName, Numbers.Format(Range));
        }

        // find: numbers of an entry; null: it is not there.
        internal static RadarTrack Of(Func<string, double[]> find, double azimuth, double elevation) =>
            find(PlacesName) is double[] places ? new RadarTrack(places, azimuth, elevation, find(RangeName)[0]) : null;
    }
}
