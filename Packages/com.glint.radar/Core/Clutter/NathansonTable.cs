using System;

namespace Glint.Core
{
    /// <summary>
    /// Mean reflectivities measured up to 1991, as tabulated by Nathanson: decibels, linear between the table's
    /// logarithms of frequency and grazing angle and between its sea states. Cells without measurement are refused.
    /// </summary>
    public sealed class NathansonTable : ClutterModel
    {
        /// <summary>The table.</summary>
        public NathansonTable() : base("nathanson", "Nathanson 1991",
            Interval.Closed(NathansonCells.Gigahertz[0], NathansonCells.Gigahertz[NathansonCells.Gigahertz.Length - 1]),
            Interval.Closed(NathansonCells.Grazing[0], NathansonCells.Grazing[NathansonCells.Grazing.Length - 1]),
            Interval.Closed(0, NathansonCells.SeaStates - 1))
        {
        }

        private protected override double Compute(bool isHorizontal, in ClutterConditions at)
        {
            var cells = isHorizontal ? NathansonCells.Horizontal : NathansonCells.Vertical;
            var (angle, angleShare) = Between(NathansonCells.Grazing, at.GrazingDegrees);
            var (band, bandShare) = Between(NathansonCells.Gigahertz, at.Gigahertz);
            int state = Math.Min((int)at.SeaState, NathansonCells.SeaStates - 2);
            double stateShare = at.SeaState - state, sum = 0;
            bool isMeasured = true;
            for (int corner = 0; corner < 8; corner++)
            {
                int up = corner & 1, right = corner >> 1 & 1, further = corner >> 2;
                double weight = Weight(stateShare, up) * Weight(angleShare, right) * Weight(bandShare, further);
                sbyte cell = cells[IndexOf(state + up, angle + right, band + further)];
                isMeasured &= weight == 0 || cell != NathansonCells.None;
                sum += weight * cell;
            }
            return isMeasured ? sum : throw new GlintException($"clutter model {Name}: it has no measurement "
                + $"of {(isHorizontal ? "hh" : "vv")} at {Medium.Number(at.Gigahertz)} GHz, "
                + $"{Medium.Number(at.GrazingDegrees)} deg and sea state {Medium.Number(at.SeaState)}: choose another "
                + "model, or physics");
        }

        static int IndexOf(int state, int angle, int band) =>
            (state * NathansonCells.Grazing.Length + angle) * NathansonCells.Gigahertz.Length + band;

        static double Weight(double share, int side) => side == 0 ? 1 - share : share;

        static (int below, double share) Between(double[] values, double value)
        {
            int below = Math.Min(Array.FindLastIndex(values, it => it <= value), values.Length - 2);
            return (below, Math.Log(value / values[below]) / Math.Log(values[below + 1] / values[below]));
        }
    }
}
