using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Weights over a band or a burst that lower the sidelobes of its transform: a sum of cosines over the samples,
    /// symmetric about their middle, where its value is 1. Figures are those of many samples; a bin is the spacing of
    /// the transform's values without zero padding.
    /// </summary>
    public sealed class Window
    {
        // Step of the search for sidelobes, bins, and its reach after the first null: a Taylor window's highest
        // sidelobe is among its near ones.
        const double Step = 1.0 / 1024, Reach = 32;

        static readonly Interval s_nearSidelobes = Interval.Closed(2, 20),
            s_level = Interval.Closed(-100, -15);

        // Of 1, cos(2 pi x), cos(4 pi x) and so on; x from -1/2 to 1/2. Their sum is 1.
        readonly double[] _cosines;

        static readonly (string name, Func<Window> window)[] s_named =
        {
            ("taylor", () => Taylor(4, -35)), ("hann", () => Hann), ("hamming", () => Hamming),
            ("blackman", () => Blackman), ("none", () => None)
        };

        Window(params double[] cosines)
        {
            double sum = cosines.Sum();
            _cosines = cosines.Select(cosine => cosine / sum).ToArray();
        }

        /// <summary>All weights are 1.</summary>
        public static Window None { get; } = new Window(1);

        /// <summary>Hann's window: 0 at the ends of the band.</summary>
        public static Window Hann { get; } = new Window(0.5, 0.5);

        /// <summary>Hamming's window with the coefficients 0.54 and 0.46.</summary>
        public static Window Hamming { get; } = new Window(0.54, 0.46);

        /// <summary>Blackman's window with the coefficients 0.42, 0.5 and 0.08.</summary>
        public static Window Blackman { get; } = new Window(0.42, 0.5, 0.08);

        /// <summary>
        /// Taylor's window (IRE Trans. AP-3, 1955): the sidelobes next to the main lobe have nearly equal levels, the
        /// others fall off.
        /// </summary>
        /// <param name="nearSidelobes">Taylor's nbar: one more than the near sidelobes on a side; 2 to 20.</param>
        /// <param name="levelDb">Level of the near sidelobes, decibels, -100 to -15.</param>
        /// <exception cref="GlintException">A number is out of its range.</exception>
        public static Window Taylor(int nearSidelobes, double levelDb)
        {
            Require.Within("window", "Taylor number of near sidelobes", nearSidelobes, "", s_nearSidelobes);
            Require.Within("window", "Taylor sidelobe level", levelDb, "dB", s_level);
            double ratio = Math.Pow(10, -levelDb / 20), a = Math.Log(ratio + Math.Sqrt(ratio * ratio - 1)) / Math.PI,
                dilation = nearSidelobes * nearSidelobes / (a * a + (nearSidelobes - 0.5) * (nearSidelobes - 0.5));
            var cosines = new double[nearSidelobes];
            cosines[0] = 1;
            for (int m = 1; m < nearSidelobes; m++)
            {
                // The window is 1 + 2 sum F[m] cos(2 pi m x).
                double cosine = m % 2 == 0 ? -1 : 1;
                for (int n = 1; n < nearSidelobes; n++)
                {
                    cosine *= 1 - m * m / (dilation * (a * a + (n - 0.5) * (n - 0.5)));
                    if (n != m)
                        cosine /= 1 - (double)(m * m) / (n * n);
                }
                cosines[m] = cosine;
            }
            return new Window(cosines);
        }

        /// <summary>Names of windows, the usual one first: Taylor's has 3 near sidelobes of -35 dB a side.</summary>
        public static IReadOnlyList<string> Names { get; } = s_named.Select(named => named.name).ToArray();

        /// <summary>The window of one of <see cref="Names"/>.</summary>
        /// <exception cref="FormatException">There is no such window.</exception>
        public static Window Named(string name) => Names.Contains(name)
            ? s_named.First(named => named.name == name).window()
            : throw new FormatException($"must be one of {string.Join(", ", Names)}");

        /// <summary>Mean of the weights.</summary>
        public double CoherentGain => _cosines[0];

        /// <summary>Equivalent noise bandwidth: bins of white noise in a value, of which a target has one.</summary>
        public double NoiseBandwidth =>
            1 + 0.5 * _cosines.Skip(1).Sum(cosine => cosine * cosine) / (_cosines[0] * _cosines[0]);

        /// <summary>Highest sidelobe, decibels of the peak.</summary>
        public double SidelobeDb
        {
            get
            {
                double end = 0, highest = 0;
                while (Spectrum(end) > 0)
                    end += Step;
                for (double bins = end; bins < end + Reach; bins += Step)
                    highest = Math.Max(highest, Math.Abs(Spectrum(bins)));
                return 20 * Math.Log10(highest);
            }
        }

        /// <summary>Full width of the main lobe, bins.</summary>
        /// <param name="power">Where it is measured: power relative to the peak, 1/2 for instance.</param>
        public double Width(double power)
        {
            double level = Math.Sqrt(power), inside = 0, outside = 0;
            while (Spectrum(outside) > level)
                (inside, outside) = (outside, outside + 0.25);
            for (int halvings = 0; halvings < 50; halvings++)
            {
                double middle = (inside + outside) / 2;
                (inside, outside) = Spectrum(middle) > level ? (middle, outside) : (inside, middle);
            }
            return inside + outside;
        }

        /// <summary>The weights of this number of samples, each in the middle of its part of the band.</summary>
        public double[] Weights(int count)
        {
            var weights = new double[count];
            for (int n = 0; n < count; n++)
                for (int m = 0; m < _cosines.Length; m++)
                    weights[n] += _cosines[m] * PortableMath.SinCos(m * ((n + 0.5) / count - 0.5)).Cosine;
            return weights;
        }

        // The transform of the continuous window, 1 in its middle.
        double Spectrum(double bins)
        {
            double sum = Sinc(bins);
            for (int m = 1; m < _cosines.Length; m++)
                sum += _cosines[m] / _cosines[0] * 0.5 * (Sinc(bins - m) + Sinc(bins + m));
            return sum;
        }

        static double Sinc(double x) => x == 0 ? 1 : Math.Sin(Math.PI * x) / (Math.PI * x);
    }
}
