using System;
using System.Numerics;
using Glint.Core;

namespace Glint
{
    /// <summary>The sums of the cells of a sea, as the kernel leaves them: Shaders/SeaFacets.hlsl.</summary>
    static class ClutterSums
    {
        /// <summary>Numbers of the sums: SEA_FIELD and the others. That of SEA_OVERFLOW is a flag.</summary>
        public const int Field = 0, Power = 6, Area = 9, LitArea = 10, Overflow = 11;

        /// <summary>Units: SEA_FIELD_UNITS a metre, SEA_POWER_UNITS and SEA_AREA_UNITS a square metre.</summary>
        public const double FieldUnits = 1 << 24, PowerUnits = 1L << 40, AreaUnits = 1 << 20;

        // Copies of all cells together, and of one cell: a copy takes the facets whose numbers are equal modulo these.
        const int MaxCopies = 4096, MaxCopiesOfACell = 256;

        // Units: half of what a sum holds; one with more may have wrapped.
        const long MaxOfACopy = 1L << 62;

        /// <summary>Copies of the sums of each cell.</summary>
        public static int CopiesOf(int cells) => Math.Max(1, Math.Min(MaxCopiesOfACell, MaxCopies / cells));

        /// <summary>Words of all sums of cells.</summary>
        public static int WordsOf(int cells) => 2 * (Overflow + 1) * cells * CopiesOf(cells);

        /// <summary>The echo of each cell.</summary>
        /// <param name="phase">Factor of the field: the kernel's phases are about the scene's centre.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">An echo is too large for a sum.</exception>
        public static ClutterEcho[] Echoes(uint[] output, int cells, Complex phase, string owner)
        {
            var echoes = new ClutterEcho[cells];
            int copies = CopiesOf(cells);
            for (int cell = 0; cell < cells; cell++)
            {
                // Copies of a large sea beside a near radar have more than a long together.
                var sums = new double[Overflow + 1];
                for (int sum = 0; sum <= Overflow; sum++)
                    for (int copy = 0; copy < copies; copy++)
                    {
                        long units = TubeSums.At(output, 2 * ((sum * cells + cell) * copies + copy));
                        bool isTooLarge = sum == Overflow ? units != 0
                            : units > MaxOfACopy || units < (IsOfOneSign(sum) ? 0 : -MaxOfACopy);
                        if (isTooLarge)
                            throw new GlintException($"{owner}: the echo of the sea is not finite or too large: the mesh "
                                + "may have coordinates that float32 does not resolve, or the radar is much nearer to the "
                                + "water than to the phase centre, at whose range its echo is counted");
                        sums[sum] += units;
                    }
                echoes[cell] = EchoOf(sums, phase);
            }
            return echoes;
        }

        static bool IsOfOneSign(int sum) => sum >= Power && sum < Area;

        static ClutterEcho EchoOf(double[] sums, Complex phase)
        {
            Complex Amplitude(int polarisation) => phase * new Complex(sums[Field + 2 * polarisation],
                sums[Field + 2 * polarisation + 1]) / FieldUnits;
            double Sigma(int polarisation) => sums[Power + polarisation] / PowerUnits;
            var crossed = Amplitude(1);
            return new ClutterEcho
            {
                S = new ScatteringMatrix { VV = Amplitude(0), HV = crossed, VH = crossed, HH = Amplitude(2) },
                SigmaVV = Sigma(0), SigmaHV = Sigma(1), SigmaHH = Sigma(2),
                Area = sums[Area] / AreaUnits, LitArea = sums[LitArea] / AreaUnits
            };
        }
    }
}
