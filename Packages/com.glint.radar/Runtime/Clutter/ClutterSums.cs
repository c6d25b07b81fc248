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

        /// <summary>Words of a sum: SEA_SUM_WORDS.</summary>
        public const int SumWords = 3;

        // Copies of all cells together, and of one cell: a copy takes the facets whose numbers are equal modulo these.
        const int MaxCopies = 4096, MaxCopiesOfACell = 256;

        /// <summary>Copies of the sums of each cell.</summary>
        public static int CopiesOf(int cells) => Math.Max(1, Math.Min(MaxCopiesOfACell, MaxCopies / cells));

        /// <summary>Words of all sums of cells.</summary>
        public static int WordsOf(int cells) => SumWords * (Overflow + 1) * cells * CopiesOf(cells);

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
                var sums = new double[Overflow + 1];
                for (int sum = 0; sum <= Overflow; sum++)
                    for (int copy = 0; copy < copies; copy++)
                        sums[sum] += UnitsOf(output, SumWords * ((sum * cells + cell) * copies + copy), IsPower(sum));
                if (sums[Overflow] != 0)
                    throw new GlintException($"{owner}: the echo of a facet of the sea is not finite or too large: the "
                        + "mesh may have coordinates that float32 does not resolve");
                echoes[cell] = EchoOf(sums, phase);
            }
            return echoes;
        }

        static bool IsPower(int sum) => sum >= Power && sum < Area;

        // Powers have 96 bits, and are not negative.
        static double UnitsOf(uint[] output, int word, bool isPower)
        {
            long lower = TubeSums.At(output, word);
            return isPower ? (ulong)lower + (double)output[word + 2] * ((double)ulong.MaxValue + 1) : lower;
        }

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
