using System;
using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host;

/// <summary>Collects vertices with normals and triangles, clockwise seen from outside.</summary>
internal sealed class MeshBuilder
{
    readonly List<Vector3> _vertices = new();
    readonly List<Vector3> _normals = new();
    readonly List<int> _triangles = new();

    internal int Add(Vector3 vertex, Vector3 normal)
    {
        _vertices.Add(vertex);
        _normals.Add(normal);
        return _vertices.Count - 1;
    }

    internal void Triangles(params int[] corners) => _triangles.AddRange(corners);

    /// <summary>A grid of quads; it faces to cross(column direction, row direction).</summary>
    internal void Grid(int columns, int rows, Func<int, int, (Vector3 Vertex, Vector3 Normal)> at)
    {
        int first = _vertices.Count;
        for (int row = 0; row <= rows; row++)
        {
            for (int column = 0; column <= columns; column++)
            {
                (Vector3 vertex, Vector3 normal) = at(column, row);
                Add(vertex, normal);
            }
        }
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < columns; column++)
            {
                int corner = first + row * (columns + 1) + column, above = corner + columns + 1;
                Triangles(corner, corner + 1, above + 1, corner, above + 1, above);
            }
        }
    }

    internal void Fill(Mesh mesh)
    {
        mesh.SetVertices(_vertices);
        mesh.SetNormals(_normals);
        mesh.SetTriangles(_triangles, 0);
    }
}
