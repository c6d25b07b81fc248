using UnityEngine;

namespace Glint.Host;

internal static class FlatMeshes
{
    /// <summary>Side 1 m; four vertices a face, in Unity's order.</summary>
    internal static MeshBuilder Cube()
    {
        // Corners as bits: 1 for +x, 2 for +y, 4 for +z.
        int[] corners = { 5, 4, 7, 6, 3, 2, 1, 0, 7, 6, 3, 2, 1, 5, 4, 0, 4, 6, 2, 0, 1, 3, 7, 5 };
        Vector3[] normals =
        {
            Vector3.forward, Vector3.forward, Vector3.up, Vector3.back, Vector3.up, Vector3.back,
        };
        Vector3[] ends = { Vector3.down, Vector3.left, Vector3.right };
        var builder = new MeshBuilder();
        for (int i = 0; i < corners.Length; i++)
        {
            int bits = corners[i];
            var vertex = new Vector3((bits & 1) - 0.5f, (bits >> 1 & 1) - 0.5f, (bits >> 2 & 1) - 0.5f);
            builder.Add(vertex, i < 12 ? normals[i / 2] : ends[(i - 12) / 4]);
        }
        builder.Triangles(0, 2, 3, 0, 3, 1, 8, 4, 5, 8, 5, 9, 10, 6, 7, 10, 7, 11);
        builder.Triangles(12, 13, 14, 12, 14, 15, 16, 17, 18, 16, 18, 19, 20, 21, 22, 20, 22, 23);
        return builder;
    }

    /// <summary>10 m x 10 m in XZ facing +y, 11 x 11 vertices starting at (5, 0, 5).</summary>
    internal static MeshBuilder Plane()
    {
        const int Cells = 10;
        var builder = new MeshBuilder();
        for (int row = 0; row <= Cells; row++)
        {
            for (int column = 0; column <= Cells; column++)
                builder.Add(new Vector3(5f - column, 0f, 5f - row), Vector3.up);
        }
        for (int row = 0; row < Cells; row++)
        {
            for (int column = 0; column < Cells; column++)
            {
                int corner = row * (Cells + 1) + column, next = corner + Cells + 1;
                builder.Triangles(corner, next, next + 1, corner, next + 1, corner + 1);
            }
        }
        return builder;
    }

    /// <summary>1 m x 1 m in XY facing -z.</summary>
    internal static MeshBuilder Quad()
    {
        var builder = new MeshBuilder();
        for (int i = 0; i < 4; i++)
            builder.Add(new Vector3((i & 1) - 0.5f, (i >> 1) - 0.5f, 0f), Vector3.back);
        builder.Triangles(0, 3, 1, 3, 0, 2);
        return builder;
    }
}
