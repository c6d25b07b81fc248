using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>Fringe fields of edges: what the field has beside that of physical optics.</summary>
    sealed class FringeField
    {
        // Shadow rays start this far beside the edge, as a fraction of the scene's radius.
        const double Beside = 1e-7;

        // Added to the angle of illumination: physical optics and the whole field both grow without bound where that of
        // the illumination meets that of reception, and their difference does not. Radians.
        const double AngleOffset = 1e-5;

        // A piece that is seen in part is halved so many times.
        const int MaxHalvings = 8;

        // Points of a piece where it must be seen as at its centre, in pieces from it. Other bodies may touch its ends.
        static readonly double[] s_ends = { -0.499, 0.499 };

        // Square of the sine of the angle between ray and edge below which there is no leading term.
        const double MinSquareSine = 1e-9;

        // Length of a piece at a finite range, where directions change along it.
        const double NearWavelengths = 1.0 / 16;

        readonly CrossSectionPose _pose;
        readonly ReferenceBvh _bvh;
        readonly CrossSectionReceiver[] _receivers;
        readonly CrossSectionReceiver _radar;
        readonly IReadOnlyList<Wedge> _wedges;

        public FringeField(CrossSectionPose pose, ReferenceBvh bvh, CrossSectionReceiver[] receivers,
            IReadOnlyList<Wedge> wedges)
        {
            _pose = pose;
            _bvh = bvh;
            _receivers = receivers;
            _radar = new CrossSectionReceiver(pose.Radar, pose, bvh.Centre);
            _wedges = wedges;
        }

        /// <summary>Adds the edges to the sums of each receiver and frequency.</summary>
        public void Add(ScatteringMatrix[,] sums)
        {
            double longest = (_pose.IsFar ? TubeGrid.EdgeWavelengths : NearWavelengths) * Signal.SpeedOfLight
                / _pose.Frequencies[_pose.Frequencies.Length - 1];
            foreach (var wedge in _wedges)
            {
                // Rays bounce on the inside of a corner; its edge adds nothing.
                if (wedge.IsConcave)
                    continue;
                int pieces = (int)Math.Ceiling(wedge.Length / longest);
                double3 edge = (wedge.B - wedge.A) / pieces;
                for (int i = 0; i < pieces; i++)
                    AddSeen(wedge, edge, wedge.A + (i + 0.5) * edge - _bvh.Centre, MaxHalvings, sums);
            }
        }

        // Adds a piece, or its halves if only a part is seen.
        void AddSeen(Wedge wedge, double3 edge, double3 centre, int halvings, ScatteringMatrix[,] sums)
        {
            if (halvings > 0 && s_ends.Any(end => !IsSeenAlike(wedge, centre, centre + end * edge)))
            {
                AddSeen(wedge, edge / 2, centre - edge / 4, halvings - 1, sums);
                AddSeen(wedge, edge / 2, centre + edge / 4, halvings - 1, sums);
            }
            else
                AddPiece(wedge, edge, centre, sums);
        }

        bool IsSeenAlike(Wedge wedge, double3 a, double3 b) => _receivers.Append(_radar).All(receiver =>
            Sees(Outside(wedge, a), receiver, wedge, out _, out _)
                == Sees(Outside(wedge, b), receiver, wedge, out _, out _));

        // Where shadow rays from a point on an edge start.
        double3 Outside(Wedge wedge, double3 onEdge) => onEdge + Beside * _bvh.Radius
            * (Math.Cos(wedge.OuterAngle / 2) * wedge.First.Into
                + Math.Sin(wedge.OuterAngle / 2) * wedge.First.Normal);

        void AddPiece(Wedge wedge, double3 edge, double3 centre, ScatteringMatrix[,] sums)
        {
            double3 start = Outside(wedge, centre);
            if (!Sees(start, _radar, wedge, out double3 toRadar, out double arrives))
                return;
            for (int r = 0; r < _receivers.Length; r++)
            {
                if (!Sees(start, _receivers[r], wedge, out double3 toReceiver, out double leaves))
                    continue;
                double3 t = math.normalize(edge);
                double square = 1 - math.dot(toRadar, t) * math.dot(toRadar, t);
                if (square < MinSquareSine)
                    continue;
                var (f, g) = Coefficients(wedge.OuterAngle, arrives + AngleOffset, leaves);
                var dyad = Dyad(toRadar, toReceiver, t, _receivers[r], f, g);
                double amplitude = _radar.Amplitude(centre) * _receivers[r].Amplitude(centre) * math.length(edge);
                double length = _radar.Length(centre) + _receivers[r].Length(centre);
                for (int i = 0; i < _pose.Frequencies.Length; i++)
                {
                    double k = ReferenceCrossSection.Wavenumber(_pose.Frequencies[i]);
                    double sinc = TubeField.Sinc(k * math.dot(toReceiver + toRadar, edge) / 2);
                    // -(j k / sqrt(4 pi)) 2 j / (k sin^2) = 1 / (sqrt(pi) sin^2).
                    sums[r, i] += Complex.FromPolarCoordinates(
                        amplitude * sinc / (Math.Sqrt(math.PI_DBL) * square), -k * length) * dyad;
                }
            }
        }

        // Whether a point beside the edge sees the radar or a receiver, in which direction, and at which angle from the
        // first face.
        bool Sees(double3 from, CrossSectionReceiver receiver, Wedge wedge, out double3 direction,
            out double angle)
        {
            direction = receiver.From(from, out double reach);
            angle = Math.Atan2(math.dot(direction, wedge.First.Normal), math.dot(direction, wedge.First.Into));
            if (angle < 0)
                angle += 2 * math.PI_DBL;
            return angle <= wedge.OuterAngle && !_bvh.AnyHit(from, direction, reach);
        }

        ScatteringMatrix Dyad(double3 toRadar, double3 toReceiver, double3 t, CrossSectionReceiver receiver, double f,
            double g)
        {
            var (sentV, sentH) = CrossSectionReceiver.Across(_pose.Radar, toRadar);
            var (receivedV, receivedH) = receiver.Polarisations(toReceiver);
            double3 across = math.cross(toReceiver, t);
            double Of(double3 p, double3 q) => f * math.dot(q, t) * math.dot(p, t)
                - g * math.dot(math.cross(-toRadar, q), t) * math.dot(p, across);
            return new ScatteringMatrix
            {
                VV = Of(receivedV, sentV), HV = Of(receivedH, sentV),
                VH = Of(receivedV, sentH), HH = Of(receivedH, sentH)
            };
        }

        // Coefficients of the edge's field less those of physical optics, for E and H along the edge.
        static (double f, double g) Coefficients(double outerAngle, double arrives, double leaves)
        {
            double n = outerAngle / math.PI_DBL, cos = Math.Cos(math.PI_DBL / n);
            double factor = Math.Sin(math.PI_DBL / n) / n;
            double minus = factor / (cos - Math.Cos((leaves - arrives) / n));
            double plus = factor / (cos - Math.Cos((leaves + arrives) / n));
            double f = minus - plus, g = minus + plus;
            if (arrives < math.PI_DBL)
                SubtractFace(arrives, leaves, ref f, ref g);
            if (outerAngle - arrives < math.PI_DBL)
                SubtractFace(outerAngle - arrives, outerAngle - leaves, ref f, ref g);
            return (f, g);
        }

        static void SubtractFace(double arrives, double leaves, ref double f, ref double g)
        {
            double sum = Math.Cos(leaves) + Math.Cos(arrives);
            f -= Math.Sin(arrives) / sum;
            g += Math.Sin(leaves) / sum;
        }
    }
}
