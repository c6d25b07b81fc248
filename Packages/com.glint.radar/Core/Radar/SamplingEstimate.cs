using System;
using System.Collections.Generic;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// How far the amplitude of a pose is from that of endlessly many rays. It is made from the received rays; the tracer then looks more closely at the pixels it names, with
    /// <see cref="SubRays"/> x <see cref="SubRays"/> rays in each, and hands over their sums to <see cref="Finish"/>.
    /// </summary>
    public sealed class SamplingEstimate
    {
        /// <summary>Sub-rays across and down a pixel: sub-ray (a, b) goes through ((a + 1/2) / 4, (b + 1/2) / 4) of it, from its left and bottom edge, and has number a + 4 b.</summary>
        public const int SubRays = 4;

        /// <summary>Sub-rays a pixel. Those of one number, of all pixels, are a grid as dense as the picture's.</summary>
        public const int SubGrids = SubRays * SubRays;

        // Fewer received rays say little about what lies between them.
        const int FewestRays = 16;

        // Share of neighbouring rays half a wavelength or more apart at which the sum is no integral any more.
        const double MostSteep = 0.5;

        // Pixels that are refined in any case; beyond, as many as make the sub-rays as many as the rays of the pose.
        const int RefinedAlways = 1 << 16;

        // Error of the fine grid over that of the four grids of half its density that it is made of.
        const double FineOverParts = 0.4;

        // A lone ray stands for returns that are smaller than its share of the picture: rays missed others.
        const double Missed = 0.5;

        const int Parts = 4; // the half-density grids: even or odd columns, even or odd rows of sub-rays

        readonly double _wavelength, _referenceTurns;
        readonly ReceivedPicture _picture;
        readonly Tally _tally;
        readonly Complex _refined; // sum of the refined pixels' own rays
        readonly double _share; // what the refined pixels stand for, when there are too many to refine all

        /// <param name="settings">Of the pose.</param>
        /// <param name="received">The received rays, each pixel once, in any order, which is lost.</param>
        /// <param name="count">How many there are in the array.</param>
        /// <param name="referenceLength">Metres that were taken off each <see cref="ReceivedRay.Length"/>.</param>
        public SamplingEstimate(in RadarSettings settings, ReceivedRay[] received, int count, double referenceLength)
        {
            _wavelength = settings.Wavelength;
            _referenceTurns = referenceLength / _wavelength;
            _referenceTurns -= Math.Floor(_referenceTurns);
            _picture = new ReceivedPicture(settings, received, count);
            var isSmooth = new bool[count];
            _tally = LookAtAll(isSmooth);
            var pixels = RefinedPixels.Find(_picture, isSmooth);
            long most = Math.Max(RefinedAlways, settings.RaysEmitted / SubGrids);
            uint every = (uint)((pixels.Count + most - 1) / most);
            if (every > 1)
                pixels.RemoveAll(pixel => Scattered(pixel) % every != 0);
            // Between what errors of one sign and errors of any sign add up to.
            _share = Math.Sqrt(Math.Max(1, every));
            PixelsToRefine = pixels.ToArray();
            _refined = SumRefined();
        }

        /// <summary>Largest difference of path length between received rays that are among each other's eight neighbours in the picture, wavelengths.</summary>
        public double LargestPathStep => _tally.LargestStep / _wavelength;

        /// <summary>The pixels in which to trace sub-rays, in order: x + y * rays across.</summary>
        public uint[] PixelsToRefine { get; }

        /// <summary>Puts the estimate into a pose's result, which has its sums already.</summary>
        /// <param name="inPhase">By number of the sub-ray: sum of cos(phase) over those received, of all <see cref="PixelsToRefine"/>.</param>
        /// <param name="quadrature">The same of sin(phase).</param>
        public void Finish(double[] inPhase, double[] quadrature, RadarResult result)
        {
            var coarse = new Complex(result.InPhase, result.Quadrature);
            Complex all = 0;
            var parts = new Complex[Parts];
            for (int sub = 0; sub < SubGrids; sub++)
            {
                var sum = new Complex(inPhase[sub], quadrature[sub]);
                all += sum;
                parts[sub % 2 + 2 * (sub / SubRays % 2)] += sum;
            }
            Complex fine = coarse + _tally.Smooth + _share * (all / SubGrids - _refined);
            double spread = 0;
            for (int part = 0; part < Parts; part++)
            {
                Complex sum = coarse + _tally.SmoothParts[part] + _share * (parts[part] * Parts / SubGrids - _refined);
                spread += Square((sum - fine).Magnitude) / Parts;
            }
            double lone = _picture.Count == 0 ? 1 : _tally.Lone;
            double norm = RadarResult.NormalRays / result.RaysOfPicture;
            result.SamplingError = norm * Math.Sqrt(Square(result.Amplitude - fine.Magnitude) + Square(FineOverParts) * spread + Square(Missed) * lone);
            result.LargestPathStep = LargestPathStep;
            result.Undersampled = _picture.Count < FewestRays || _tally.SteepPairs > MostSteep * _tally.Pairs;
        }

        // In blocks that are added in their order: the same sum on any machine.
        Tally LookAtAll(bool[] isSmooth)
        {
            var blocks = new SortedDictionary<int, Tally>();
            Blocks.For(_picture.Count, (first, end) =>
            {
                var tally = LookAt(first, end, isSmooth);
                lock (blocks)
                    blocks.Add(first, tally);
            });
            var total = new Tally();
            foreach (var block in blocks.Values)
                total.Add(block);
            return total;
        }

        Tally LookAt(int first, int end, bool[] isSmooth)
        {
            var tally = new Tally();
            if (first == end)
                return tally;
            var near = new ReceivedNeighbours(_picture, first);
            for (int ray = first; ray < end; ray++)
            {
                near.MoveTo(ray);
                if (near.Count == 0)
                    tally.Lone++;
                AddStep(ray, near.East, tally);
                AddStep(ray, near.NorthWest, tally);
                AddStep(ray, near.North, tally);
                AddStep(ray, near.NorthEast, tally);
                if (near.Count < 8)
                    continue;
                var phase = PixelPhase.Of(_picture, ray, near, _wavelength);
                isSmooth[ray] = phase.IsSmooth;
                if (!isSmooth[ray])
                    continue;
                phase.AddMeans(PhasorOf(ray), ref tally.Smooth, tally.SmoothParts);
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
            if (step > _wavelength / 2)
                tally.SteepPairs++;
        }

        Complex SumRefined()
        {
            Complex sum = 0;
            int ray = 0;
            foreach (uint pixel in PixelsToRefine)
            {
                while (ray < _picture.Count && _picture[ray].Pixel < pixel)
                    ray++;
                if (ray < _picture.Count && _picture[ray].Pixel == pixel)
                    sum += PhasorOf(ray);
            }
            return sum;
        }

        Complex PhasorOf(int ray) => Phasors.OfTurns(_picture[ray].Length / _wavelength + _referenceTurns);

        static double Square(double x) => x * x;

        // A number by chance, the same for the same pixel.
        static uint Scattered(uint pixel)
        {
            pixel = (pixel ^ pixel >> 16) * 0x7feb352du;
            pixel = (pixel ^ pixel >> 15) * 0x846ca68bu;
            return pixel ^ pixel >> 16;
        }

        // What neighbours tell, and the smooth pixels' means less their rays.
        sealed class Tally
        {
            public double LargestStep; // metres
            public long Pairs, SteepPairs, Lone;
            public Complex Smooth;
            public readonly Complex[] SmoothParts = new Complex[Parts];

            public void Add(Tally other)
            {
                LargestStep = Math.Max(LargestStep, other.LargestStep);
                Pairs += other.Pairs;
                SteepPairs += other.SteepPairs;
                Lone += other.Lone;
                Smooth += other.Smooth;
                for (int part = 0; part < Parts; part++)
                    SmoothParts[part] += other.SmoothParts[part];
            }
        }
    }
}
