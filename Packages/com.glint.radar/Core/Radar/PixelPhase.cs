using System;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// The phase over a pixel that received rays surround: a parabola through its own and its neighbours' path lengths. Its mean phasor is then known without further rays, also where the phase turns
    /// by more than half a turn from pixel to pixel, because lengths are known beyond the wavelength.
    /// </summary>
    struct PixelPhase
    {
        // Most turns from one pixel to the next, and most by which that changes from pixel to pixel, for the means to hold.
        const double Steepest = 1, MostBend = 1.0 / 16;

        double _slopeX, _slopeY, _bendX, _bendY, _twist; // turns a pixel, and turns a pixel squared

        /// <summary>True if the phase is as smooth as the means need it.</summary>
        public bool IsSmooth => Math.Abs(_slopeX) <= Steepest && Math.Abs(_slopeY) <= Steepest
            && Math.Abs(_bendX) <= MostBend && Math.Abs(_bendY) <= MostBend && Math.Abs(_twist) <= MostBend;

        /// <summary>Of a ray all of whose neighbours were received.</summary>
        public static PixelPhase Of(ReceivedPicture picture, int ray, in ReceivedNeighbours near, double wavelength)
        {
            double centre = picture[ray].Length, west = picture[near.West].Length, east = picture[near.East].Length, south = picture[near.South].Length, north = picture[near.North].Length;
            double twist = (double)picture[near.NorthEast].Length - picture[near.NorthWest].Length - picture[near.SouthEast].Length + picture[near.SouthWest].Length;
            return new PixelPhase
            {
                _slopeX = (east - west) / (2 * wavelength), _slopeY = (north - south) / (2 * wavelength),
                _bendX = (east - 2 * centre + west) / wavelength, _bendY = (north - 2 * centre + south) / wavelength, _twist = twist / (4 * wavelength),
            };
        }

        /// <summary>By how much the mean over the pixel differs from the phasor in its middle, which counts as 1; and the means over the sub-rays of each half-density grid.</summary>
        public void AddMeans(Complex middle, ref Complex whole, Complex[] parts)
        {
            var (x, y) = (new Slope(_slopeX), new Slope(_slopeY));
            double bent = -Math.PI * (_bendX * x.Second * y.Mean + _bendY * y.Second * x.Mean + 2 * _twist * x.First * y.First);
            whole += middle * new Complex(x.Mean * y.Mean - 1, bent);
            // Such a grid has its sub-rays a quarter of a pixel to either side of places an eighth off the middle.
            Complex same = x.Part * y.Part, opposite = x.Part * Complex.Conjugate(y.Part), shift = new Complex(-1, bent);
            parts[0] += middle * (Complex.Conjugate(same) + shift);
            parts[1] += middle * (opposite + shift);
            parts[2] += middle * (Complex.Conjugate(opposite) + shift);
            parts[3] += middle * (same + shift);
        }

        // Along one axis, where the phase turns evenly.
        readonly struct Slope
        {
            const double LeastTurns = 0.03; // below, the series is as good

            /// <summary>Mean of exp(i angle u) over u from -1/2 to 1/2, which is sin(angle/2) / (angle/2), and its derivatives.</summary>
            public readonly double Mean, First, Second;

            /// <summary>Mean of exp(i angle u) over u = -1/8 and 3/8.</summary>
            public readonly Complex Part;

            public Slope(double turns)
            {
                Complex eighth = Phasors.OfTurns(turns / 8), quarter = eighth * eighth, half = quarter * quarter;
                Part = quarter.Real * eighth;
                double angle = 2 * Math.PI * turns, square = angle * angle;
                if (Math.Abs(turns) < LeastTurns)
                {
                    Mean = 1 - square / 24;
                    First = -angle / 12;
                    Second = -(1 - 3 * square / 40) / 12;
                    return;
                }
                Mean = 2 * half.Imaginary / angle;
                First = (half.Real - Mean) / angle;
                Second = -Mean / 4 - 2 * First / angle;
            }
        }
    }
}
