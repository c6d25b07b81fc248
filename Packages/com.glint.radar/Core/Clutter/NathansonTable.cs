using System;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Mean reflectivities measured up to 1991, as tabulated by Nathanson: decibels, linear between the table's
    /// logarithms of frequency and grazing angle and between its sea states. Cells without measurement are refused.
    /// </summary>
    public sealed class NathansonTable : ClutterModel
    {
        /// <summary>Its name, and authors and year.</summary>
        public const string Id = "nathanson", Source = "Nathanson 1991";

        static readonly double[] s_gigahertz = { 0.5, 1.25, 3, 5.6, 9.3, 17, 35 },
            s_grazing = { 0.1, 0.3, 1, 3, 10, 30, 60 };

        const int SeaStates = 7;

        // NaN where there is no measurement.
        readonly double[] _horizontal, _vertical;

        /// <summary>Reads the table.</summary>
        /// <param name="text">Lines of pol, grazing_deg, sea_state, freq_GHz, sigma0_dB, below a header.</param>
        /// <param name="path">For messages.</param>
        /// <exception cref="GlintException">A line is malformed.</exception>
        public NathansonTable(string text, string path) : base(Id, Source,
            Interval.Closed(s_gigahertz[0], s_gigahertz[s_gigahertz.Length - 1]),
            Interval.Closed(s_grazing[0], s_grazing[s_grazing.Length - 1]), Interval.Closed(0, SeaStates - 1))
        {
            _horizontal = Enumerable.Repeat(double.NaN, SeaStates * s_grazing.Length * s_gigahertz.Length).ToArray();
            _vertical = _horizontal.ToArray();
            var lines = text.Replace("\r", "").TrimEnd('\n').Split('\n');
            for (int i = 1; i < lines.Length; i++)
                if (!TryRead(lines[i].Split(',')))
                    throw new GlintException($"{path}: line {i + 1} is not a cell of the table of sea reflectivities: "
                        + "restore the package");
        }

        private protected override double Compute(bool isHorizontal, in ClutterConditions at)
        {
            var cells = isHorizontal ? _horizontal : _vertical;
            var (angle, angleShare) = Between(s_grazing, at.GrazingDegrees);
            var (band, bandShare) = Between(s_gigahertz, at.Gigahertz);
            int state = Math.Min((int)at.SeaState, SeaStates - 2);
            double stateShare = at.SeaState - state, sum = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                int up = corner & 1, right = corner >> 1 & 1, further = corner >> 2;
                double weight = Weight(stateShare, up) * Weight(angleShare, right) * Weight(bandShare, further);
                if (weight > 0)
                    sum += weight * cells[IndexOf(state + up, angle + right, band + further)];
            }
            return !double.IsNaN(sum) ? sum : throw new GlintException($"clutter model {Name}: it has no measurement "
                + $"of {(isHorizontal ? "hh" : "vv")} at {Medium.Number(at.Gigahertz)} GHz, "
                + $"{Medium.Number(at.GrazingDegrees)} deg and sea state {Medium.Number(at.SeaState)}: choose another "
                + "model, or physics");
        }

        static int IndexOf(int state, int angle, int band) =>
            (state * s_grazing.Length + angle) * s_gigahertz.Length + band;

        static double Weight(double share, int side) => side == 0 ? 1 - share : share;

        static (int below, double share) Between(double[] values, double value)
        {
            int below = Math.Min(Array.FindLastIndex(values, it => it <= value), values.Length - 2);
            return (below, Math.Log(value / values[below]) / Math.Log(values[below + 1] / values[below]));
        }

        bool TryRead(string[] cells)
        {
            if (cells.Length != 5 || cells[0] != "HH" && cells[0] != "VV" || !TryReal(cells[1], out double grazing)
                || !TryReal(cells[2], out double state) || !TryReal(cells[3], out double gigahertz)
                || !TryReal(cells[4], out double decibels))
                return false;
            int angle = Array.IndexOf(s_grazing, grazing), band = Array.IndexOf(s_gigahertz, gigahertz);
            if (angle < 0 || band < 0 || !(state >= 0 && state < SeaStates && state == Math.Floor(state)))
                return false;
            (cells[0] == "HH" ? _horizontal : _vertical)[IndexOf((int)state, angle, band)] = decibels;
            return true;
        }

        static bool TryReal(string cell, out double value) =>
            double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out value);
    }
}
