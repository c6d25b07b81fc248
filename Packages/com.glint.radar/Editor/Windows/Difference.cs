using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Editor
{
    /// <summary>Differences of a quantity between two runs.</summary>
    sealed class Difference
    {
        readonly Quantity _quantity;

        /// <param name="pairs">Poses of both runs; at least one.</param>
        public Difference(Quantity quantity, IReadOnlyList<(PoseFigures Ours, PoseFigures Theirs)> pairs)
        {
            _quantity = quantity;
            double Of((PoseFigures Ours, PoseFigures Theirs) pair) => quantity.Of(pair.Ours) - quantity.Of(pair.Theirs);
            var largest = pairs[0];
            foreach (var pair in pairs)
                if (Math.Abs(Of(pair)) > Math.Abs(Of(largest)))
                    largest = pair;
            Largest = Of(largest);
            At = largest.Ours;
            Theirs = quantity.Of(largest.Theirs);
            Rms = Math.Sqrt(pairs.Average(pair => Of(pair) * Of(pair)));
        }

        /// <summary>The difference of largest magnitude, ours less theirs.</summary>
        public double Largest { get; }

        /// <summary>Its pose.</summary>
        public PoseFigures At { get; }

        /// <summary>Their value at that pose.</summary>
        public double Theirs { get; }

        /// <summary>Root mean square of all differences.</summary>
        public double Rms { get; }

        /// <summary>A line of text.</summary>
        public override string ToString()
        {
            if (Largest == 0)
                return $"{_quantity.Title}: equal";
            string share = Theirs > 0 ? FormattableString.Invariant($" ({100 * Largest / Theirs:+0.##;-0.##} %)") : "";
            return FormattableString.Invariant(
                $"{_quantity.Title}: at most {Largest:+#,0.####;-#,0.####}{share} at {At.Name}, rms {Rms:#,0.####}");
        }
    }
}
