using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Estimates the difference between the amplitude of a pose and that of infinitely many rays. It chooses pixels
    /// from the received rays; the tracer traces <see cref="SubRays"/> x <see cref="SubRays"/> sub-rays in each and
    /// passes their sums to <see cref="Finish"/>. The estimate is a magnitude, not a bound. Derivation and validation:
    /// Documentation~/accuracy.md.
    /// </summary>
    public sealed class SamplingEstimate
    {
        /// <summary>
        /// Sub-rays across and down a pixel: sub-ray (a, b) goes through ((a + 1/2) / 4, (b + 1/2) / 4) of it,
        /// from its left and bottom edge, and has number a + 4 b.
        /// </summary>
        public const int SubRays = 4;

        /// <summary>
        /// Sub-rays a pixel. Sub-rays of the same number form a grid of the picture's density.
        /// </summary>
        public const int SubGrids = SubRays * SubRays;

        /// <summary>Minimum received rays for a reliable estimate.</summary>
        public const int FewestRays = 16;

        /// <summary>
        /// Path difference of neighbours, in wavelengths, from which on they say nothing about the rays between them.
        /// </summary>
        public const double StepApart = 0.5;

        /// <summary>
        /// Share of such neighbours, and of rays without neighbours, above which the sum no longer approximates the
        /// integral.
        /// </summary>
        internal const double MaxApart = 0.5;

        // Pixels that are refined in any case. Above this number: as many as make as many sub-rays as the pose has
        // rays.
        const int RefinedAlways = 1 << 16;

        // Standard error of an edge's position from sub-rays, in pixels; the maximum error is 1/8.
        const double EdgePosition = 0.06;

        // A ray without neighbours is a return smaller than its pixel; rays miss other such returns. Error of the sum
        // for each such ray, in rays, when their phases are random.
        const double Missed = 1.0 / 3;

        readonly double _wavelength, _referenceTurns;
        readonly ReceivedPicture _picture;
        readonly Tally _tally;
        readonly double _edges;
        readonly Complex _refined; // sum of the refined pixels' own rays
        readonly double _share; // weight of a refined pixel if not all are refined

        /// <summary>Analyses the received rays of a pose and chooses the pixels to refine.</summary>
        /// <param name="settings">Of the pose.</param>
        /// <param name="received">The received rays, each pixel once, in any order; sorted in place.</param>
        /// <param name="count">Number of rays in the array.</param>
        /// <param name="referenceLength">Metres to add to each <see cref="ReceivedRay.Length"/>.</param>
        /// <param name="areChosen">
        /// The device has chosen the same pixels and traced the sub-rays of all of them: no <see cref="PixelsToRefine"/>.
        /// </param>
        public SamplingEstimate(in RadarSettings settings, ReceivedRay[] received, int count, double referenceLength,
            bool areChosen = false)
        {
            _wavelength = settings.Wavelength;
            _referenceTurns = referenceLength / _wavelength;
            _referenceTurns -= Math.Floor(_referenceTurns);
            _picture = new ReceivedPicture(settings, received, count);
            var isSmooth = new bool[count];
            _tally = LookAtAll(isSmooth);
            var pixels = areChosen ? new List<uint>() : RefinedPixels.Find(_picture, isSmooth);
            uint every = RefineEvery(pixels.Count, settings.RaysEmitted);
            if (every > 1)
                pixels.RemoveAll(pixel => !IsChosen(pixel, every));
            PixelsToRefine = pixels.ToArray();
            // The errors of the other pixels add up if they are correlated, their squares if they are independent: the
            // weight is between the two.
            _share = Math.Sqrt(every);
            (_edges, _refined) = SumRefined(isSmooth, every);
        }

        /// <summary>
        /// Maximum path difference between received rays of neighbouring pixels (eight neighbours), wavelengths.
        /// </summary>
        public double LargestPathStep => _tally.LargestStep / _wavelength;

        /// <summary>The pixels in which to trace sub-rays, in order: x + y * rays across.</summary>
        public uint[] PixelsToRefine { get; }

        /// <summary>The estimate of a pose.</summary>
        /// <param name="sum">Sum of the phasors of its received rays.</param>
        /// <param name="raysOfPicture">Rays of the whole picture.</param>
        /// <param name="inPhase">
        /// By number of the sub-ray: sum of cos(phase) over those received, of all <see cref="PixelsToRefine"/>.
        /// </param>
        /// <param name="quadrature">The same of sin(phase).</param>
        public SamplingReport Finish(Complex sum, long raysOfPicture, double[] inPhase, double[] quadrature)
        {
            var subRays = new Complex(inPhase.Sum(), quadrature.Sum());
            Complex fine = sum + _tally.Smooth + _share * (subRays / SubGrids - _refined);
            double edges = EdgePosition * _edges, difference = sum.Magnitude - fine.Magnitude;
            double missed = Missed * Missed * (_picture.Count > 0 ? _tally.Alone : 1);
            double error = Math.Sqrt(difference * difference + edges * edges + missed)
                * RadarResult.NormalRays / raysOfPicture;
            bool undersampled = _picture.Count < FewestRays
                || _tally.Apart + _tally.Alone > MaxApart * (_tally.Pairs + _tally.Alone);
            return new SamplingReport(error, LargestPathStep, undersampled);
        }

        // In blocks that are added in a fixed order: the same sum on any machine.
        Tally LookAtAll(bool[] isSmooth)
        {
            var blocks = new Tally[_picture.Count / Blocks.Size + 1];
            Blocks.For(_picture.Count, (first, end) => blocks[first / Blocks.Size] = LookAt(first, end, isSmooth));
            var total = new Tally();
            foreach (var block in blocks)
                if (block != null)
                    total.Add(block);
            return total;
        }

        Tally LookAt(int first, int end, bool[] isSmooth)
        {
            var tally = new Tally();
            var near = new ReceivedNeighbours(_picture, first);
            for (int ray = first; ray < end; ray++)
            {
                near.MoveTo(ray);
                tally.FirstColumn = Math.Min(tally.FirstColumn, near.Column);
                tally.LastColumn = Math.Max(tally.LastColumn, near.Column);
                int count = near.Count;
                if (count == 0)
                    tally.Alone++;
                AddStep(ray, near.East, tally);
                AddStep(ray, near.NorthWest, tally);
                AddStep(ray, near.North, tally);
                AddStep(ray, near.NorthEast, tally);
                if (count < 8)
                    continue;
                var phase = PixelPhase.Of(_picture, ray, near, _wavelength);
                isSmooth[ray] = phase.IsSmooth;
                if (isSmooth[ray])
                    tally.Smooth += PhasorOf(ray) * (phase.Mean - 1);
            }
            return tally;
        }

        void AddStep(int ray, int neighbour, Tally tally)
        {
            if (neighbour < 0)
                return;
            double step = Math.Abs((double)_picture[ray].Length - _picture[neighbour].Length);
            tally.LargestStep = Math.Max(tally.LargestStep, step);
            tally.Pairs++;
            if (step >= StepApart * _wavelength)
                tally.Apart++;
        }

        // The strength of the edges, and the sum over the refined pixels' own rays: those that are not smooth.
        (double edges, Complex refined) SumRefined(bool[] isSmooth, uint every)
        {
            var edges = new ReceivedEdges(_picture, _tally.FirstColumn, _tally.LastColumn);
            var near = new ReceivedNeighbours(_picture, 0);
            Complex refined = 0;
            for (int ray = 0; ray < _picture.Count; ray++)
            {
                if (isSmooth[ray])
                    continue;
                near.MoveTo(ray);
                var phasor = PhasorOf(ray);
                edges.Add(near, phasor);
                if (IsChosen(_picture[ray].Pixel, every))
                    refined += phasor;
            }
            return (edges.Strength(), refined);
        }

        // Of this number of pixels one is refined: 1 within the limit.
        static uint RefineEvery(long pixels, long raysEmitted)
        {
            long max = Math.Max(RefinedAlways, raysEmitted / SubGrids);
            return (uint)Math.Max(1, (pixels + max - 1) / max);
        }

        // A random selection.
        static bool IsChosen(uint pixel, uint every) => every == 1 || Scattered(pixel) % every == 0;

        Complex PhasorOf(int ray) => Phasors.OfTurns(_picture[ray].Length / _wavelength + _referenceTurns);

        // A random number that depends on the pixel alone.
        static uint Scattered(uint pixel)
        {
            pixel = (pixel ^ pixel >> 16) * 0x7feb352du;
            pixel = (pixel ^ pixel >> 15) * 0x846ca68bu;
            return pixel ^ pixel >> 16;
        }

        sealed class Tally
        {
            public double LargestStep; // metres
            public long Pairs, Apart, Alone; // neighbours, those half a wavelength apart, rays without neighbours
            public Complex Smooth; // sum over smooth pixels of mean phasor less the ray's phasor
            public int FirstColumn = int.MaxValue, LastColumn = -1; // of the rays

            public void Add(Tally other)
            {
                LargestStep = Math.Max(LargestStep, other.LargestStep);
                Pairs += other.Pairs;
                Apart += other.Apart;
                Alone += other.Alone;
                Smooth += other.Smooth;
                FirstColumn = Math.Min(FirstColumn, other.FirstColumn);
                LastColumn = Math.Max(LastColumn, other.LastColumn);
            }
        }
    }
}
