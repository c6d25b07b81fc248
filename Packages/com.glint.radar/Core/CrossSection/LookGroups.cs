using System;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Neighbouring looks of an image that share a trace: that of their middle, in which the scene turns about the
    /// vertical through the phase centre instead of the radar. Times of the turn, with factors of the wave number, take
    /// the place of pulses.
    /// </summary>
    /// <remarks>
    /// A path over plane mirrors has the length L(a) = -q.r(a), with r(a) the direction of the radar after the angle a,
    /// and q the sum of the last place and of the image of it that the mirrors show to the radar; of one bounce twice
    /// its place. With t across the view and m up across it, at the elevation e,
    /// r(a) = s r(0) + sin(a) cos(e) t + (1 - cos(a)) cos(e) sin(e) m, with s = 1 - (1 - cos(a)) cos(e)^2. The lengths
    /// and rates of a trace give the first two terms. The last one is left out.
    /// </remarks>
    public sealed class LookGroups
    {
        // Rate of the turn, radians a second: the times are angles.
        const double TurnRate = 1;

        // Relative change of a strength by the angle, 1/rad: tan i of a facet at an incidence angle i of 87 degrees.
        const double MaxSlope = 20;

        // Samples of a trace at most: their sums take 2 MB.
        const int MaxSamples = 1 << 14;

        readonly double _first, _step;

        /// <summary>Groups of one look: the looks share no traces.</summary>
        public LookGroups() => Looks = 1;

        /// <param name="plan">Of azimuths at equal steps and one elevation.</param>
        /// <param name="boxMin">Of the scene about the phase centre, metres.</param>
        /// <param name="boxMax">Of the scene about the phase centre, metres.</param>
        /// <param name="maxError">Of an echo, as a fraction of it.</param>
        /// <param name="maxPart">
        /// Of an echo, as a fraction of what its surface returns at most; and of the phase that is left out, radians.
        /// </param>
        public LookGroups(CrossSectionPlan plan, double3 boxMin, double3 boxMax, double maxError, double maxPart)
        {
            int rowsOfPose = plan.Count / plan.Poses;
            var (first, last) = (plan[0], plan[plan.Count - 1]);
            _first = first.AzimuthDegrees;
            _step = (last.AzimuthDegrees - _first) / Math.Max(1, plan.Poses - 1);
            double elevation = math.radians(first.ElevationDegrees), step = Math.Abs(math.radians(_step));
            double height = math.csum(math.abs(first.Radar.Up) * math.max(math.abs(boxMin), math.abs(boxMax)));
            double wave = 2 * Math.PI / Signal.Wavelength(plan.Frequencies.Last());
            // k (1 - cos(a)) cos(e) sin(e) |q.m|, with |q.m| up to twice that of a place.
            double perSquare = 0.5 * wave * height * Math.Abs(Math.Sin(2 * elevation));
            double angle = Math.Min(Math.Min(maxPart, maxError / MaxSlope), Math.Sqrt(maxPart / perSquare));
            int most = (int)Math.Min(Math.Min(plan.Poses, MaxSamples / rowsOfPose), 1 + Math.Floor(2 * angle / step));
            int groups = (plan.Poses - 1) / Math.Max(1, most) + 1;
            Looks = (plan.Poses - 1) / groups + 1;
            double square = Math.Cos(elevation) * Math.Cos(elevation);
            Factors = Enumerable.Range(0, Looks).Select(look => 1 - (1 - Math.Cos(AngleOf(look))) * square).ToArray();
            Times = Factors.Select((factor, look) => Math.Sin(AngleOf(look)) / factor / TurnRate).ToArray();
        }

        /// <summary>Looks of a group; the last one may have fewer.</summary>
        public int Looks { get; }

        /// <summary><see cref="CrossSectionPose.Times"/> of the looks of a group.</summary>
        public double[] Times { get; }

        /// <summary><see cref="CrossSectionPose.WaveFactors"/> of the looks of a group.</summary>
        public double[] Factors { get; }

        /// <summary>The first look of the group of a look.</summary>
        public int FirstOf(int look) => look / Looks * Looks;

        /// <summary>Azimuth in the middle of the group of a look, degrees.</summary>
        public double MiddleOf(int look) => _first + (FirstOf(look) + 0.5 * (Looks - 1)) * _step;

        /// <summary>The motion of a scene for a radar that turns.</summary>
        public static RigidMotion TurnAbout(double3 phaseCentre) =>
            new RigidMotion { AngularVelocity = new double3(0, -TurnRate, 0), Pivot = phaseCentre };

        double AngleOf(int look) => math.radians((look - 0.5 * (Looks - 1)) * _step);
    }
}
