using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Thermal noise of a receiver: complex normal samples of the power k T0 B F, half in I and half in Q. A sample
    /// depends on seed, pulse and index alone, so that any order and any part gives the same bits.
    /// </summary>
    public sealed class ThermalNoise
    {
        /// <summary>Boltzmann's constant (J/K, exact) times the standard temperature of 290 K: W/Hz.</summary>
        public const double Density = 1.380649e-23 * 290;

        readonly ulong _key;
        readonly double _deviation;

        /// <param name="seed">The same number gives the same noise.</param>
        /// <param name="bandwidthHz">Noise bandwidth of the receiver.</param>
        /// <param name="noiseFigureDb">Noise figure, 0 or more.</param>
        /// <exception cref="GlintException">A number is out of its range.</exception>
        public ThermalNoise(int seed, double bandwidthHz, double noiseFigureDb)
        {
            Require.Positive("noise", "bandwidth", bandwidthHz, "Hz");
            Require.Within("noise", "noise figure", noiseFigureDb, "dB", Interval.Closed(0, 100));
            Power = Density * bandwidthHz * PowerLevel.FromDecibels(noiseFigureDb);
            _deviation = Math.Sqrt(Power);
            _key = new SplitMix64((ulong)seed).Next();
        }

        /// <summary>Mean power of a sample, watts.</summary>
        public double Power { get; }

        /// <summary>The noise of a sample of a pulse, in the root of a watt.</summary>
        public Complex Sample(long pulse, int sample)
        {
            ulong ofPulse = new SplitMix64(_key + (ulong)pulse).Next();
            var random = new SplitMix64(new SplitMix64(ofPulse + (uint)sample).Next());
            double radius = _deviation * Math.Sqrt(-PortableMath.Log(random.NextAboveZero()));
            var (sine, cosine) = PortableMath.SinCos(random.NextAboveZero());
            return new Complex(radius * cosine, radius * sine);
        }

        /// <summary>The samples of a pulse, or its responses, with the noise added.</summary>
        public Complex[] AddTo(IReadOnlyList<Complex> samples, long pulse) =>
            samples.Select((sample, index) => sample + Sample(pulse, index)).ToArray();
    }
}
