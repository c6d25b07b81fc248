using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Relative permittivity e' - j e'' and permeability mu' - j mu'' of a passive medium over frequency.
    /// The time factor is exp(+j omega t), so that losses are positive.
    /// </summary>
    public sealed class Medium
    {
        // Electric constant in F/m, CODATA 2022.
        const double VacuumPermittivity = 8.8541878188e-12;
        internal const double HertzPerGigahertz = 1e9;

        readonly Func<double, MediumSample> _sample;
        readonly string _text;

        Medium(Interval frequencies, string text, Func<double, MediumSample> sample) =>
            (Frequencies, _text, _sample) = (frequencies, text, sample);

        /// <summary>Frequencies with data, Hz.</summary>
        public Interval Frequencies { get; }

        /// <summary>The same values at every frequency.</summary>
        /// <param name="permittivity">e'.</param>
        /// <param name="permittivityLoss">e'', 0 or more.</param>
        /// <param name="permeability">mu'.</param>
        /// <param name="permeabilityLoss">mu'', 0 or more.</param>
        /// <exception cref="GlintException">
        /// A value is not finite, the medium has gain, or permittivity or permeability are 0.
        /// </exception>
        public static Medium Constant(double permittivity, double permittivityLoss, double permeability = 1,
            double permeabilityLoss = 0)
        {
            var sample = new MediumSample(0, permittivity, permittivityLoss, permeability, permeabilityLoss);
            sample.Validate();
            return new Medium(Interval.Closed(0, double.MaxValue), sample.Text, _ => sample);
        }

        /// <summary>Measured values, linear in frequency between two of them; no data outside.</summary>
        /// <param name="samples">In order of frequency; copied.</param>
        /// <exception cref="GlintException">
        /// No sample, frequencies that do not increase from above 0, or values that
        /// <see cref="Constant"/> refuses.
        /// </exception>
        public static Medium Table(IEnumerable<MediumSample> samples)
        {
            var rows = samples.ToArray();
            if (rows.Length == 0)
                throw new GlintException("the table of a medium is empty: give at least one frequency");
            double before = 0;
            foreach (var row in rows)
            {
                if (!(row.Frequency > before && row.Frequency < double.PositiveInfinity))
                    throw new GlintException($"the table of a medium has {Number(row.Frequency)} Hz after "
                        + $"{Number(before)} Hz: give frequencies above 0 in increasing order");
                row.Validate();
                before = row.Frequency;
            }
            string text = string.Join("; ", rows.Select(row => $"{Number(row.Frequency)} Hz {row.Text}"));
            return new Medium(Interval.Closed(rows[0].Frequency, before), text,
                frequency => Interpolate(rows, frequency));
        }

        /// <summary>
        /// The model of Recommendation ITU-R P.2040: e' = a f^b, conductivity c f^d in S/m, f in GHz; not magnetic.
        /// </summary>
        /// <param name="a">Above 0.</param>
        /// <param name="b">Exponent of e'.</param>
        /// <param name="c">0 or more.</param>
        /// <param name="d">Exponent of the conductivity.</param>
        /// <param name="from">Lowest frequency of validity, Hz, above 0.</param>
        /// <param name="to">Highest frequency of validity, Hz.</param>
        /// <exception cref="GlintException">A value is out of its range or not finite.</exception>
        public static Medium PowerLaw(double a, double b, double c, double d, double from, double to)
        {
            string text = $"e' {Number(a)} f^{Number(b)} conductivity {Number(c)} f^{Number(d)} "
                + $"from {Number(from)} to {Number(to)} Hz";
            if (!(a > 0 && c >= 0 && from > 0 && from <= to && IsFinite(a + b + c + d + to)))
                throw new GlintException($"the medium {text} is not valid: give a above 0, c of 0 or more, and "
                    + "frequencies above 0 in increasing order");
            return new Medium(Interval.Closed(from, to), text, frequency =>
            {
                double gigahertz = frequency / HertzPerGigahertz;
                return new MediumSample(frequency, a * Math.Pow(gigahertz, b),
                    LossOf(c * Math.Pow(gigahertz, d), frequency));
            });
        }

        /// <summary>
        /// Sea water from 1 to 90 GHz, by the model of Meissner and Wentz (2012). Foam is not part of it.
        /// </summary>
        /// <param name="celsius">Temperature, -2 to 29 degrees Celsius.</param>
        /// <param name="salinity">0 to 40 practical salinity units; the ocean has about 35.</param>
        /// <exception cref="GlintException">Temperature or salinity is out of its range.</exception>
        public static Medium SeaWater(double celsius = 20, double salinity = 35)
        {
            Core.SeaWater.Validate(celsius, salinity);
            return new Medium(Core.SeaWater.Frequencies,
                $"sea water of {Number(celsius)} C and {Number(salinity)} psu",
                frequency => Core.SeaWater.At(frequency, celsius, salinity));
        }

        /// <summary>Complex relative permittivity and permeability.</summary>
        /// <param name="frequency">Hz, one of <see cref="Frequencies"/>.</param>
        public (Complex permittivity, Complex permeability) At(double frequency)
        {
            var sample = _sample(frequency);
            return (new Complex(sample.Permittivity, -sample.PermittivityLoss),
                new Complex(sample.Permeability, -sample.PermeabilityLoss));
        }

        /// <summary>All of the medium in one line: equal media have equal lines.</summary>
        public override string ToString() => _text;

        internal static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);

        // e'' of a conductivity in S/m, at a frequency in Hz.
        internal static double LossOf(double conductivity, double frequency) =>
            conductivity / (2 * Math.PI * frequency * VacuumPermittivity);

        internal static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);

        static MediumSample Interpolate(MediumSample[] rows, double frequency)
        {
            int above = Array.FindIndex(rows, row => row.Frequency >= frequency);
            if (rows[above].Frequency == frequency)
                return rows[above];
            var (low, high) = (rows[above - 1], rows[above]);
            double share = (frequency - low.Frequency) / (high.Frequency - low.Frequency);
            double Between(double from, double to) => from + share * (to - from);
            return new MediumSample(frequency, Between(low.Permittivity, high.Permittivity),
                Between(low.PermittivityLoss, high.PermittivityLoss), Between(low.Permeability, high.Permeability),
                Between(low.PermeabilityLoss, high.PermeabilityLoss));
        }
    }

    /// <summary>Values of a medium at one frequency.</summary>
    [Serializable]
    public struct MediumSample
    {
        /// <summary>Hz.</summary>
        public double Frequency;

        /// <summary>e' of the relative permittivity e' - j e''.</summary>
        public double Permittivity;

        /// <summary>e'' of the relative permittivity e' - j e'': 0 or more.</summary>
        public double PermittivityLoss;

        /// <summary>mu' of the relative permeability mu' - j mu''; 1 for media that are not magnetic.</summary>
        public double Permeability;

        /// <summary>mu'' of the relative permeability mu' - j mu'': 0 or more.</summary>
        public double PermeabilityLoss;

        /// <summary>Values at a frequency in Hz.</summary>
        public MediumSample(double frequency, double permittivity, double permittivityLoss, double permeability = 1,
            double permeabilityLoss = 0)
        {
            Frequency = frequency;
            (Permittivity, PermittivityLoss) = (permittivity, permittivityLoss);
            (Permeability, PermeabilityLoss) = (permeability, permeabilityLoss);
        }

        internal string Text =>
            $"e {Medium.Number(Permittivity)} - {Medium.Number(PermittivityLoss)}j "
            + $"mu {Medium.Number(Permeability)} - {Medium.Number(PermeabilityLoss)}j";

        internal void Validate()
        {
            Validate("permittivity", "e", Permittivity, PermittivityLoss);
            Validate("permeability", "mu", Permeability, PermeabilityLoss);
        }

        static void Validate(string noun, string symbol, double value, double loss)
        {
            string shown = $"the relative {noun} {symbol}' = {Medium.Number(value)}, {symbol}'' = {Medium.Number(loss)}";
            if (!Medium.IsFinite(value) || !Medium.IsFinite(loss))
                throw new GlintException($"{shown} is not finite: give numbers");
            if (loss < 0)
                throw new GlintException($"{shown} has gain: give {symbol}'' of 0 or more, as the value is "
                    + $"{symbol}' - j {symbol}''");
            if (value == 0 && loss == 0)
                throw new GlintException($"{shown} is 0: give {symbol}', which is 1 in free space");
        }
    }
}
