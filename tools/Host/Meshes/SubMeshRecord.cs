namespace Glint.Host;

/// <summary>
/// A part of a mesh. Topology is Unity's number: 0 triangles, 2 quads, 3 lines, 4 line strip, 5 points.
/// </summary>
/// <param name="FirstIndex">
/// First index in the mesh's index buffer; <paramref name="BaseVertex"/> is added to each index.
/// </param>
/// <param name="Box">m_Center and m_Extent from the file.</param>
internal sealed record SubMeshRecord(int Topology, int FirstIndex, int IndexCount, int BaseVertex, int FirstVertex,
    int VertexCount, FieldMap Box);
