using System;
using System.Linq;
using System.Numerics;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>Responses of points, summed term by term.</summary>
    static class PointEchoes
    {
        public const double C = 299792458;

        /// <summary>X band, 256 frequencies over 150 MHz: bins of 0.99931 m.</summary>
        public static FrequencyBand Band(int count = 256) => new FrequencyBand(10e9, 150e6 / count, count);

        /// <summary>Responses of paths of these lengths and amplitudes.</summary>
        public static Complex[] Sum(FrequencyBand band, double[] lengths, Complex[] amplitudes)
        {
            var responses = new Complex[band.Count];
            for (int n = 0; n < responses.Length; n++)
                for (int i = 0; i < lengths.Length; i++)
                {
                    double turns = band.Frequency(n) * (lengths[i] / C);
                    responses[n] += amplitudes[i]
                        * Complex.FromPolarCoordinates(1, -2 * Math.PI * (turns - Math.Floor(turns)));
                }
            return responses;
        }

        /// <summary>Responses of a point of this cross section in square metres.</summary>
        public static Complex[] Point(FrequencyBand band, double range, double crossSection) =>
            Sum(band, new[] { 2 * range }, new[] { new Complex(Math.Sqrt(crossSection), 0) });

        /// <summary>Index and value of the highest of some levels, by a parabola through three of them.</summary>
        public static (double index, double decibels) Peak(double[] decibels)
        {
            int at = Array.IndexOf(decibels, decibels.Max());
            double before = decibels[at - 1], here = decibels[at], after = decibels[at + 1],
                offset = 0.5 * (before - after) / (before - 2 * here + after);
            return (at + offset, here - 0.25 * (before - after) * offset);
        }
    }
}
