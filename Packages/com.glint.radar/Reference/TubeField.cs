using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>Currents of tubes, and what they radiate.</summary>
    sealed class TubeField
    {
        // Radii of curvature times wavenumber above which currents fade towards the shadow.
        const double MinFadingRadius = 50;

        readonly CrossSectionPose _pose;
        readonly CrossSectionReceiver[] _receivers;
        readonly ReferenceSurface[][] _surfaces; // of each material, by frequency

        public TubeField(CrossSectionPose pose, CrossSectionReceiver[] receivers)
        {
            _pose = pose;
            _receivers = receivers;
            _surfaces = pose.Scene.Surfaces.Select(material =>
                Array.ConvertAll(pose.Frequencies, frequency => new ReferenceSurface(material, frequency))).ToArray();
        }

        /// <summary>Adds a tube to the sums of each receiver, frequency by frequency.</summary>
        /// <param name="size">Edge of the tube on the grid, metres.</param>
        public void Add(in TubePath path, double size, ScatteringMatrix[,] sums)
        {
            if (path.Hits.Count == 0)
                return;
            var (startV, startH) = CrossSectionReceiver.Across(_pose.Radar, path.Direction);
            for (int f = 0; f < _pose.Frequencies.Length; f++)
            {
                double k = ReferenceCrossSection.Wavenumber(_pose.Frequencies[f]);
                ComplexVector v = startV, h = startH;
                for (int i = 0; i < path.Hits.Count; i++)
                {
                    var hit = path.Hits[i];
                    var surface = _surfaces[hit.Surface][f];
                    var reflectedV = surface.Reflect(v, hit.Direction, hit.Normal);
                    var reflectedH = surface.Reflect(h, hit.Direction, hit.Normal);
                    if (_pose.OnlyBounce == 0 || _pose.OnlyBounce == i + 1)
                        for (int r = 0; r < _receivers.Length; r++)
                            if (hit.Radiates[r])
                                sums[r, f] += Radiated(hit, _receivers[r], size, k,
                                    (v, reflectedV), (h, reflectedH));
                    (v, h) = (reflectedV, reflectedH);
                }
            }
        }

        ScatteringMatrix Radiated(in TubeHit hit, CrossSectionReceiver receiver, double size, double k,
            (ComplexVector arriving, ComplexVector reflected) v, (ComplexVector arriving, ComplexVector reflected) h)
        {
            double3 toReceiver = receiver.From(hit.Position, out _);
            double3 e1 = size * hit.Pu, e2 = size * hit.Pv, w = k * (toReceiver - hit.Direction);
            double footprint = math.length(math.cross(e1, e2)) * Sinc(math.dot(w, e1) / 2) * Sinc(math.dot(w, e2) / 2);
            double amplitude = hit.Amplitude * receiver.Amplitude(hit.Position) * Fading(hit, k) * footprint;
            // Each caustic advances the phase by a quarter of a turn.
            double phase = -k * (hit.Length + receiver.Length(hit.Position)) + hit.Caustics % 4 * math.PI_DBL / 2;
            Complex factor = new Complex(0, -k / Math.Sqrt(4 * math.PI_DBL))
                * Complex.FromPolarCoordinates(amplitude, phase);

            var (receivedV, receivedH) = receiver.Polarisations(toReceiver);
            var ofV = Current(hit, toReceiver, v.arriving, v.reflected);
            var ofH = Current(hit, toReceiver, h.arriving, h.reflected);
            return factor * new ScatteringMatrix
            {
                VV = ofV.Dot(receivedV), HV = ofV.Dot(receivedH), VH = ofH.Dot(receivedV), HH = ofH.Dot(receivedH)
            };
        }

        // The electric current n x H and the magnetic E x n, as far as a receiver sees them. Without their cross
        // products: n x (d x E) = d (n.E) - E (n.d), and s x (E x n) = E (s.n) - n (s.E).
        static ComplexVector Current(in TubeHit hit, double3 toReceiver, in ComplexVector arriving,
            in ComplexVector reflected)
        {
            double3 d = hit.Direction, n = hit.Normal;
            double along = math.dot(d, n);
            double3 mirrored = d - 2 * along * n;
            var total = arriving + reflected;
            return arriving.Dot(n) * (ComplexVector)d - along * arriving
                + reflected.Dot(n) * (ComplexVector)mirrored + along * reflected
                + total.Dot(toReceiver) * (ComplexVector)n - math.dot(toReceiver, n) * total;
        }

        // Nature fades the current of a curved surface over the width of Fock's penumbra before the shadow.
        double Fading(in TubeHit hit, double k)
        {
            double radius = k / hit.Curvature;
            if (!_pose.FadesShadows || !(hit.Curvature > 0) || radius <= MinFadingRadius)
                return 1;
            double x = Math.Min(1, Math.Abs(math.dot(hit.Normal, hit.Direction)) / Math.Cbrt(2 / radius));
            return x * x * (3 - 2 * x);
        }

        internal static double Sinc(double x) => Math.Abs(x) < 1e-4 ? 1 - x * x / 6 : Math.Sin(x) / x;
    }
}
