using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Objects below one root, and their triangles in the world: as gathered, and computed independently.
    /// </summary>
    sealed class SceneBuilder
    {
        public Transform Root { get; } = new GameObject("Root").transform;

        public void Destroy() => Object.DestroyImmediate(Root.gameObject);

        public RadarScene Gather(SceneGatherer gatherer) => gatherer.Gather(~0, new List<Transform> { Root }, null);

        public Transform Add(string name, Mesh mesh, Transform parent = null)
        {
            var added = Empty(name, parent);
            added.gameObject.AddComponent<MeshFilter>().sharedMesh = mesh;
            added.gameObject.AddComponent<MeshRenderer>();
            return added;
        }

        public Transform Empty(string name, Transform parent = null)
        {
            var added = new GameObject(name).transform;
            added.SetParent(parent == null ? Root : parent, false);
            return added;
        }

        /// <summary>Triangles of random corners in a 2 m cube around a point; the same for a seed.</summary>
        public static Mesh Mesh(int triangles, int seed, float3 centre = default)
        {
            var random = new System.Random(seed);
            float Next() => (float)(2 * random.NextDouble() - 1);
            var vertices = Enumerable.Range(0, 3 * triangles)
                .Select(_ => (Vector3)(centre + float3(Next(), Next(), Next()))).ToArray();
            var mesh = new Mesh { name = $"Mesh {seed}", indexFormat = UnityEngine.Rendering.IndexFormat.UInt32 };
            mesh.vertices = vertices;
            mesh.triangles = Enumerable.Range(0, vertices.Length).ToArray();
            return mesh;
        }

        /// <summary>World coordinates of all triangle corners, in the order of the scene.</summary>
        public static double3[] Corners(RadarScene scene) =>
            scene.Instances.SelectMany(instance =>
                instance.Mesh.Indices.Select(index => instance.ToWorld.Point(instance.Mesh.Vertices[index]))).ToArray();

        /// <summary>The same from the active objects in the given order, computed without the product's
        /// code.</summary>
        public static double3[] Corners(IEnumerable<Transform> objects)
        {
            var corners = new List<double3>();
            foreach (var item in objects)
            {
                var mesh = item.GetComponent<MeshFilter>().sharedMesh;
                var vertices = mesh.vertices;
                corners.AddRange(mesh.triangles.Select(index => ToWorld(item, (float3)vertices[index])));
            }
            return corners.ToArray();
        }

        /// <summary>
        /// World position of a point: scaled, rotated and translated by each transform up to the root, in double.
        /// </summary>
        public static double3 ToWorld(Transform from, double3 point)
        {
            for (var at = from; at != null; at = at.parent)
            {
                double3 scaled = point * (float3)at.localScale;
                var q = at.localRotation;
                double4 rotation = normalize(double4(q.x, q.y, q.z, q.w));
                // Rodrigues: v + 2 w (q x v) + 2 q x (q x v).
                double3 across = 2 * cross(rotation.xyz, scaled);
                point = (float3)at.localPosition + (scaled + rotation.w * across + cross(rotation.xyz, across));
            }
            return point;
        }

        /// <summary>Largest distance between points of the same index.</summary>
        public static double Apart(double3[] some, double3[] others) =>
            some.Zip(others, (a, b) => distance(a, b)).DefaultIfEmpty(0).Max();
    }
}
