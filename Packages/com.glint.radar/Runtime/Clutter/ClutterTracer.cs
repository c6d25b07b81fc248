using System;
using System.Threading;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Sums the diffuse echo of a scene's seas: one shadow ray and one contribution a facet, whatever else is traced.
    /// </summary>
    public sealed class ClutterTracer : IDisposable
    {
        readonly string _owner;
        readonly SeaKernel _kernel;
        readonly DeviceScene _scene;

        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">
        /// <see cref="CrossSectionTracer.Check"/> refuses device or shader.
        /// </exception>
        public ClutterTracer(ComputeShader shader, string owner = nameof(ClutterTracer))
        {
            CrossSectionTracer.Check(shader, owner);
            _owner = owner;
            _kernel = new SeaKernel(shader, owner);
            _scene = new DeviceScene(BvhLayout.Binary, owner, long.MaxValue);
        }

        internal long MinGroups { set => _kernel.MinGroups = value; }

        /// <summary>Work of all sums: dispatches, round trips and bytes.</summary>
        public TraceStatistics Statistics => _kernel.Statistics;

        /// <summary>
        /// Sums the echo of all seas of a scene with clutter, at one frequency of a pose, at the level of their waves.
        /// </summary>
        /// <param name="pose">The receiver is at the radar; others are not read.</param>
        /// <param name="frequency">Hertz.</param>
        /// <param name="grid">Cells that are summed apart; null: one cell that holds everything.</param>
        /// <param name="progress">Receives the fraction done, 0 to 1.</param>
        /// <param name="cancel">Cancels while BVHs are built, or after the current slice.</param>
        /// <exception cref="GlintException">
        /// The memory does not suffice for the scene, or a sea has no echo at the frequency.
        /// </exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public ClutterEcho[] Trace(CrossSectionPose pose, double frequency, ClutterGrid grid = null,
            IProgress<double> progress = null, CancellationToken cancel = default)
        {
            _scene.Set(pose.Scene, Statistics, (mesh, layout) => MeshBvh.Build(mesh, layout, cancel));
            _scene.RequireOnePage(_owner, "clutter takes");
            return _kernel.Sum(_scene, pose, frequency, 0, grid ?? ClutterGrid.Whole, null, progress, cancel);
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _scene.Dispose();
            _kernel.Dispose();
        }
    }
}
