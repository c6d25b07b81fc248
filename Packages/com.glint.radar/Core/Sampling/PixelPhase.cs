using System;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// The phase over a pixel that received rays surround: a parabola through its own and its neighbours' path lengths.
    /// Its mean phasor then needs no further rays, even where the phase changes by more than half a turn from pixel to
    /// pixel, because path lengths are not wrapped to the wavelength.
    /// </summary>
    public struct PixelPhase
    {
        // Maximum turns from one pixel to the next, and maximum change of that from pixel to pixel, for which the
        // mean holds.
        const double Steepest = 1, MaxBend = 1.0 / 16;

        double _slopeX, _slopeY, _bendX, _bendY, _twist; // turns a pixel, and turns a pixel squared

        /// <summary>
        /// Maximum difference between the lengths on both sides of a smooth pixel, metres.
        /// </summary>
        public static double MaxSlope(double wavelength) => 2 * Steepest * wavelength;

        /// <summary>Maximum second difference of lengths across a smooth pixel, metres.</summary>
        public static double MaxSecondDifference(double wavelength) => MaxBend * wavelength;

        /// <summary>Maximum difference of the slopes on both sides of a smooth pixel, metres.</summary>
        public static double MaxSlopeDifference(double wavelength) => 4 * MaxBend * wavelength;

        /// <summary>True if the phase is smooth enough for the mean.</summary>
        public bool IsSmooth => Math.Abs(_slopeX) <= Steepest && Math.Abs(_slopeY) <= Steepest
            && Math.Abs(_bendX) <= MaxBend && Math.Abs(_bendY) <= MaxBend && Math.Abs(_twist) <= MaxBend;

        /// <summary>Mean phasor over the pixel relative to the phasor at its centre.</summary>
        public Complex Mean
        {
            get
            {
                var (x, y) = (new Slope(_slopeX), new Slope(_slopeY));
                return new Complex(x.Mean * y.Mean, -Math.PI * (_bendX * x.Second * y.Mean + _bendY * y.Second * x.Mean
                    + 2 * _twist * x.First * y.First));
            }
        }

        /// <summary>The phase around a ray whose eight neighbours are all received.</summary>
        internal static PixelPhase Of(ReceivedPicture picture, int ray, in ReceivedNeighbours near, double wavelength)
        {
            double centre = picture[ray].Length, west = picture[near.West].Length, east = picture[near.East].Length,
                south = picture[near.South].Length, north = picture[near.North].Length;
            double twist = (double)picture[near.NorthEast].Length - picture[near.NorthWest].Length
                - picture[near.SouthEast].Length + picture[near.SouthWest].Length;
            return new PixelPhase
            {
                _slopeX = (east - west) / (2 * wavelength), _slopeY = (north - south) / (2 * wavelength),
                _bendX = (east - 2 * centre + west) / wavelength,
                _bendY = (north - 2 * centre + south) / wavelength, _twist = twist / (4 * wavelength),
            };
        }

        // Along one axis: the mean of exp(i angle u) over u from -1/2 to 1/2, sin(angle/2) / (angle/2),
        // and its derivatives by the angle.
        readonly struct Slope
        {
            const double MinTurns = 0.03; // below, the series is used

            public readonly double Mean, First, Second;

            public Slope(double turns)
            {
                double angle = 2 * Math.PI * turns;
                if (Math.Abs(turns) < MinTurns)
                {
                    Mean = 1 - angle * angle / 24;
                    First = -angle / 12;
                    Second = (angle * angle * 3 / 40 - 1) / 12;
                    return;
                }
                var half = Phasors.OfTurns(turns / 2);
                Mean = 2 * half.Imaginary / angle;
                First = (half.Real - Mean) / angle;
                Second = -Mean / 4 - 2 * First / angle;
            }
        }
    }
}
