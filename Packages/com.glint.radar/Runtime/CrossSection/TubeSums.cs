using System;
using System.Linq;
using System.Numerics;
using Glint.Core;

namespace Glint
{
    /// <summary>The sums of a pose over its slices, as the kernels leave them: Shaders/TubeBindings.hlsl.</summary>
    sealed class TubeSums
    {
        /// <summary>Words of the output.</summary>
        public const int Count = 0, Overflow = 1;

        /// <summary>Counts of each part of a pose's slice, and words of those of a pose.</summary>
        public const int FirstPose = 24, PoseWords = 4, PoseParts = 16, PoseTubes = 0, PoseRays = 1, PoseBorderRays = 2,
            PoseBounces = 3;

        /// <summary>Sums of a receiver and sample, two words each, and the word after them.</summary>
        public const int SumCount = 14, Bent = 8, Border = 10, CrossBent = 11, CrossBorder = 13, TooLarge = 28;

        /// <summary>Slots of all poses of a dispatch: Tube.Tag has eight bits for them.</summary>
        public const int MaxSlots = 256;

        // Sums of a copy that make further copies needless: threads then add to many words.
        const int SpreadSums = 32;

        readonly CrossSectionPose _pose;
        readonly TubeGrid _grid;
        readonly long[] _sums;
        long _tubes;
        uint _bounces;

        public TubeSums(CrossSectionPose pose, TubeGrid grid)
        {
            (_pose, _grid) = (pose, grid);
            double wavelength = Signal.Wavelength(pose.Frequencies.Last());
            WaveNumber = 2 * Math.PI / wavelength;
            double side = Math.Min(wavelength, grid.Side), tube = 2 * Math.Sqrt(Math.PI) * side * side / wavelength;
            UnitsPerMetre = Math.Pow(2, 24) / tube;
            UnitsPerSquareMetre = Math.Pow(2, 40) / (tube * tube);
            _sums = new long[SlotsOf(pose) * pose.Samples * SumCount];
        }

        /// <summary>
        /// Slots of sums at each sample: the receivers, and again for paths that have met a sea alone.
        /// </summary>
        public static int SlotsOf(CrossSectionPose pose) =>
            (pose.Scene.Seas.Count > 0 ? 2 : 1) * pose.Receivers.Length;

        /// <summary>Copies of the sums in the output, however many poses: at times all tubes are of one.</summary>
        public static int CopiesOf(CrossSectionPose pose) =>
            (SpreadSums - 1) / (SlotsOf(pose) * pose.Samples) + 1;

        /// <summary>Words of the output, copies included.</summary>
        public static int OutputSize(CrossSectionPose pose, int poses) => TubeKernels.FirstSum
            + TubeKernels.SumWords * CopiesOf(pose) * poses * SlotsOf(pose) * pose.Samples;

        /// <summary>Rays of a pose in an output, in each part of its slice.</summary>
        public static long[] RaysOf(uint[] output, int number)
        {
            var rays = new long[PoseParts];
            for (int part = 0; part < PoseParts; part++)
                rays[part] = (long)CountOf(output, number, part, PoseRays)
                    + CountOf(output, number, part, PoseBorderRays);
            return rays;
        }

        static uint CountOf(uint[] output, int number, int part, int count) =>
            output[FirstPose + PoseWords * (part * TubeKernels.MaxPoses + number) + count];

        /// <summary>Rays traced.</summary>
        public long Rays { get; private set; }

        /// <summary>Of the highest frequency, radians per metre.</summary>
        public double WaveNumber { get; }

        /// <summary>Units of S: 2^-24 of a tube of a square wavelength, or of a smaller base cell.</summary>
        public double UnitsPerMetre { get; }

        /// <summary>Units of squared errors.</summary>
        public double UnitsPerSquareMetre { get; }

        /// <summary>Whether a list was full: the sums are not complete.</summary>
        public static bool HasOverflown(uint[] output) => output[Overflow] != 0;

        /// <summary>Adds a slice.</summary>
        /// <param name="number">Of the pose in the dispatch.</param>
        /// <param name="poses">Of the dispatch.</param>
        /// <exception cref="GlintException">A contribution is too large for a sum.</exception>
        public void Add(uint[] output, int number, int poses, string owner)
        {
            for (int part = 0; part < PoseParts; part++)
            {
                _tubes += CountOf(output, number, part, PoseTubes);
                _bounces = Math.Max(_bounces, CountOf(output, number, part, PoseBounces));
            }
            Rays += RaysOf(output, number).Sum();
            int count = _sums.Length * CopiesOf(_pose);
            for (int i = 0; i < count; i++)
            {
                // Copies hold the sums of all poses.
                int copy = i / _sums.Length, sum = i % _sums.Length;
                int first = TubeKernels.FirstSum
                    + ((copy * poses + number) * (_sums.Length / SumCount) + sum / SumCount) * TubeKernels.SumWords;
                if (output[first + TooLarge] != 0)
                    throw new GlintException($"{owner}: a contribution to the cross section is not finite or too large: "
                        + "the mesh may have coordinates that float32 does not resolve");
                _sums[sum] += At(output, first + 2 * (sum % SumCount));
            }
        }

        /// <summary>A sum of the output, of 64 bits.</summary>
        public static long At(uint[] output, int word) => (long)((ulong)output[word + 1] << 32 | output[word]);

        /// <summary>The matrix of eight sums of a receiver and sample.</summary>
        public ScatteringMatrix MatrixOf(long[] sums, int first, int receiver, int sample)
        {
            Complex Amplitude(int sum) => new Complex(sums[first + sum], sums[first + sum + 1]) / UnitsPerMetre;
            double k = 2 * Math.PI / Signal.Wavelength(_pose.PhaseFrequencyOf(sample));
            var phase = Complex.FromPolarCoordinates(1, k * _grid.PhaseOf(_pose, _pose.Receivers[receiver]));
            return phase * new ScatteringMatrix
            {
                VV = Amplitude(0), HV = Amplitude(2), VH = Amplitude(4), HH = Amplitude(6)
            };
        }

        /// <summary>Adds the sums of others, without their rays.</summary>
        public void Add(TubeSums others)
        {
            _tubes += others._tubes;
            for (int i = 0; i < _sums.Length; i++)
                _sums[i] += others._sums[i];
        }

        /// <summary>The scattering matrices and their errors.</summary>
        public CrossSectionResult ToResult()
        {
            var result = new CrossSectionResult(_pose.Receivers.Length, _pose.Samples)
            {
                Tubes = _tubes, Rays = Rays, Bounces = (int)_bounces
            };
            int first = 0, receivers = _pose.Receivers.Length;
            for (int slot = 0; slot < SlotsOf(_pose); slot++)
                for (int sample = 0; sample < _pose.Samples; sample++, first += SumCount)
                {
                    int receiver = slot % receivers;
                    var s = MatrixOf(_sums, first, receiver, sample);
                    result.S[receiver, sample] += s;
                    if (slot >= receivers)
                        result.Sea[receiver, sample] = s;
                    result.Errors[receiver, sample] =
                        Norm(result.Errors[receiver, sample], ErrorOf(first + Bent, first + Border));
                    result.CrossErrors[receiver, sample] =
                        Norm(result.CrossErrors[receiver, sample], ErrorOf(first + CrossBent, first + CrossBorder));
                }
            return result;
        }

        // bent, border: the sums.
        double ErrorOf(int bent, int border) => Norm(Math.Sqrt(_sums[border] / UnitsPerSquareMetre),
            new Complex(_sums[bent], _sums[bent + 1]).Magnitude / UnitsPerMetre);

        static double Norm(double a, double b) => Math.Sqrt(a * a + b * b);
    }
}
