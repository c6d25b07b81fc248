using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public void RecalculateBounds() => RecalculateBounds(MeshUpdateFlags.Default);

    public void RecalculateBounds(MeshUpdateFlags flags)
    {
        if (!CanAccess("vertices"))
            return;
        for (int i = 0; i < subMeshCount; i++)
            Contents.Measure(i);
        Contents.UniteBounds();
    }

    public void RecalculateNormals() => RecalculateNormals(MeshUpdateFlags.Default);

    /// <summary>
    /// Mean of the faces around each vertex, weighted by area; faces are clockwise about their normal (left-handed).
    /// </summary>
    public void RecalculateNormals(MeshUpdateFlags flags)
    {
        if (!CanAccess("normals"))
            return;
        Vector3[] points = Contents.Vertices;
        var sums = new Vector3[points.Length];
        int[] corners = triangles;
        for (int i = 0; i < corners.Length; i += 3)
        {
            int a = corners[i], b = corners[i + 1], c = corners[i + 2];
            Vector3 normal = Vector3.Cross(points[b] - points[a], points[c] - points[a]);
            sums[a] += normal;
            sums[b] += normal;
            sums[c] += normal;
        }
        for (int i = 0; i < sums.Length; i++)
        {
            float length = sums[i].magnitude;
            sums[i] = length > 0f ? sums[i] / length : Vector3.zero;
        }
        Contents.Normals = sums;
    }
}
