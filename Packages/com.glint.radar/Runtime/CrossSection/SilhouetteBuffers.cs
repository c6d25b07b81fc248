using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The edges of a scene's meshes at which a receiver may see a body end, on the device, in pieces whose shadow falls on one
    /// surface.
    /// </summary>
    sealed class SilhouetteBuffers : IDisposable
    {
        // Sine of the bend of an edge, below which both triangles are in one plane: no direction has them on the same side.
        const double MinBend = 1e-4;

        // Of the pieces that long edges have beside one: 256 MB. In a scene with more they are longer.
        const int MaxPieces = 1 << 22;

        /// <summary>An edge with the other corners of its triangles, relative to the kernels' origin, metres.</summary>
        readonly struct Edge
        {
            public readonly double3 Start, End, Third, Fourth;
            public readonly bool IsOpen;

            public Edge(double3 start, double3 end, double3 third, double3 fourth, bool isOpen) =>
                (Start, End, Third, Fourth, IsOpen) = (start, end, third, fourth, isOpen);

            public double Length => math.distance(Start, End);

            // Triangles that are folded onto each other lie on the same side of their edge.
            public bool IsBent
            {
                get
                {
                    double3 along = End - Start, third = math.cross(along, Third - Start), fourth = math.cross(along, Fourth - Start);
                    return IsOpen || math.dot(third, fourth) >= 0
                        || math.length(math.cross(third, fourth)) > MinBend * math.length(third) * math.length(fourth);
                }
            }
        }

        IReadOnlyList<SurfacePatches> _patches;
        double _maxLength;

        /// <summary>SILHOUETTE_ROWS a piece: Shaders/TubeShadows.hlsl, where they are explained.</summary>
        public DeviceBuffer<float4> Pieces { get; } = new DeviceBuffer<float4>("pieces of silhouettes");

        public int Count { get; private set; }

        /// <summary>Uploads the pieces of another scene, or of another length.</summary>
        /// <param name="patches">Of each instance: another list is another scene.</param>
        /// <param name="centre">Origin of the kernels' coordinates.</param>
        /// <param name="maxLength">Of a piece, metres.</param>
        public void Set(RadarScene scene, IReadOnlyList<SurfacePatches> patches, double3 centre, double maxLength)
        {
            if (ReferenceEquals(patches, _patches) && maxLength == _maxLength)
                return;
            var edges = new List<Edge>();
            for (int i = 0; i < scene.Instances.Length; i++)
                AddEdges(scene.Instances[i], patches[i].Welded, centre, edges);
            double pieceLength = Math.Max(maxLength, edges.Sum(edge => edge.Length) / MaxPieces);
            var rows = new List<float4>();
            foreach (var edge in edges)
                AddPieces(edge, pieceLength, rows);
            Count = rows.Count / TubeKernels.SilhouetteRows;
            Pieces.Upload(rows.ToArray());
            (_patches, _maxLength) = (patches, maxLength);
        }

        public void Dispose()
        {
            Pieces.Dispose();
            _patches = null;
        }

        // Of an edge of more than two triangles each is taken as if it were alone.
        static void AddEdges(in MeshInstance instance, WeldedMesh welded, double3 centre, List<Edge> edges)
        {
            var toWorld = instance.ToWorld;
            var placed = Array.ConvertAll(welded.Mesh.Vertices, vertex => toWorld.Point(vertex) - centre);
            double3 OppositeOf(int side) => placed[welded.Corners[WeldedMesh.Opposite(side)]];
            for (int number = 0; number < welded.EdgeCount; number++)
            {
                int first = welded.SideOf(number, 0), count = welded.SideCount(number);
                double3 start = placed[welded.Corners[first]], end = placed[welded.Corners[WeldedMesh.EndOf(first)]];
                for (int i = 0; i < (count == 2 ? 1 : count); i++)
                {
                    double3 third = OppositeOf(welded.SideOf(number, i)),
                        fourth = count == 2 ? OppositeOf(welded.SideOf(number, 1)) : third;
                    var edge = new Edge(start, end, third, fourth, isOpen: count != 2);
                    if (edge.IsBent)
                        edges.Add(edge);
                }
            }
        }

        static void AddPieces(in Edge edge, double maxLength, List<float4> rows)
        {
            int count = (int)Math.Max(1, Math.Ceiling(edge.Length / maxLength));
            for (int i = 0; i < count; i++)
            {
                rows.Add(TubePose.RowOf(math.lerp(edge.Start, edge.End, (double)i / count), edge.IsOpen ? 1 : 0));
                rows.Add(TubePose.RowOf(math.lerp(edge.Start, edge.End, (i + 1.0) / count)));
                rows.Add(TubePose.RowOf(edge.Third));
                rows.Add(TubePose.RowOf(edge.Fourth));
            }
        }
    }
}
