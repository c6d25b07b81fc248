using System;
using System.Collections.Generic;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// Compares the kernel's rays with the reference tracer's, one by one. A ray is right if it has the reference
    /// tracer's path, or if it passes an edge so near that the reference tracer's ray through a slightly different
    /// point of the picture has the kernel's path. The difference is below the float32 resolution of positions on the
    /// target.
    /// </summary>
    public sealed class RayComparison
    {
        /// <summary>Maximum number of wrong rays listed.</summary>
        public const int MaxListed = 20;

        // Fraction of the scene's size. A float32 position at its border, transformed to a mesh's frame, is rounded
        // some eight times by half a step: 22 micrometres in a scene with a diagonal of 92 m.
        const double Step = 1.0 / (1 << 22);

        // Rings of smaller radius find slivers narrower than a step.
        const int Rings = 4, RingRatio = 4, Sides = 8;

        // Maximum difference of the lengths of one path, metres, and of its last directions, radians.
        const double SameLength = 1e-7, SameDirection = 1e-5;

        // Double-float has 48 bits; some are lost along the path.
        const double DoubleFloatRounding = 1.0 / (1L << 44);

        // Maximum length error of a ray that is not received, as a fraction of the scene's size: it is traced in
        // float32, whose normals of thin triangles are inaccurate.
        const double LostOfSize = 1e-3;

        readonly ReferenceTracer _referenceTracer;
        readonly RadarSettings _settings;
        readonly double _tolerance, _sceneSize;
        readonly RadarSums _kernelSums, _referenceSums;
        readonly List<(RayData Kernel, ReferenceRay Reference)> _wrongRays = new List<(RayData, ReferenceRay)>();
        double _sumOfSquares;

        /// <summary>An empty comparison.</summary>
        /// <param name="lengthTolerance">
        /// Maximum length difference of received rays in addition to rounding, metres.
        /// </param>
        public RayComparison(in RadarPose pose, double lengthTolerance)
        {
            _referenceTracer = new ReferenceTracer(pose);
            _settings = pose.Settings;
            _tolerance = lengthTolerance;
            _sceneSize = 2 * _referenceTracer.SceneRadius;
            _kernelSums = new RadarSums { RaysOfPicture = _settings.RayCount };
            _referenceSums = new RadarSums { RaysOfPicture = _settings.RayCount };
        }

        /// <summary>Rays compared.</summary>
        public long Rays { get; private set; }

        /// <summary>Rays with the reference tracer's path.</summary>
        public long Same { get; private set; }

        /// <summary>Rays that pass an edge on the other side, within the float32 resolution.</summary>
        public long AtEdge { get; private set; }

        /// <summary>
        /// Rays with another path, or with a length difference above the tolerance.
        /// </summary>
        public long Wrong { get; private set; }

        /// <summary>The first wrong rays.</summary>
        public IReadOnlyList<(RayData Kernel, ReferenceRay Reference)> WrongRays => _wrongRays;

        /// <summary>The kernel's sums over the rays with the reference tracer's path.</summary>
        public RadarResult KernelSums => new RadarResult(_kernelSums);

        /// <summary>The reference tracer's sums over the same rays.</summary>
        public RadarResult ReferenceSums => new RadarResult(_referenceSums);

        /// <summary>
        /// Maximum length difference of received rays with the reference tracer's path, metres.
        /// </summary>
        public double LargestLengthDifference { get; private set; }

        /// <summary>Root mean square of these differences, metres; 0 if no ray was received.</summary>
        public double RmsLengthDifference =>
            _kernelSums.RaysReceived > 0 ? math.sqrt(_sumOfSquares / _kernelSums.RaysReceived) : 0;

        /// <summary>Maximum difference of their phases, radians.</summary>
        public double LargestPhaseDifference { get; private set; }

        /// <summary>Compares rays and adds them to the counts.</summary>
        /// <param name="progress">Receives the fraction done, 0 to 1, from any thread; may be null.</param>
        /// <exception cref="OperationCanceledException">It was cancelled.</exception>
        public void Add(RayData[] rays, IProgress<double> progress = null, CancellationToken cancel = default)
        {
            var references = _referenceTracer.TraceSame(rays, progress, cancel);
            for (int i = 0; i < rays.Length; i++)
            {
                cancel.ThrowIfCancellationRequested();
                Add(rays[i], references[i]);
            }
        }

        void Add(in RayData ray, in ReferenceRay reference)
        {
            Rays++;
            bool isSame = IsAsLong(ray, reference, SameLength)
                && math.distance(ray.Direction, reference.Direction) <= SameDirection;
            if (!isSame)
            {
                var beside = Beside(ray, reference);
                if (IsAmong(ray, beside, reference, onSamePath: false))
                {
                    AtEdge++;
                    return;
                }
                // A path that is not received is right if a slightly displaced ray has it.
                isSame = IsAsLong(ray, reference, _tolerance)
                    || !reference.Received && IsAmong(ray, beside, reference, onSamePath: true);
            }
            if (!isSame)
            {
                Wrong++;
                if (_wrongRays.Count < MaxListed)
                    _wrongRays.Add((ray, reference));
                return;
            }
            Same++;
            AddSums(ray, reference);
        }

        bool IsAsLong(in RayData ray, in ReferenceRay reference, double tolerance) =>
            EndsAs(ray, reference)
            && math.abs(ray.RefinedPathLength - reference.LengthToEnd) <= tolerance + Rounding(reference);

        static bool EndsAs(in RayData ray, in ReferenceRay reference) =>
            ray.Bounces == reference.Bounces && ray.IsReceived == reference.Received;

        static bool HasSamePath(in ReferenceRay a, in ReferenceRay b) =>
            a.PathHash == b.PathHash && a.Received == b.Received;

        double Rounding(in ReferenceRay reference) =>
            reference.Received
                ? DoubleFloatRounding * reference.PathLength
                : LostOfSize * _sceneSize + Step * reference.LengthToLastHit;

        // The reference tracer's ray, and those through points around it.
        List<ReferenceRay> Beside(in RayData ray, in ReferenceRay reference)
        {
            // A ray that hit nothing ends at its start.
            double distance =
                reference.Bounces > 0 ? reference.LengthToFirstHit : math.distance(ray.LastHit, reference.LastHit);
            // Every bounce adds its rounding.
            int bounces = math.max(1, math.max(reference.Bounces, (int)ray.Bounces));
            double step = bounces * Step * _sceneSize / _referenceTracer.RaySpacing(distance);
            var rays = new List<ReferenceRay> { reference };
            for (int ring = 0; ring < Rings; ring++, step /= RingRatio)
                for (int side = 0; side < Sides; side++)
                {
                    double angle = 2 * math.PI_DBL * side / Sides;
                    rays.Add(_referenceTracer.Trace(_referenceTracer.ColumnOf(ray) + step * math.cos(angle),
                        _referenceTracer.RowOf(ray) + step * math.sin(angle)));
                }
            return rays;
        }

        // True if a ray ends as some of the other rays, with the reference tracer's path or with another one: its
        // length is within the range of theirs, extended by a step.
        bool IsAmong(in RayData ray, List<ReferenceRay> others, in ReferenceRay reference, bool onSamePath)
        {
            foreach (var first in others)
            {
                if (HasSamePath(first, reference) != onSamePath || !EndsAs(ray, first))
                    continue;
                double min = first.LengthToEnd, max = min;
                foreach (var other in others)
                    if (HasSamePath(other, first))
                        (min, max) = (math.min(min, other.LengthToEnd), math.max(max, other.LengthToEnd));
                double tolerance = max - min + 4 * Step * _sceneSize + Rounding(first);
                if (ray.RefinedPathLength >= min - tolerance && ray.RefinedPathLength <= max + tolerance)
                    return true;
            }
            return false;
        }

        void AddSums(in RayData ray, in ReferenceRay reference)
        {
            AddTo(_kernelSums, (int)ray.Bounces, ray.RefinedPathLength);
            AddTo(_referenceSums, reference.Bounces, reference.LengthToEnd);
            if (!reference.Received)
                return;
            double phase = Signal.Phase(reference.PathLength, _settings.Wavelength),
                difference = math.abs(ray.RefinedPathLength - reference.PathLength);
            _kernelSums.AddReceived(ray.Phase, ray.InPhase, ray.Quadrature);
            _referenceSums.AddReceived(phase, math.cos(phase), math.sin(phase));
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
