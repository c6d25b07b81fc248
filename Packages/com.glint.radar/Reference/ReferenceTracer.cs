using System;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// An independent tracer for comparison with the kernel: double precision on the CPU, with the same float32
    /// vertices, double transforms, camera and receiver. It skips and approximates nothing.
    /// </summary>
    public sealed class ReferenceTracer
    {
        // An odd multiplier without pattern.
        const long PathHashFactor = 6364136223846793005;

        readonly RadarSettings _settings;
        readonly RadarView _view;
        readonly ReferenceBvh _bvh;
        readonly double3 _receiver; // its centre, in the BVH's coordinates
        // half size of the picture at distance 1 in perspective, of the aperture for parallel rays
        readonly double _halfWidth, _halfHeight;

        /// <summary>A tracer of a pose.</summary>
        public ReferenceTracer(in RadarPose pose)
        {
            var (settings, view) = (pose.Settings, pose.View);
            _settings = settings;
            _view = view;
            _bvh = new ReferenceBvh(pose.Scene);
            _receiver = view.ReceiverCentre - _bvh.Centre;
            _halfHeight =
                view.IsParallel ? view.ApertureHeight / 2 : math.tan(view.VerticalFovDegrees * math.PI_DBL / 360);
            _halfWidth = _halfHeight * settings.RaysAcross / settings.RaysDown;
        }

        /// <summary>Half the diagonal of the box around all triangles, metres.</summary>
        public double SceneRadius => _bvh.Radius;

        /// <summary>
        /// Distance between the rays of neighbouring pixels after <paramref name="length"/> metres, metres.
        /// </summary>
        public double RaySpacing(double length) =>
            2 * _halfHeight / _settings.RaysDown * (_view.IsParallel ? 1 : length);

        /// <summary>
        /// Traces every ray of the region, or of the whole picture, row by row from the left and bottom edge.
        /// </summary>
        /// <param name="progress">Receives the fraction done, 0 to 1, from any thread; may be null.</param>
        /// <param name="cancel">Cancels the work.</param>
        /// <exception cref="OperationCanceledException">It was cancelled.</exception>
        public ReferenceRay[] TraceAll(IProgress<double> progress = null, CancellationToken cancel = default)
        {
            var region = _settings.Region;
            if (region.IsWhole)
                region = new RayRegion { Width = _settings.RaysAcross, Height = _settings.RaysDown };
            var rays = new ReferenceRay[_settings.RaysEmitted];
            ForAll(region.Height, row =>
            {
                for (int i = 0; i < region.Width; i++)
                    rays[(long)row * region.Width + i] = Trace(region.Left + i, region.Bottom + row);
            }, progress, cancel);
            return rays;
        }

        /// <summary>Traces the rays of the kernel's pixels.</summary>
        /// <exception cref="OperationCanceledException">It was cancelled.</exception>
        public ReferenceRay[] TraceSame(RayData[] rays, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            const int Together = 256;
            var same = new ReferenceRay[rays.Length];
            ForAll((rays.Length + Together - 1) / Together, part =>
            {
                for (int i = part * Together; i < math.min(rays.Length, (part + 1) * Together); i++)
                    same[i] = Trace(ColumnOf(rays[i]), RowOf(rays[i]));
            }, progress, cancel);
            return same;
        }

        /// <summary>Sums over rays of <see cref="TraceAll"/>, without rays and timings.</summary>
        public RadarResult Sum(ReferenceRay[] rays)
        {
            var sums = new RadarSums { RaysEmitted = rays.Length, RaysOfPicture = _settings.RayCount };
            if (_view.IsParallel)
                sums.RayArea = RaySpacing(0) * RaySpacing(0);
            foreach (var ray in rays)
            {
                sums.RaysHit += ray.Bounces > 0 ? 1 : 0;
                sums.Bounces += ray.Bounces;
                sums.PathLengthMeters += ray.LengthToLastHit;
                if (!ray.Received)
                    continue;
                double phase = Signal.Phase(ray.PathLength, _settings.Wavelength);
                sums.AddReceived(phase, math.cos(phase), math.sin(phase));
            }
            return new RadarResult(sums);
        }

        /// <summary>Traces the ray through any point of the picture.</summary>
        /// <param name="x">Pixels from the left; whole numbers are the centres of pixels, 0 that of the first.</param>
        /// <param name="y">Pixels from the bottom.</param>
        public ReferenceRay Trace(double x, double y)
        {
            double3 aside = ((2 * x + 1) / _settings.RaysAcross - 1) * _halfWidth * _view.Right
                + ((2 * y + 1) / _settings.RaysDown - 1) * _halfHeight * _view.Up;
            double3 start = _view.IsParallel ? _view.Position + aside : _view.Position;
            double3 direction = math.normalize(_view.IsParallel ? _view.Forward : _view.Forward + aside);

            // Small coordinates keep rounding small: positions are relative to the scene's centre, and a distant ray
            // starts just before the scene.
            double3 position = start - _bvh.Centre;
            double length = math.max(0, -math.dot(position, direction) - 2 * _bvh.Radius);
            position += length * direction;

            var path = new Path
            {
                Position = position, Direction = direction, Length = length,
                Ray = new ReferenceRay { LastHit = start, LastTriangle = -1, LastObject = -1, LastSurface = -1 }
            };
            while (true)
            {
                int hit = _bvh.ClosestHit(path.Position, path.Direction, out double distance);
                if (!Observe(ref path, hit, distance))
                    return path.Ray;
                MoveTo(ref path, hit, distance);
                Scatter(ref path, hit);
            }
        }

        // What is recorded: whether the ray crosses the receiver before it hits anything. False if the path ends.
        bool Observe(ref Path path, int hit, double distance)
        {
            path.Ray.Direction = path.Direction;
            if (path.Ray.Bounces > 0 && CrossesReceiver(path.Position, path.Direction, out double toReceiver)
                && toReceiver < distance)
            {
                path.Ray.Received = true;
                path.Ray.PathLength = path.Length + toReceiver;
                return false;
            }
            return hit >= 0 && path.Ray.Bounces < _settings.MaxBounces;
        }

        void MoveTo(ref Path path, int hit, double distance)
        {
            path.Length += distance;
            path.Position += distance * path.Direction;
            ref var ray = ref path.Ray;
            ray.Bounces++;
            if (ray.Bounces == 1)
                ray.LengthToFirstHit = path.Length;
            ray.LengthToLastHit = path.Length;
            ray.LastHit = _bvh.Centre + path.Position;
            ray.LastTriangle = _bvh.Number(hit);
            var range = _bvh.RangeOf(hit);
            (ray.LastObject, ray.LastSurface) = (range.Object, range.Surface);
            ray.PathHash = unchecked(PathHashFactor * ray.PathHash + ray.LastTriangle + 1);
        }

        // Every surface is a mirror.
        void Scatter(ref Path path, int hit)
        {
            double3 normal = _bvh.Normal(hit);
            path.Direction = math.normalize(path.Direction - 2 * math.dot(path.Direction, normal) * normal);
        }

        internal int ColumnOf(in RayData ray) => (int)(ray.Pixel % (uint)_settings.RaysAcross);

        internal int RowOf(in RayData ray) => (int)(ray.Pixel / (uint)_settings.RaysAcross);

        // Parallel loop.
        static void ForAll(int parts, Action<int> work, IProgress<double> progress, CancellationToken cancel)
        {
            int done = 0;
            Parallel.For(0, parts, new ParallelOptions { CancellationToken = cancel }, part =>
            {
                work(part);
                progress?.Report(Interlocked.Increment(ref done) / (double)parts);
            });
        }

        bool CrossesReceiver(double3 origin, double3 direction, out double distance)
        {
            double closing = -math.dot(direction, _view.ReceiverForward);
            distance = math.dot(origin - _receiver, _view.ReceiverForward) / closing;
            if (!(closing > 0 && distance > 0))
                return false;
            double3 position = origin + distance * direction - _receiver;
            return math.abs(math.dot(position, _view.ReceiverRight)) <= _view.ReceiverSize.x / 2
                && math.abs(math.dot(position, _view.ReceiverUp)) <= _view.ReceiverSize.y / 2;
        }

        // A ray on its way. Places are from the middle of the BVH; the length is from the radar, metres.
        struct Path
        {
            public ReferenceRay Ray;
            public double3 Position, Direction;
            public double Length;
        }
    }
}
