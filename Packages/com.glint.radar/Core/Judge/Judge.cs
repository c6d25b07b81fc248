using System;
using System.Threading;
using System.Threading.Tasks;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The independent tracer that tests and benchmarks compare the kernel with: double precision on the CPU, the same float32 vertices, double transforms, camera and receiver.
    /// Slow on purpose: nothing is skipped and nothing is approximated.
    /// </summary>
    public sealed class Judge
    {
        readonly RadarSettings _settings;
        readonly RadarView _view;
        readonly JudgeTree _tree;

        /// <param name="scene">Places in the coordinates of the view.</param>
        public Judge(RadarScene scene, in RadarSettings settings, in RadarView view)
        {
            _settings = settings;
            _view = view;
            _tree = new JudgeTree(scene, view.Position);
        }

        /// <summary>Every ray of the region (of the whole picture when none is set), row by row from its left and bottom edge; rows are shared among processors.</summary>
        /// <param name="progress">Told how much is done, 0 to 1, from any thread; may be null.</param>
        /// <param name="cancel">Ends the work.</param>
        /// <exception cref="OperationCanceledException">It was cancelled.</exception>
        public JudgeRay[] TraceAll(IProgress<double> progress = null, CancellationToken cancel = default)
        {
            var region = _settings.Region;
            if (region.IsWhole)
                region = new RayRegion { Width = _settings.RaysAcross, Height = _settings.RaysDown };
            var rays = new JudgeRay[_settings.RaysEmitted];
            int rowsDone = 0;
            Parallel.For(0, region.Height, new ParallelOptions { CancellationToken = cancel }, row =>
            {
                for (int i = 0; i < region.Width; i++)
                    rays[(long)row * region.Width + i] = Trace(region.Left + i, region.Bottom + row);
                progress?.Report(Interlocked.Increment(ref rowsDone) / (double)region.Height);
            });
            return rays;
        }

        /// <summary>The sums over rays as <see cref="TraceAll"/> gives them; carries no rays and no timings.</summary>
        public RadarResult Sum(JudgeRay[] rays)
        {
            var result = new RadarResult { RaysEmitted = rays.Length };
            foreach (var ray in rays)
            {
                result.RaysHit += ray.Bounces > 0 ? 1 : 0;
                result.Bounces += ray.Bounces;
                result.PathLengthMeters += ray.LengthToLastHit;
                if (!ray.Received)
                    continue;
                double phase = Signal.Phase(ray.PathLength, _settings.Wavelength);
                result.AddReceived(phase, math.cos(phase), math.sin(phase));
            }
            return result;
        }

        /// <summary>The ray through the middle of pixel x from the left, y from the bottom.</summary>
        public JudgeRay Trace(int x, int y)
        {
            double up = math.tan(_view.VerticalFovDegrees * math.PI_DBL / 360);
            double right = up * _settings.RaysAcross / _settings.RaysDown;
            double across = (2.0 * x + 1) / _settings.RaysAcross - 1;
            double along = (2.0 * y + 1) / _settings.RaysDown - 1;
            double3 direction = math.normalize(_view.Forward + across * right * _view.Right + along * up * _view.Up);

            var ray = new JudgeRay { LastHit = _view.Position, LastTriangle = -1 };
            int leaving = -1;
            while (true)
            {
                int hit = _tree.FindNearest(ray.LastHit, direction, leaving, out double distance);
                if (ray.Bounces > 0 && CrossesReceiver(ray.LastHit, direction, out double toReceiver) && toReceiver < distance)
                {
                    ray.Received = true;
                    ray.PathLength = ray.LengthToLastHit + toReceiver;
                    return ray;
                }
                if (hit < 0 || ray.Bounces == _settings.MaxBounces)
                    return ray;
                ray.LengthToLastHit += distance;
                ray.LastHit += distance * direction;
                ray.LastTriangle = _tree.Number(hit);
                ray.Bounces++;
                leaving = hit;
                double3 normal = _tree.Normal(hit);
                direction = math.normalize(direction - 2 * math.dot(direction, normal) * normal);
            }
        }

        bool CrossesReceiver(double3 origin, double3 direction, out double distance)
        {
            double closing = -math.dot(direction, _view.ReceiverForward);
            distance = math.dot(origin - _view.ReceiverCentre, _view.ReceiverForward) / closing;
            if (!(closing > 0 && distance > 0))
                return false;
            double3 place = origin + distance * direction - _view.ReceiverCentre;
            return math.abs(math.dot(place, _view.ReceiverRight)) <= _view.ReceiverSize.x / 2
                && math.abs(math.dot(place, _view.ReceiverUp)) <= _view.ReceiverSize.y / 2;
        }
    }
}
