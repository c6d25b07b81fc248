namespace UnityEngine.Rendering;

public struct SubMeshDescriptor
{
    public SubMeshDescriptor(int indexStart, int indexCount, MeshTopology topology = MeshTopology.Triangles)
    {
        this = default;
        this.indexStart = indexStart;
        this.indexCount = indexCount;
        this.topology = topology;
    }

    public Bounds bounds { get; set; }
    public MeshTopology topology { get; set; }
    public int indexStart { get; set; }
    public int indexCount { get; set; }

    /// <summary>Added to every index when vertices are looked up.</summary>
    public int baseVertex { get; set; }

    public int firstVertex { get; set; }
    public int vertexCount { get; set; }

    public override string ToString()
    {
        return $"(topo={topology} indices={indexStart},{indexCount} vertices={firstVertex},{vertexCount} "
            + $"basevtx={baseVertex} bounds={bounds})";
    }
}
