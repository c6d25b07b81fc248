using System;
using System.Numerics;
using Glint.Core;

namespace Glint
{
    /// <summary>The sums of the cells of a sea, as the kernel leaves them: Shaders/SeaFacets.hlsl.</summary>
    static class ClutterSums
    {
        /// <summary>Words of a copy of a cell's sums: SEA_WORDS and the places of the sums in it.</summary>
        public const int CopyWords = 24, Field = 0, Power = 12, Area = 18, LitArea = 20, Overflow = 22;

        /// <summary>Units: SEA_FIELD_UNITS a metre, SEA_POWER_UNITS and SEA_AREA_UNITS a square metre.</summary>
        public const double FieldUnits = 1 << 24, PowerUnits = 1L << 40, AreaUnits = 1 << 20;

        // Copies of all cells together, and of one cell: a copy takes the facets whose numbers are equal modulo these.
        const int MaxCopies = 4096, MaxCopiesOfACell = 64;

        /// <summary>Copies of the sums of each cell.</summary>
        public static int CopiesOf(int cells) => Math.Max(1, Math.Min(MaxCopiesOfACell, MaxCopies / cells));

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
                var sums = new long[CopyWords / 2];
                for (int copy = 0; copy < copies; copy++)
                    Add(output, CopyWords * (cell * copies + copy), sums, owner);
                echoes[cell] = EchoOf(sums, phase);
            }
            return echoes;
        }

        static void Add(uint[] output, int first, long[] sums, string owner)
        {
            if (output[first + Overflow] != 0)
                throw new GlintException($"{owner}: the echo of a facet of the sea is not finite or too large: the "
                    + "mesh may have coordinates that float32 does not resolve");
            for (int i = 0; i < Overflow / 2; i++)
                sums[i] += TubeSums.At(output, first + 2 * i);
        }

        static ClutterEcho EchoOf(long[] sums, Complex phase)
        {
            Complex Amplitude(int polarisation) => phase * new Complex(sums[Field / 2 + 2 * polarisation],
                sums[Field / 2 + 2 * polarisation + 1]) / FieldUnits;
            double Sigma(int polarisation) => sums[Power / 2 + polarisation] / PowerUnits;
            var crossed = Amplitude(1);
            return new ClutterEcho
            {
                S = new ScatteringMatrix { VV = Amplitude(0), HV = crossed, VH = crossed, HH = Amplitude(2) },
                SigmaVV = Sigma(0), SigmaHV = Sigma(1), SigmaHH = Sigma(2),
                Area = sums[Area / 2] / AreaUnits, LitArea = sums[LitArea / 2] / AreaUnits
            };
        }
    }
}
