using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Predicts the density of returned rays before a trace, for a large mirror at a point that faces the radar.
    /// A convex surface returns neighbours farther apart than this mirror, a concave one nearer.
    /// </summary>
    public struct SamplingForecast
    {
        // Sample points on the receiver, across and down.
        const int Points = 16;

        static readonly double2[] s_neighbours =
        {
            new double2(1, 0), new double2(-1, 1), new double2(0, 1), new double2(1, 1)
        };

        /// <summary>Distance between neighbouring rays at the mirror, across and down, metres.</summary>
        public double RaySpacing;

        /// <summary>Number of rays received.</summary>
        public double RaysReceived;

        /// <summary>
        /// Maximum path difference between received rays of neighbouring pixels, wavelengths:
        /// <see cref="RadarResult.LargestPathStep"/>.
        /// </summary>
        public double LargestPathStep;

        /// <summary>
        /// Whether neighbouring paths differ so much that even a mirror's return would be
        /// <see cref="RadarResult.Undersampled"/>.
        /// </summary>
        public bool IsTooCoarse;

        /// <summary>
        /// Whether too few rays return: <see cref="RadarResult.Undersampled"/> for that reason.
        /// </summary>
        public bool IsTooFew => RaysReceived < SamplingEstimate.FewestRays;

        /// <summary>
        /// The forecast; null if the point is not in front of the radar, or the receiver does not face it.
        /// </summary>
        /// <param name="centre">Position of the mirror.</param>
        public static SamplingForecast? Of(in RadarSettings settings, in RadarView view, double3 centre)
        {
            double depth = math.dot(centre - view.Position, view.Forward);
            if (!(depth > 0))
                return null;
            var mirror = new Mirror(settings, view, centre);
            var forecast = new SamplingForecast { RaySpacing = mirror.Step * (view.IsParallel ? 1 : depth) };
            int lit = 0, pairs = 0, apart = 0;
            for (int i = 0; i < Points * Points; i++)
            {
                double2 position = (new double2(i % Points + 0.5, i / Points + 0.5) / Points - 0.5) * view.ReceiverSize;
                double3 point = view.ReceiverCentre + position.x * view.ReceiverRight + position.y * view.ReceiverUp;
                if (!mirror.Find(point, out double2 ray) || !mirror.Meet(ray, out double3 here, out double length))
                    continue;
                lit++;
                foreach (double2 neighbour in s_neighbours)
                    if (mirror.Meet(ray + neighbour * mirror.Step, out double3 there, out double other)
                        && mirror.IsReceived(there))
                    {
                        double step = math.abs(other - length) / settings.Wavelength;
                        forecast.LargestPathStep = math.max(forecast.LargestPathStep, step);
                        pairs++;
                        apart += step >= SamplingEstimate.StepApart ? 1 : 0;
                    }
                if (mirror.Meet(ray + new double2(mirror.Step, 0), out double3 right, out _)
                    && mirror.Meet(ray + new double2(0, mirror.Step), out double3 above, out _))
                    forecast.RaysReceived += view.ReceiverSize.x * view.ReceiverSize.y / (Points * Points)
                        / math.length(math.cross(right - here, above - here));
            }
            forecast.IsTooCoarse = apart > SamplingEstimate.MaxApart * pairs;
            return lit > 0 ? forecast : (SamplingForecast?)null;
        }

        // Rays returned by the mirror. A ray is given by its position in the picture, in the units of
        // RadarView.HalfSize.
        readonly struct Mirror
        {
            readonly RadarView _view;
            readonly double2 _half;
            readonly double3 _normal, _centre;

            public Mirror(in RadarSettings settings, in RadarView view, double3 centre)
            {
                _view = view;
                _half = view.HalfSize(settings);
                _centre = centre;
                _normal = view.IsParallel ? view.Forward : math.normalize(centre - view.Position);
                Step = 2 * _half.y / settings.RaysDown;
            }

            /// <summary>Distance from ray to ray in the picture.</summary>
            public double Step { get; }

            /// <summary>The ray that returns to a point; false if it is not in the picture.</summary>
            public bool Find(double3 point, out double2 ray)
            {
                double3 seen = point - _view.Position;
                if (!_view.IsParallel)
                {
                    // Direction of the mirror image of the point.
                    seen = Mirrored(point - _centre) + _centre - _view.Position;
                    seen /= math.dot(seen, _view.Forward);
                }
                ray = new double2(math.dot(seen, _view.Right), math.dot(seen, _view.Up));
                return math.all(math.abs(ray) <= _half);
            }

            /// <summary>
            /// Point at which a ray returns to the receiver's plane, and its path length from the mirror image of the
            /// radar; false if it does not return.
            /// </summary>
            public bool Meet(double2 ray, out double3 point, out double length)
            {
                double3 aside = ray.x * _view.Right + ray.y * _view.Up;
                double3 direction = Mirrored(_view.IsParallel ? _view.Forward : _view.Forward + aside);
                double3 start = Mirrored(_view.Position + (_view.IsParallel ? aside : 0) - _centre) + _centre;
                double against = -math.dot(direction, _view.ReceiverForward);
                double way = math.dot(start - _view.ReceiverCentre, _view.ReceiverForward) / against;
                (point, length) = (start + way * direction, way * math.length(direction));
                return against > 0 && way > 0;
            }

            /// <summary>Whether a point of the receiver's plane is on the receiver.</summary>
            public bool IsReceived(double3 point)
            {
                double3 aside = point - _view.ReceiverCentre;
                return math.all(math.abs(new double2(math.dot(aside, _view.ReceiverRight),
                    math.dot(aside, _view.ReceiverUp))) <= _view.ReceiverSize / 2);
            }

            double3 Mirrored(double3 v) => v - 2 * math.dot(v, _normal) * _normal;
        }
    }
}
