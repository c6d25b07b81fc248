using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Finds the corners of a mesh's patches: the places where outlines turn. Between rays, only there can something
    /// lie that none of them meets.
    /// </summary>
    static class PatchCorners
    {
        // Turns below 10 degrees are not corners: an outline of many short edges is a curve.
        static readonly double s_straight = -Math.Cos(math.radians(10.0));

        /// <summary>The corners, in the mesh's frame.</summary>
        public static float3[] Of(SurfacePatches patches)
        {
            var welded = patches.Welded;
            var vertices = welded.Mesh.Vertices;
            var counts = new int[vertices.Length];
            var directions = new double3[vertices.Length];
            var turns = new bool[vertices.Length];
            void Add(int vertex, int other)
            {
                double3 direction = math.normalizesafe((double3)vertices[other] - vertices[vertex]);
                if (++counts[vertex] == 1)
                    directions[vertex] = direction;
                else
                    turns[vertex] = counts[vertex] > 2 || math.dot(direction, directions[vertex]) > s_straight;
            }
            for (int edge = 0; edge < welded.EdgeCount; edge++)
            {
                int side = welded.SideOf(edge, 0);
                if (patches.IsSmooth(side))
                    continue;
                int a = welded.Corners[side], b = welded.Corners[WeldedMesh.EndOf(side)];
                Add(a, b);
                Add(b, a);
            }
            var corners = new List<float3>();
            for (int i = 0; i < counts.Length; i++)
                if (turns[i] || counts[i] == 1)
                    corners.Add(vertices[i]);
            return corners.ToArray();
        }
    }
}
