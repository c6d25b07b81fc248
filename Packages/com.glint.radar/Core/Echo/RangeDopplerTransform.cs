using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// From the responses of a train of pulses to a map of range and speed. A point keeps its cross section, or its
    /// power, as in <see cref="RangeTransform"/>; the phase is that of the first pulse.
    /// </summary>
    public sealed class RangeDopplerTransform
    {
        const int MaxPadding = 64;

        readonly RangeTransform _range;
        readonly PulseTrain _pulses;
        readonly double[] _weights;
        readonly double _blindSpeed, _repetition;
        readonly FourierTransform _transform;

        /// <param name="range">Makes the profile of each pulse.</param>
        /// <param name="band">The band of the responses; Doppler shifts are those of its centre.</param>
        /// <param name="window">Weights over the pulses.</param>
        /// <param name="padding">Rows a bin of speed, at least: their number is a power of two.</param>
        /// <exception cref="GlintException">The padding is out of its range.</exception>
        public RangeDopplerTransform(RangeTransform range, FrequencyBand band, PulseTrain pulses, Window window,
            int padding = 2)
        {
            Require.Count("range-Doppler map", "zero padding", padding, MaxPadding);
            (_range, _pulses) = (range, pulses);
            double[] weights = window.Weights(pulses.Count);
            double sum = weights.Sum();
            _weights = weights.Select(weight => weight / sum).ToArray();
            _transform = new FourierTransform(FourierTransform.SizeFor((double)padding * pulses.Count));
            _blindSpeed = pulses.BlindSpeed(band.Centre);
            _repetition = pulses.RepetitionFrequency;
        }

        /// <summary>Rows of a map: speeds from minus half of the blind speed on.</summary>
        public int Rows => _transform.Size;

        /// <summary>Cells of a row: those of the profiles.</summary>
        public int Columns => _range.Cells;

        /// <summary>Speed of a row, m/s, positive towards the radar.</summary>
        public double SpeedOf(double row) => (row / Rows - 0.5) * _blindSpeed;

        /// <summary>Doppler shift of a row, hertz.</summary>
        public double DopplerOf(double row) => (row / Rows - 0.5) * _repetition;

        /// <summary>The map, row by row, from the responses of each pulse.</summary>
        /// <exception cref="GlintException">The number of pulses or of responses is not the transform's.</exception>
        public Complex[] Map(IReadOnlyList<IReadOnlyList<Complex>> responses)
        {
            Require.Equal("range-Doppler map", "pulses", responses.Count, _pulses.Count);
            var profiles = responses.Select(_range.Profile).ToArray();
            var map = new Complex[Rows * Columns];
            var pulses = new Complex[_pulses.Count];
            for (int column = 0; column < Columns; column++)
            {
                for (int pulse = 0; pulse < pulses.Length; pulse++)
                    pulses[pulse] = _weights[pulse] * profiles[pulse][column];
                // A path that shortens has a growing phase: exponent -, with speed 0 moved to the middle row.
                var spectrum = _transform.Transform(pulses, isPositive: false);
                for (int row = 0; row < Rows; row++)
                    map[row * Columns + column] = spectrum[(row + Rows / 2) & (Rows - 1)];
            }
            return map;
        }
    }
}
