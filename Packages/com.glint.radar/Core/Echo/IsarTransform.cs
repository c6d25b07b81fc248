using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading.Tasks;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// From the range profiles of many looks to an image by backprojection: the sum over the looks of the profile at
    /// the pixel's range, turned back by the phase of the carrier. A point on the image's plane keeps its cross
    /// section. The plane is horizontal, through the phase centre; its axes are those of a radar at the middle of the
    /// looks: down range away from it, cross range to its right. A look at a finite range has spherical waves.
    /// </summary>
    public sealed class IsarTransform
    {
        /// <summary>
        /// Cells a bin that profiles need: reading between two cells takes less than 0.05 dB of a point.
        /// </summary>
        public const int Padding = 16;

        /// <summary>Maximum number of pixels along a side.</summary>
        public const int MaxPixels = 4096;

        readonly RangeTransform _range;
        readonly double _centreFrequency;
        readonly IReadOnlyList<RadarAspect> _looks;
        readonly IReadOnlyList<double> _ranges;
        readonly double[] _weights;
        readonly double3 _down, _cross;

        /// <param name="range">Made the profiles.</param>
        /// <param name="looks">The radar of each profile.</param>
        /// <param name="middleDegrees">Azimuth of the image's axes.</param>
        /// <param name="window">Weights over the looks.</param>
        /// <param name="side">Side of the image, metres.</param>
        /// <param name="pixels">Pixels along a side.</param>
        /// <param name="ranges">From the phase centre to the radar of each look, metres; null: all are infinite.</param>
        public IsarTransform(RangeTransform range, FrequencyBand band, IReadOnlyList<RadarAspect> looks,
            double middleDegrees, Window window, double side, int pixels, IReadOnlyList<double> ranges = null)
        {
            Require.Count("image", "number of pixels along a side", pixels, MaxPixels);
            Require.Positive("image", "side", side, "m");
            (_range, _centreFrequency, _looks, _ranges) = (range, band.Centre, looks, ranges);
            var middle = RadarAspect.At(middleDegrees, 0);
            (_down, _cross) = (-middle.ToRadar, middle.Right);
            double[] weights = window.Weights(looks.Count);
            double sum = weights.Sum();
            _weights = weights.Select(weight => weight / sum).ToArray();
            (Pixels, Pixel) = (pixels, side / pixels);
        }

        /// <summary>Pixels along a side.</summary>
        public int Pixels { get; }

        /// <summary>Side of a pixel, metres.</summary>
        public double Pixel { get; }

        /// <summary>Place of a row or column, metres: the middle of the image is the phase centre.</summary>
        public double PlaceOf(double index) => (index - 0.5 * (Pixels - 1)) * Pixel;

        /// <summary>The image, row by row: rows are down range, columns cross range.</summary>
        /// <param name="profiles">Of each look, with <see cref="Padding"/>.</param>
        public Complex[] Image(IReadOnlyList<Complex[]> profiles)
        {
            Require.Equal("image", "profiles", profiles.Count, _looks.Count);
            var image = new Complex[Pixels * Pixels];
            var looks = Enumerable.Range(0, _looks.Count).Select(LookOf).ToArray();
            Parallel.For(0, Pixels, row =>
            {
                for (int column = 0; column < Pixels; column++)
                {
                    double down = row - 0.5 * (Pixels - 1), cross = column - 0.5 * (Pixels - 1);
                    var sum = Complex.Zero;
                    for (int look = 0; look < looks.Length; look++)
                        sum += looks[look].At(profiles[look], down, cross);
                    image[row * Pixels + column] = sum;
                }
            });
            return image;
        }

        /// <summary>How the place of a pixel leads to a look's profile.</summary>
        public LookSteps LookOf(int look)
        {
            double turns = 2 * _centreFrequency / Signal.SpeedOfLight * Pixel, cells = Pixel / _range.CellSize,
                down = -math.dot(_looks[look].ToRadar, _down), cross = -math.dot(_looks[look].ToRadar, _cross);
            return new LookSteps
            {
                AwayDown = down, AwayCross = cross, Range = (_ranges?[look] ?? double.PositiveInfinity) / Pixel,
                TurnsAPixel = turns, CellsAPixel = cells, CentreCell = -_range.StartRange / _range.CellSize,
                Weight = _weights[look]
            };
        }
    }

    /// <summary>
    /// A look of an image: the range of a place, in pixels, is linear in the pixels from the image's middle, but for the
    /// curvature of the wave. It leads to the turns of the carrier and to the cell of the profile.
    /// </summary>
    public struct LookSteps
    {
        /// <summary>Range of a plane wave a pixel down range and cross range, pixels.</summary>
        public double AwayDown, AwayCross;

        /// <summary>From the image's middle to the radar, pixels; infinite: the wave is plane.</summary>
        public double Range;

        /// <summary>Of a pixel of range.</summary>
        public double TurnsAPixel, CellsAPixel;

        /// <summary>Cell of the image's middle.</summary>
        public double CentreCell;

        /// <summary>Of the look; all add up to 1.</summary>
        public double Weight;

        /// <summary>
        /// What the look adds to a pixel: its profile, turned back by the phase of the carrier; 0 outside the
        /// unambiguous range.
        /// </summary>
        internal Complex At(Complex[] profile, double down, double cross)
        {
            double away = down * AwayDown + cross * AwayCross, range = away + Curvature(down, cross, away),
                cell = range * CellsAPixel + CentreCell;
            int first = (int)Math.Floor(cell);
            if (first < 0 || first + 1 >= profile.Length)
                return Complex.Zero;
            double part = cell - first;
            var (sine, cosine) = PortableMath.SinCos(range * TurnsAPixel);
            return Weight * ((1 - part) * profile[first] + part * profile[first + 1]) * new Complex(cosine, sine);
        }

        // Pixels by which a place is further away than for a plane wave.
        double Curvature(double down, double cross, double away)
        {
            if (double.IsPositiveInfinity(Range))
                return 0;
            double across = down * down + cross * cross - away * away, ahead = Range + away;
            return across / (ahead + Math.Sqrt(ahead * ahead + across));
        }
    }
}
