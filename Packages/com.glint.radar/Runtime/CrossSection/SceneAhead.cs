using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// What takes longest to find in a scene, begun on other threads before a tracer asks for it: BVHs and wedges.
    /// </summary>
    sealed class SceneAhead
    {
        readonly Dictionary<TriangleMesh, Task<MeshBvh>> _bvhs;
        readonly Task<WedgeSet> _wedges;

        /// <param name="patches">Of each instance; may take long.</param>
        /// <param name="wedges">Of the scene; may take long. Null: they are not needed.</param>
        public SceneAhead(RadarScene scene, Func<SurfacePatches[]> patches, Func<WedgeSet> wedges)
        {
            Patches = patches;
            _bvhs = scene.Instances.Select(instance => instance.Mesh).Distinct()
                .ToDictionary(mesh => mesh, mesh => Task.Run(() => MeshBvh.Build(mesh, BvhLayout.Binary)));
            if (wedges != null)
                _wedges = Task.Run(wedges);
        }

        /// <summary>The patches of each instance.</summary>
        public Func<SurfacePatches[]> Patches { get; }

        /// <summary>The BVH of a mesh; null if it was not begun.</summary>
        /// <exception cref="OperationCanceledException">The wait was cancelled; the work goes on.</exception>
        public MeshBvh BvhOf(TriangleMesh mesh, CancellationToken cancel) =>
            _bvhs.TryGetValue(mesh, out var bvh) ? ResultOf(bvh, cancel) : null;

        /// <summary>The wedges of a scene with these patches; null if they were not begun.</summary>
        /// <exception cref="OperationCanceledException">The wait was cancelled; the work goes on.</exception>
        public WedgeSet WedgesOf(IReadOnlyList<SurfacePatches> patches, CancellationToken cancel) =>
            _wedges != null && patches.SequenceEqual(Patches()) ? ResultOf(_wedges, cancel) : null;

        static T ResultOf<T>(Task<T> task, CancellationToken cancel)
        {
            Task.WaitAny(new Task[] { task }, cancel);
            return task.GetAwaiter().GetResult();
        }
    }
}
