using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The flat patches of a scene, in which the radar may see others as in mirrors, and the outlines of all patches in pieces, on
    /// the device.
    /// </summary>
    sealed class MirrorBuffers : IDisposable
    {
        // Pairs of a mirror and a piece of an outline that are tried for each pose: the largest mirrors are taken.
        const int MaxPairs = 1 << 23;

        // Base cells that a piece is long: its middle tells whether it is seen.
        const double PieceCells = 4;

        // Pieces of outlines beside one for each: 128 MB. In a scene with more they are longer.
        const int MaxPieces = 1 << 21;

        IReadOnlyList<SurfacePatches> _patches;
        double _cell;

        /// <summary>MIRROR_ROWS a mirror: Shaders/TubeImages.hlsl, where they are explained.</summary>
        public DeviceBuffer<float4> Mirrors { get; } = new DeviceBuffer<float4>("flat patches");

        public int MirrorCount { get; private set; }

        /// <summary>OUTLINE_ROWS a piece.</summary>
        public DeviceBuffer<float4> Pieces { get; } = new DeviceBuffer<float4>("pieces of outlines");

        public int PieceCount { get; private set; }

        /// <summary>Uploads those of another scene, or for other cells.</summary>
        /// <param name="patches">Of each instance: another list is another scene.</param>
        /// <param name="centre">Origin of the kernels' coordinates.</param>
        /// <param name="cell">Side of a base cell, metres: in a narrower mirror none lies whole.</param>
        public void Set(RadarScene scene, IReadOnlyList<SurfacePatches> patches, double3 centre, double cell)
        {
            if (ReferenceEquals(patches, _patches) && cell == _cell)
                return;
            var mirrors = new List<PatchRectangle>();
            var sides = new List<(double3 Start, double3 End, double3 Third)>();
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var placed = new PlacedPatches(scene.Instances[i], patches[i]);
                double3 At(int corner) => placed.Point(corner) - centre;
                mirrors.AddRange(PatchRectangle.Of(patches[i], At).Where(mirror => mirror.Width >= cell));
                sides.AddRange(patches[i].Outlines.Select(side =>
                    (At(side), At(WeldedMesh.EndOf(side)), At(WeldedMesh.Opposite(side)))));
            }
            double length = Math.Max(PieceCells * cell, sides.Sum(side => math.distance(side.Start, side.End)) / MaxPieces);
            var rows = sides.SelectMany(side => PiecesOf(side.Start, side.End, side.Third, length)).ToArray();
            PieceCount = rows.Length / TubeKernels.OutlineRows;
            Pieces.Upload(rows);
            MirrorCount = Math.Min(mirrors.Count, MaxPairs / Math.Max(1, PieceCount));
            Mirrors.Upload(mirrors.OrderByDescending(mirror => mirror.Area).Take(MirrorCount)
                .SelectMany(mirror => mirror.Rows()).ToArray());
            (_patches, _cell) = (patches, cell);
        }

        public void Dispose()
        {
            Mirrors.Dispose();
            Pieces.Dispose();
            _patches = null;
        }

        static IEnumerable<float4> PiecesOf(double3 start, double3 end, double3 third, double maxLength)
        {
            int count = (int)Math.Max(1, Math.Ceiling(math.distance(start, end) / maxLength));
            for (int i = 0; i < count; i++)
            {
                yield return TubePose.RowOf(math.lerp(start, end, (double)i / count));
                yield return TubePose.RowOf(math.lerp(start, end, (i + 1.0) / count));
                yield return TubePose.RowOf(third);
            }
        }
    }
}
