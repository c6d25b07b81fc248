using System;
using System.Collections.Generic;
using System.Threading;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The kernel's rays beside the judge's, one by one. A ray has gone wrong unless it went the judge's way,
    /// or passes an edge so near that the judge goes the kernel's way from a place in the picture a little beside:
    /// so near that float32 cannot tell the places on the target apart.
    /// </summary>
    public sealed class RayComparison
    {
        /// <summary>Rays that went wrong and are kept one by one, at most.</summary>
        public const int MostKept = 20;

        // Of the scene's size. A float32 place at its rim, brought to a mesh's frame,
        // is rounded some eight times by half a step: 22 micrometres where the scene is 92 m from corner to corner.
        const double Step = 1.0 / (1 << 22);

        // A sliver narrower than a step is not found by steps alone.
        const int Rings = 4, RingRatio = 4, Sides = 8;

        // A length that differs less is that of the same path, metres; and a last direction, radians.
        const double SameLength = 1e-7, SameDirection = 1e-5;

        // Two float32 numbers hold 48 bits of a length; some are lost on its way.
        const double TwoFloatRounding = 1.0 / (1L << 44);

        // The path of a ray that is not received is followed in float32, which turns thin triangles a little:
        // so much of the scene's size its length may be off.
        const double LostOfSize = 1e-3;

        readonly Judge _judge;
        readonly RadarSettings _settings;
        readonly double _tolerance, _sceneSize;
        readonly RadarSums _kernelSums, _judgeSums;
        readonly List<(RayData Kernel, JudgeRay Judge)> _wrongRays = new List<(RayData, JudgeRay)>();
        double _sumOfSquares;

        /// <summary>A comparison in which no ray has been compared yet.</summary>
        /// <param name="lengthTolerance">
        /// Difference of a received ray's length that is allowed besides rounding, metres.
        /// </param>
        public RayComparison(in RadarPose pose, double lengthTolerance)
        {
            _judge = new Judge(pose);
            _settings = pose.Settings;
            _tolerance = lengthTolerance;
            _sceneSize = 2 * _judge.SceneRadius;
            _kernelSums = new RadarSums { RaysOfPicture = _settings.RayCount };
            _judgeSums = new RadarSums { RaysOfPicture = _settings.RayCount };
        }

        /// <summary>Rays compared.</summary>
        public long Rays { get; private set; }

        /// <summary>Of these, those that went the judge's way.</summary>
        public long Same { get; private set; }

        /// <summary>Of these, those that passed an edge on its other side, so near that float32 cannot tell.</summary>
        public long AtEdge { get; private set; }

        /// <summary>
        /// Of these, those that went another way, or whose length differs by more than the tolerance.
        /// </summary>
        public long Wrong { get; private set; }

        /// <summary>The first rays that went wrong.</summary>
        public IReadOnlyList<(RayData Kernel, JudgeRay Judge)> WrongRays => _wrongRays;

        /// <summary>The kernel's sums over the rays that went the judge's way.</summary>
        public RadarResult KernelSums => new RadarResult(_kernelSums);

        /// <summary>The judge's sums over the same rays.</summary>
        public RadarResult JudgeSums => new RadarResult(_judgeSums);

        /// <summary>
        /// Largest difference between the lengths of received rays that went the judge's way, metres.
        /// </summary>
        public double LargestLengthDifference { get; private set; }

        /// <summary>Root of the mean square of these differences, metres; 0 when no ray was received.</summary>
        public double RmsLengthDifference =>
            _kernelSums.RaysReceived > 0 ? math.sqrt(_sumOfSquares / _kernelSums.RaysReceived) : 0;

        /// <summary>Largest difference between their phases, radians.</summary>
        public double LargestPhaseDifference { get; private set; }

        /// <summary>Compares rays; those added before count too.</summary>
        /// <param name="progress">Told how much is done, 0 to 1, from any thread; may be null.</param>
        /// <exception cref="OperationCanceledException">It was cancelled.</exception>
        public void Add(RayData[] rays, IProgress<double> progress = null, CancellationToken cancel = default)
        {
            var judged = _judge.TraceSame(rays, progress, cancel);
            for (int i = 0; i < rays.Length; i++)
            {
                cancel.ThrowIfCancellationRequested();
                Add(rays[i], judged[i]);
            }
        }

        void Add(in RayData ray, in JudgeRay judged)
        {
            Rays++;
            bool isSame = IsAsLong(ray, judged, SameLength)
                && math.distance(ray.Direction, judged.Direction) <= SameDirection;
            if (!isSame)
            {
                var beside = Beside(ray, judged);
                if (IsAmong(ray, beside, judged, onItsWay: false))
                {
                    AtEdge++;
                    return;
                }
                // A path that is lost is right if it is that of a ray a little beside.
                isSame = IsAsLong(ray, judged, _tolerance)
                    || !judged.Received && IsAmong(ray, beside, judged, onItsWay: true);
            }
            if (!isSame)
            {
                Wrong++;
                if (_wrongRays.Count < MostKept)
                    _wrongRays.Add((ray, judged));
                return;
            }
            Same++;
            AddSums(ray, judged);
        }

        bool IsAsLong(in RayData ray, in JudgeRay judged, double tolerance) =>
            EndsAs(ray, judged) && math.abs(ray.ExactPathLength - judged.LengthToEnd) <= tolerance + Rounding(judged);

        static bool EndsAs(in RayData ray, in JudgeRay judged) =>
            ray.Bounces == judged.Bounces && ray.IsReceived == judged.Received;

        static bool IsSameWay(in JudgeRay a, in JudgeRay b) => a.Way == b.Way && a.Received == b.Received;

        double Rounding(in JudgeRay judged) =>
            judged.Received
                ? TwoFloatRounding * judged.PathLength
                : LostOfSize * _sceneSize + Step * judged.LengthToLastHit;

        // The judge's ray, and those through places around it.
        List<JudgeRay> Beside(in RayData ray, in JudgeRay judged)
        {
            // A ray that hit nothing ends where it started.
            double distance = judged.Bounces > 0 ? judged.LengthToFirstHit : math.distance(ray.LastHit, judged.LastHit);
            // Every bounce rounds anew.
            int bounces = math.max(1, math.max(judged.Bounces, (int)ray.Bounces));
            double step = bounces * Step * _sceneSize / _judge.RaySpacing(distance);
            var rays = new List<JudgeRay> { judged };
            for (int ring = 0; ring < Rings; ring++, step /= RingRatio)
                for (int side = 0; side < Sides; side++)
                {
                    double angle = 2 * math.PI_DBL * side / Sides;
                    rays.Add(_judge.Trace(_judge.ColumnOf(ray) + step * math.cos(angle),
                        _judge.RowOf(ray) + step * math.sin(angle)));
                }
            return rays;
        }

        // True if a ray ends as others that go the judge's way, or that go another:
        // as long as some of them are, or would be a step farther.
        bool IsAmong(in RayData ray, List<JudgeRay> others, in JudgeRay judged, bool onItsWay)
        {
            foreach (var first in others)
            {
                if (IsSameWay(first, judged) != onItsWay || !EndsAs(ray, first))
                    continue;
                double least = first.LengthToEnd, most = least;
                foreach (var other in others)
                    if (IsSameWay(other, first))
                        (least, most) = (math.min(least, other.LengthToEnd), math.max(most, other.LengthToEnd));
                double slack = most - least + 4 * Step * _sceneSize + Rounding(first);
                if (ray.ExactPathLength >= least - slack && ray.ExactPathLength <= most + slack)
                    return true;
            }
            return false;
        }

        void AddSums(in RayData ray, in JudgeRay judged)
        {
            AddTo(_kernelSums, (int)ray.Bounces, ray.ExactPathLength);
            AddTo(_judgeSums, judged.Bounces, judged.LengthToEnd);
            if (!judged.Received)
                return;
            double phase = Signal.Phase(judged.PathLength, _settings.Wavelength),
                difference = math.abs(ray.ExactPathLength - judged.PathLength);
            _kernelSums.AddReceived(ray.Phase, ray.InPhase, ray.Quadrature);
            _judgeSums.AddReceived(phase, math.cos(phase), math.sin(phase));
            LargestLengthDifference = math.max(LargestLengthDifference, difference);
            LargestPhaseDifference =
                math.max(LargestPhaseDifference, math.abs(Math.IEEERemainder(ray.Phase - phase, 2 * math.PI_DBL)));
            _sumOfSquares += difference * difference;
        }

        static void AddTo(RadarSums sums, int bounces, double length)
        {
            sums.RaysEmitted++;
            sums.RaysHit += bounces > 0 ? 1 : 0;
            sums.Bounces += bounces;
            sums.PathLengthMeters += length;
        }
    }
}
