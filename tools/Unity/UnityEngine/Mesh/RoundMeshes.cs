using System;
using UnityEngine;

namespace Glint.Host;

internal static class RoundMeshes
{
    const float Radius = 0.5f;

    /// <summary>
    /// Six faces of 8 x 8 quads: 768 triangles as in Unity, on 486 vertices (in Unity 515: its texture has seams).
    /// </summary>
    internal static MeshBuilder Sphere() => CubeSphere(0f);

    /// <summary>Height 2 m: the sphere cut at its equator and a band of 32 quads: 832 triangles as in Unity.</summary>
    internal static MeshBuilder Capsule() => CubeSphere(0.5f);

    /// <summary>Height 2 m, 20 sides: 80 triangles as in Unity.</summary>
    internal static MeshBuilder Cylinder()
    {
        const int Sides = 20;
        var builder = new MeshBuilder();
        builder.Grid(Sides, 1,
            (column, row) => (Rim(Sides - column) * Radius + Vector3.up * (2 * row - 1), Rim(Sides - column)));
        foreach (Vector3 normal in new[] { Vector3.up, Vector3.down })
        {
            int centre = builder.Add(normal, normal);
            for (int i = 0; i < Sides; i++)
                builder.Add(Rim(i) * Radius + normal, normal);
            for (int i = 0; i < Sides; i++)
            {
                int rim = centre + 1 + i, next = centre + 1 + (i + 1) % Sides;
                builder.Triangles(centre, normal.y > 0f ? next : rim, normal.y > 0f ? rim : next);
            }
        }
        return builder;

        // From +x towards +z. The last point equals the first bit for bit.
        static Vector3 Rim(int i)
        {
            (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * (i % Sides) / Sides);
            return new Vector3((float)cosine, 0f, (float)sine);
        }
    }

    /// <summary>
    /// A cube's faces, each a grid of equal angles, projected onto a sphere; its halves are moved apart by twice the
    /// gap.
    /// </summary>
    static MeshBuilder CubeSphere(float gap)
    {
        const int Cells = 8;
        var builder = new MeshBuilder();
        Face(Vector3.forward, Vector3.right);
        Face(Vector3.back, Vector3.left);
        Face(Vector3.right, Vector3.back);
        Face(Vector3.left, Vector3.forward);
        builder.Grid(Cells, Cells,
            (u, v) => Point(Vector3.up + Vector3.forward * Grid(u) + Vector3.right * Grid(v), gap));
        builder.Grid(Cells, Cells,
            (u, v) => Point(Vector3.down + Vector3.right * Grid(u) + Vector3.forward * Grid(v), -gap));
        return builder;

        // With a gap the equator has two rows of vertices, and the quads between are the band.
        void Face(Vector3 outwards, Vector3 across)
        {
            int middle = Cells / 2, band = gap > 0f ? 1 : 0;
            builder.Grid(Cells, Cells + band, (u, v) =>
            {
                bool upper = v >= middle + band;
                return Point(outwards + across * Grid(u) + Vector3.up * Grid(upper ? v - band : v), upper ? gap : -gap);
            });
        }

        static (Vector3, Vector3) Point(Vector3 onCube, float shift)
        {
            Vector3 normal = onCube.normalized;
            return (normal * Radius + Vector3.up * shift, normal);
        }

        static float Grid(int i) => (float)Math.Tan(Math.PI / 4.0 * (2.0 * i / Cells - 1.0));
    }
}
