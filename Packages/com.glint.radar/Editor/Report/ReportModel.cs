using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>The triangles of a scene as a report draws them.</summary>
    public sealed class ReportModel
    {
        /// <summary>Maximum number of triangles drawn; larger scenes are simplified.</summary>
        public const int MaxTriangles = 60000;

        /// <summary>
        /// Maximum number of objects drawn: of more, each mesh once before others are repeated, as the tiles of a sea,
        /// and those of many triangles first.
        /// </summary>
        public const int MaxInstances = 2000;

        readonly RadarScene _scene;
        readonly MeshInstance[] _drawn;
        readonly Dictionary<TriangleMesh, SimplifiedMesh> _sketches;

        /// <summary>The model of a scene.</summary>
        /// <param name="emptyCentre">Centre of a scene without triangles.</param>
        public ReportModel(RadarScene scene, double3 emptyCentre)
        {
            _scene = scene;
            _drawn = scene.Instances.Where(instance => instance.Mesh.TriangleCount > 0)
                .GroupBy(instance => instance.Mesh)
                .SelectMany(uses => uses.Select((instance, repetition) => (instance, repetition)))
                .OrderBy(each => each.repetition).ThenByDescending(each => each.instance.Mesh.TriangleCount)
                .Select(each => each.instance).Take(MaxInstances).ToArray();
            _sketches = SimplifiedMeshes(_drawn);
            Centre = _drawn.Length == 0 ? emptyCentre : CentreOf(_drawn, _sketches);
        }

        /// <summary>Centre of the box around what is drawn, in the scene's frame, metres.</summary>
        public double3 Centre { get; }

        /// <summary>
        /// The meshes and their instances. Lengths in metres relative to <see cref="Centre"/>, Unity's axes; arrays of
        /// numbers as base64, little-endian.
        /// </summary>
        internal JObject ToJson()
        {
            var order = _sketches.Keys.ToList();
            return new JObject
            {
                ["triangles"] = _scene.TriangleCount,
                ["drawn"] = _drawn.Sum(instance => (long)_sketches[instance.Mesh].TriangleCount),
                ["meshes"] = new JArray(order.Select(mesh => ToJson(_sketches[mesh]))),
                ["instances"] = new JArray(_drawn.Select(instance => new JObject
                {
                    ["mesh"] = order.IndexOf(instance.Mesh), ["place"] = ToJson(instance.ToWorld, Centre)
                }))
            };
        }

        internal static JArray ToJson(double3 vector) => new JArray(vector.x, vector.y, vector.z);

        internal static string Base64(Array numbers, int size)
        {
            var bytes = new byte[numbers.Length * size];
            Buffer.BlockCopy(numbers, 0, bytes, 0, bytes.Length);
            return Convert.ToBase64String(bytes);
        }

        // Small meshes keep all triangles; the large ones share the rest of the limit.
        static Dictionary<TriangleMesh, SimplifiedMesh> SimplifiedMeshes(MeshInstance[] instances)
        {
            const int min = 12;
            var sketches = new Dictionary<TriangleMesh, SimplifiedMesh>();
            var uses = instances.GroupBy(instance => instance.Mesh)
                .OrderBy(group => (long)group.Key.TriangleCount * group.Count()).ToArray();
            long left = MaxTriangles;
            for (int i = 0; i < uses.Length; i++)
            {
                var (mesh, count) = (uses[i].Key, uses[i].Count());
                var simplified = SimplifiedMesh.Of(mesh, (int)Math.Max(min, left / (uses.Length - i) / count));
                left = Math.Max(0, left - (long)simplified.TriangleCount * count);
                sketches.Add(mesh, simplified);
            }
            return sketches;
        }

        static double3 CentreOf(MeshInstance[] drawn, Dictionary<TriangleMesh, SimplifiedMesh> sketches)
        {
            double3 boxMin = double.PositiveInfinity, boxMax = double.NegativeInfinity;
            foreach (var instance in drawn)
                for (int corner = 0; corner < 8; corner++)
                {
                    var simplified = sketches[instance.Mesh];
                    double3 position = instance.ToWorld.Point(simplified.Min
                        + simplified.Size * new double3(corner & 1, corner >> 1 & 1, corner >> 2));
                    (boxMin, boxMax) = (math.min(boxMin, position), math.max(boxMax, position));
                }
            return boxMin + 0.5 * (boxMax - boxMin);
        }

        static JObject ToJson(SimplifiedMesh simplified) => new JObject
        {
            ["low"] = ToJson(simplified.Min),
            ["size"] = ToJson(simplified.Size),
            ["positions"] = Base64(simplified.Positions.ToArray(), sizeof(ushort)),
            ["indices"] = Base64(simplified.Indices.ToArray(), sizeof(int))
        };

        static JArray ToJson(in Affine transform, double3 midpoint) =>
            new JArray(new[] { transform.X, transform.Y, transform.Z, transform.Origin - midpoint }.SelectMany(ToJson));
    }
}
