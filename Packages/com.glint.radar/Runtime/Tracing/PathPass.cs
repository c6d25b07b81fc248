using System;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>Follows single rays once more, in double-float arithmetic, and notes where each is reflected.</summary>
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

        /// <summary>The ways of the rays of some pixels, in their order.</summary>
        /// <param name="objects">Knows what is hit; null: nobody does.</param>
        public RayPath[] Follow(in RadarPose pose, RayGrid grid, uint[] pixels,
            IHitObjects objects, IProgress<double> progress, CancellationToken cancel)
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
                        new ArraySegment<HitData>(hits, i * settings.MaxBounces, (int)listed[i].x), objects);
                progress?.Report((double)(first + count) / pixels.Length);
            }
            return paths;
        }

        public void Dispose()
        {
            _listed.Dispose();
            _hits.Dispose();
        }

        // End: bounces, and the bits of the length from the last one to the receiver.
        RayPath PathOf(in RadarSettings settings, in RadarView view, RayGrid grid, uint pixel, uint2 end,
            ArraySegment<HitData> hits, IHitObjects objects)
        {
            var path =
                new RayPath { Pixel = pixel, Start = view.StartOf(settings, pixel), Hits = new PathHit[hits.Count] };
            for (int i = 0; i < hits.Count; i++)
            {
                var hit = hits.Array[hits.Offset + i];
                path.Hits[i] = new PathHit
                {
                    Position = grid.SceneCentre + hit.Position, Direction = hit.Direction, Object = PathHit.NoObject
                };
                if (objects == null)
                    continue;
                _scene.TriangleOf(hit, out int instance, out var a, out var b, out var c);
                path.Hits[i].Object = objects.ObjectOf(instance, a, b, c);
            }
            float wayBack = math.asfloat(end.y);
            if (wayBack > 0)
                path.End = path.Hits[hits.Count - 1].Position + wayBack * path.Hits[hits.Count - 1].Direction;
            return path;
        }
    }
}
