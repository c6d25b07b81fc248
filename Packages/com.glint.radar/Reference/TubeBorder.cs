using System;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>Whether a border runs through a tube: what its centre meets is not what its corners meet.</summary>
    sealed class TubeBorder
    {
        readonly CrossSectionReceiver[] _receivers;
        readonly double _maxBend;

        /// <param name="maxBend">Deviation of the length of the way from a linear one, metres.</param>
        public TubeBorder(CrossSectionReceiver[] receivers, double maxBend) =>
            (_receivers, _maxBend) = (receivers, maxBend);

        /// <summary>
        /// Whether a border, or a phase that is not linear, is between the centre of a tube and a corner.
        /// </summary>
        /// <param name="step">From the centre to the corner on the grid, metres.</param>
        public bool IsBetween(in TubePath centre, in TubePath corner, double2 step)
        {
            if (!centre.HasSignatureOf(corner))
                return true;
            for (int i = 0; i < centre.Hits.Count; i++)
                for (int r = 0; r < _receivers.Length; r++)
                    if (centre.Hits[i].Radiates[r]
                        && !(Math.Abs(Bend(centre.Hits[i], corner.Hits[i], _receivers[r], step)) <= _maxBend))
                        return true;
            return false;
        }

        // Length of the way by a corner to a receiver, less that expected from the centre, metres.
        static double Bend(in TubeHit centre, in TubeHit corner, CrossSectionReceiver receiver, double2 step)
        {
            double3 toReceiver = receiver.From(centre.Position, out _);
            double expected = math.dot(centre.Direction - toReceiver, step.x * centre.Pu + step.y * centre.Pv);
            return corner.Length + receiver.Length(corner.Position) - centre.Length - receiver.Length(centre.Position)
                - expected;
        }
    }
}
