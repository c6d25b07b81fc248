namespace Glint.Host;

/// <summary>
/// A part of a mesh. Topology is Unity's number: 0 triangles, 2 quads, 3 lines, 4 line strip, 5 points.
/// </summary>
/// <param name="FirstIndex">
/// Into the index buffer of the mesh, to whose indices <paramref name="BaseVertex"/> is still to be added.
/// </param>
/// <param name="Box">m_Center and m_Extent, as the file has them.</param>
internal sealed record SubMeshRecord(int Topology, int FirstIndex, int IndexCount, int BaseVertex, int FirstVertex,
    int VertexCount, FieldMap Box);
