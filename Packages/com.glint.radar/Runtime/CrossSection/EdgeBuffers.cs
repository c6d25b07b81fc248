using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>The edges of a scene on the device, in pieces that are short enough to be lit as a whole.</summary>
    sealed class EdgeBuffers : IDisposable
    {
        IReadOnlyList<SurfacePatches> _patches;
        WedgeSet _wedges;
        double _maxLength;

        public DeviceBuffer<EdgePiece> Pieces { get; } = new DeviceBuffer<EdgePiece>("pieces of edges");

        public int Count { get; private set; }

        /// <inheritdoc cref="WedgeSet.Gap"/>
        public double Gap => _wedges.Gap;

        /// <summary>Wedges left out because a face is no perfect conductor.</summary>
        public int LeftOutCount => _wedges.CoatedCount;

        /// <summary>Finds the wedges of another scene, and uploads what has changed.</summary>
        /// <param name="patches">Of each instance: another list is another scene.</param>
        /// <param name="parts">Of the scene.</param>
        /// <param name="centre">Origin of the kernels' coordinates.</param>
        /// <param name="maxLength">Of a piece, metres.</param>
        /// <param name="ahead">What has been begun for this scene; may be null.</param>
        /// <param name="cancel">Cancels the wait for it.</param>
        public void Set(RadarScene scene, IReadOnlyList<SurfacePatches> patches, SceneParts parts, double3 centre,
            double maxLength, SceneAhead ahead, CancellationToken cancel)
        {
            bool isSame = ReferenceEquals(patches, _patches);
            if (isSame && maxLength == _maxLength)
                return;
            if (!isSame)
                _wedges = ahead?.WedgesOf(patches, cancel) ?? WedgesOf(scene, patches);
            // Rays bounce on the inside of a corner; its edge adds nothing.
            var pieces = _wedges.Wedges.Where(wedge => !wedge.IsConcave)
                .SelectMany(wedge => PiecesOf(wedge, parts, centre, maxLength)).ToArray();
            Count = pieces.Length;
            Pieces.Upload(pieces);
            (_patches, _maxLength) = (patches, maxLength);
        }

        /// <summary>The wedges of a scene, of conductors.</summary>
        public static WedgeSet WedgesOf(RadarScene scene, IReadOnlyList<SurfacePatches> patches) =>
            WedgeFinder.Find(scene, patches, surface => surface.IsConductor);

        public void Dispose()
        {
            Pieces.Dispose();
            _patches = null;
            _wedges = null;
        }

        static IEnumerable<EdgePiece> PiecesOf(Wedge wedge, SceneParts parts, double3 centre, double maxLength)
        {
            int count = (int)math.ceil(wedge.Length / maxLength);
            double3 step = (wedge.B - wedge.A) / count;
            for (int i = 0; i < count; i++)
                yield return new EdgePiece
                {
                    Centre = (float3)(wedge.A + (i + 0.5) * step - centre), Length = (float)math.length(step),
                    Along = (float3)wedge.Direction, OuterAngle = (float)wedge.OuterAngle,
                    Into = (float3)wedge.First.Into,
                    Part = (uint)parts.EdgesOf(wedge.First.Instance, wedge.First.Triangle),
                    Instance = (uint)wedge.First.Instance
                };
        }
    }
}
