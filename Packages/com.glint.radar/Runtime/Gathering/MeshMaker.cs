using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>
    /// Makes Unity meshes from triangles. It marks what it fills, so that no pose reads these meshes again. A script that
    /// changes one by other means calls <see cref="RadarController.MarkChanged"/>.
    /// </summary>
    public static class MeshMaker
    {
        const int Max16BitVertices = 65535;

        /// <summary>A new mesh.</summary>
        public static Mesh Make(string name, float3[] vertices, int[] indices)
        {
            var mesh = new Mesh { name = name };
            Fill(mesh, vertices, indices);
            return mesh;
        }

        /// <summary>A new mesh with a submesh for each surface of a file.</summary>
        public static Mesh Make(MeshFile file)
        {
            var mesh = Make(file.Name, file.Vertices, file.Indices);
            mesh.subMeshCount = file.Surfaces.Count;
            for (int i = 0; i < file.Surfaces.Count; i++)
            {
                int first = file.Surfaces[i].FirstTriangle,
                    end = i + 1 < file.Surfaces.Count ? file.Surfaces[i + 1].FirstTriangle : file.TriangleCount;
                mesh.SetIndices(file.Indices, 3 * first, 3 * (end - first), MeshTopology.Triangles, i);
            }
            MeshWatch.MarkFilled(mesh);
            return mesh;
        }

        /// <summary>Replaces a mesh's triangles, normals and bounds.</summary>
        public static void Fill(Mesh mesh, float3[] vertices, int[] indices)
        {
            mesh.Clear();
            mesh.indexFormat = vertices.Length > Max16BitVertices ? IndexFormat.UInt32 : IndexFormat.UInt16;
            mesh.SetVertices(System.Array.ConvertAll(vertices, v => new Vector3(v.x, v.y, v.z)));
            mesh.SetIndices(indices, MeshTopology.Triangles, 0);
            mesh.RecalculateNormals();
            MeshWatch.MarkFilled(mesh);
        }
    }
}
