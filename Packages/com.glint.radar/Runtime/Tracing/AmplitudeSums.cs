using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;

namespace Glint
{
    /// <summary>The sums of a pose over its slices, in areas of a base cell; counts are over all attempts.</summary>
    sealed class AmplitudeSums
    {
        /// <summary>
        /// Copies of the counts behind the sums, and words of each of a pose: AMPLITUDE_ in Shaders/TubeBindings.hlsl.
        /// </summary>
        public const int Copies = 32, CountWords = 8, Rays = 0, Hits = 1, Bounces = 2, Received = 3, RevealedParts = 4, Lengths = 6;

        /// <inheritdoc cref="Copies"/>
        public const double LengthUnits = 256;

        /// <summary>Units of the sums, per area of a base cell and per its square.</summary>
        public const double UnitsPerCell = 1 << 24, UnitsPerSquare = 1L << 44;

        // Error by something that a neighbour has found on a side of a cell: a third of a cell of the third level.
        const double RevealedError = 0.3 / 64;

        long _inPhase, _quadrature, _bentInPhase, _bentQuadrature, _squares;
        long _rays, _hits, _bounces, _received, _lengths;

        /// <summary>Words of the output of poses.</summary>
        public static int OutputSize(int poses) =>
            TubeKernels.FirstSum + poses * (TubeKernels.SumWords + Copies * CountWords);

        public Complex Sum => new Complex(_inPhase, _quadrature) / UnitsPerCell;

        /// <summary>Parts of cells in which there is more than the attempt knew.</summary>
        public long Revealed { get; private set; }

        /// <summary>Standard error of what the attempt knew.</summary>
        public double KnownError
        {
            get
            {
                double bent = new Complex(_bentInPhase, _bentQuadrature).Magnitude / UnitsPerCell;
                return Math.Sqrt(_squares / UnitsPerSquare + bent * bent);
            }
        }

        public double Error => Math.Sqrt(KnownError * KnownError + Revealed * RevealedError * RevealedError);

        /// <summary>Begins an attempt.</summary>
        public void Clear() => Revealed = _inPhase = _quadrature = _bentInPhase = _bentQuadrature = _squares = 0;

        /// <summary>
        /// Adds what a slice has revealed of which a list was full: it is traced again, and what it has found stays marked.
        /// </summary>
        public void AddRevealed(uint[] output, int number, int poses) =>
            Revealed += CountOf(output, number, poses, RevealedParts);

        /// <summary>Adds a slice.</summary>
        /// <param name="number">Of the pose in the dispatch.</param>
        /// <param name="poses">Of the dispatch.</param>
        /// <exception cref="GlintException">A contribution is too large for a sum.</exception>
        public void Add(uint[] output, int number, int poses, string owner)
        {
            int first = TubeKernels.FirstSum + number * TubeKernels.SumWords;
            if (output[first + TubeSums.TooLarge] != 0)
                throw new GlintException($"{owner}: a part of the amplitude is not finite: "
                    + "the mesh may have coordinates that float32 does not resolve");
            _inPhase += TubeSums.At(output, first);
            _quadrature += TubeSums.At(output, first + 2);
            _bentInPhase += TubeSums.At(output, first + 2 * TubeSums.Bent);
            _bentQuadrature += TubeSums.At(output, first + 2 * TubeSums.Bent + 2);
            _squares += TubeSums.At(output, first + 2 * TubeSums.Border);
            AddRevealed(output, number, poses);
            _rays += CountOf(output, number, poses, Rays);
            _hits += CountOf(output, number, poses, Hits);
            _bounces += CountOf(output, number, poses, Bounces);
            _received += CountOf(output, number, poses, Received);
            _lengths += CopiesOf(number, poses).Sum(copy => TubeSums.At(output, copy + Lengths));
        }

        /// <param name="originDepth">From the radar to where rays start, metres.</param>
        /// <param name="scale">Rays of the picture a base cell.</param>
        /// <param name="turns">Phase that the sums lack, turns.</param>
        public RadarSums ToSums(in RadarPose pose, double originDepth, double scale, double turns)
        {
            var sum = scale * Sum * Complex.FromPolarCoordinates(1, 2 * Math.PI * (turns - Math.Floor(turns)));
            return new RadarSums
            {
                InPhase = sum.Real, Quadrature = sum.Imaginary, RaysOfPicture = pose.Settings.RayCount,
                RaysEmitted = _rays, RaysHit = _hits, RaysReceived = _received, Bounces = _bounces,
                PathLengthMeters = _hits * originDepth + _lengths / LengthUnits,
                RayArea = pose.View.RayArea(pose.Settings), PhaseHistogram = null
            };
        }

        static long CountOf(uint[] output, int number, int poses, int count) =>
            CopiesOf(number, poses).Sum(copy => (long)output[copy + count]);

        // The first words of a pose's copies.
        static IEnumerable<int> CopiesOf(int number, int poses) => Enumerable.Range(0, Copies)
            .Select(copy => TubeKernels.FirstSum + poses * TubeKernels.SumWords + (copy * poses + number) * CountWords);
    }
}
