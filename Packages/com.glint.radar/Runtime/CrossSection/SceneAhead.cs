using System;
using System.Collections.Generic;
using System.Linq;
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
        public MeshBvh BvhOf(TriangleMesh mesh) =>
            _bvhs.TryGetValue(mesh, out var bvh) ? bvh.GetAwaiter().GetResult() : null;

        /// <summary>The wedges of a scene with these patches; null if they were not begun.</summary>
        public WedgeSet WedgesOf(IReadOnlyList<SurfacePatches> patches) =>
            _wedges != null && patches.SequenceEqual(Patches()) ? _wedges.GetAwaiter().GetResult() : null;
    }
}
