using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// From responses over a band to range profiles. A point whose responses are A exp(-j 4 pi f R / c) gives A at R
    /// times exp(-j 4 pi fc R / c), fc the centre of the band: the cross section of a point is the height of its peak,
    /// whatever the window. Responses in metres (<see cref="ScatteringMatrix"/>) give metres, those in the root of a
    /// watt give that.
    /// </summary>
    public sealed class RangeTransform
    {
        const int MaxPadding = 64;

        readonly FrequencyBand _band;
        readonly double[] _weights;
        readonly Complex[] _shifts, _turns;
        readonly FourierTransform _transform;

        /// <param name="padding">
        /// Cells a bin, at least: zeros are added up to the next power of two. With 8 a peak between two cells loses
        /// less than 0.06 dB.
        /// </param>
        /// <param name="startRange">
        /// Range of the first cell, metres. Cells span the unambiguous range from there; echoes outside it are folded
        /// into it.
        /// </param>
        /// <exception cref="GlintException">The padding or the range is out of its range.</exception>
        public RangeTransform(FrequencyBand band, Window window, int padding = 8, double startRange = 0)
        {
            Require.Count("range profile", "zero padding", padding, MaxPadding);
            Require.Within("range profile", "start", startRange, "m", Interval.Closed(-1e9, 1e9));
            _band = band;
            StartRange = startRange;
            double[] weights = window.Weights(band.Count);
            double sum = weights.Sum();
            _weights = weights.Select(weight => weight / sum).ToArray();
            _transform = new FourierTransform(FourierTransform.SizeFor((double)padding * band.Count));
            double periods = startRange / band.UnambiguousRange, middle = 0.5 * (band.Count - 1);
            _shifts = Enumerable.Range(0, band.Count).Select(n => UnitPhasor((n - middle) * periods)).ToArray();
            _turns = Enumerable.Range(0, Cells).Select(k => UnitPhasor(-middle * k / Cells)).ToArray();
        }

        /// <summary>Cells of a profile, a power of two.</summary>
        public int Cells => _transform.Size;

        /// <summary>Range of the first cell, metres.</summary>
        public double StartRange { get; }

        /// <summary>Range from a cell to the next, metres.</summary>
        public double CellSize => _band.UnambiguousRange / Cells;

        /// <summary>Range of a cell, metres; half of the path out and back.</summary>
        public double RangeOf(double cell) => StartRange + cell * CellSize;

        /// <summary>The profile of one pulse or pose, from its responses in order of the frequencies.</summary>
        /// <exception cref="GlintException">The number of responses is not that of the frequencies.</exception>
        public Complex[] Profile(IReadOnlyList<Complex> responses)
        {
            Require.Equal("range profile", "responses", responses.Count, _band.Count);
            var weighted = new Complex[_band.Count];
            for (int n = 0; n < weighted.Length; n++)
                weighted[n] = _weights[n] * _shifts[n] * responses[n];
            var profile = _transform.Transform(weighted, isPositive: true);
            for (int k = 0; k < profile.Length; k++)
                profile[k] *= _turns[k];
            return profile;
        }

        static Complex UnitPhasor(double turns)
        {
            var (sine, cosine) = PortableMath.SinCos(turns);
            return new Complex(cosine, sine);
        }
    }
}
