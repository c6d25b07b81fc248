using System;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>Traces single rays in double-float arithmetic and records their reflections.</summary>
    sealed class PathPass : IDisposable
    {
        readonly TraceKernel _kernel;
        readonly DeviceScene _scene;
        readonly DeviceBuffer<uint2> _listed = new DeviceBuffer<uint2>("rays to follow");
        readonly DeviceBuffer<HitData> _hits = new DeviceBuffer<HitData>("reflections");

        public PathPass(TraceKernel kernel, DeviceScene scene)
        {
            _kernel = kernel;
            _scene = scene;
        }

        /// <summary>The paths of the rays of some pixels, in their order.</summary>
        public RayPath[] Follow(in RadarPose pose, RayGrid grid, uint[] pixels, IProgress<double> progress,
            CancellationToken cancel)
        {
            var settings = pose.Settings;
            var paths = new RayPath[pixels.Length];
            int max = DispatchPlan.PathRays(settings), room = Math.Min(max, pixels.Length);
            var listed = new uint2[room];
            var hits = new HitData[room * settings.MaxBounces];
            _hits.Reserve(hits.Length);
            for (int first = 0; first < pixels.Length; first += max)
            {
                cancel.ThrowIfCancellationRequested();
                int count = Math.Min(max, pixels.Length - first);
                for (int i = 0; i < count; i++)
                    listed[i] = new uint2(pixels[first + i], 0);
                _listed.Upload(listed);
                _kernel.DispatchPaths(_scene, count, _listed, _hits);
                _listed.ReadBack(listed, count);
                _hits.ReadBack(hits, count * settings.MaxBounces);
                for (int i = 0; i < count; i++)
                    paths[first + i] = PathOf(settings, pose.View, grid, pixels[first + i], listed[i],
                        hits, i * settings.MaxBounces);
                progress?.Report((double)(first + count) / pixels.Length);
            }
            return paths;
        }

        public void Dispose()
        {
            _listed.Dispose();
            _hits.Dispose();
        }

        // End: bounces, with RAY_RECEIVED; then the bits of the distance from the last hit to the receiver.
        static RayPath PathOf(in RadarSettings settings, in RadarView view, RayGrid grid, uint pixel, uint2 end,
            HitData[] hits, int firstHit)
        {
            var path = new RayPath
            {
                Pixel = pixel, Start = view.StartOf(settings, pixel),
                Hits = new PathHit[end.x & ~RayData.Received]
            };
            for (int i = 0; i < path.Hits.Length; i++)
            {
                var hit = hits[firstHit + i];
                path.Hits[i] = new PathHit
                {
                    Position = grid.SceneCentre + hit.Position, Direction = hit.Direction,
                    Instance = (int)hit.Instance, Triangle = (int)hit.Triangle,
                    Object = hit.Object, Surface = (int)hit.Surface
                };
            }
            if ((end.x & RayData.Received) == 0)
                return path;
            var last = path.Hits[path.Hits.Length - 1];
            path.End = last.Position + math.asfloat(end.y) * last.Direction;
            return path;
        }
    }
}
