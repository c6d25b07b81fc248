using System.Threading.Tasks;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The independent tracer that tests and benchmarks compare the kernel with: double precision on the CPU, the same triangles, camera and receiver.
    /// Slow on purpose: nothing is skipped and nothing is approximated.
    /// </summary>
    public sealed class Judge
    {
        readonly RadarSettings _settings;
        readonly RadarView _view;
        readonly JudgeTree _tree;

        /// <param name="scene">Triangles in the coordinates of the view.</param>
        public Judge(TriangleMesh scene, in RadarSettings settings, in RadarView view)
        {
            _settings = settings;
            _view = view;
            _tree = new JudgeTree(scene, view.Position);
        }

        /// <summary>Every ray, in order of its pixel; rows are shared among processors.</summary>
        public JudgeRay[] TraceAll()
        {
            int across = _settings.RaysAcross;
            var rays = new JudgeRay[_settings.RayCount];
            Parallel.For(0, _settings.RaysDown, y =>
            {
                for (int x = 0; x < across; x++)
                    rays[y * across + x] = Trace(x, y);
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
            while (true)
            {
                int hit = _tree.FindNearest(ray.LastHit, direction, ray.LastTriangle, out double distance);
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
                ray.LastTriangle = hit;
                ray.Bounces++;
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
