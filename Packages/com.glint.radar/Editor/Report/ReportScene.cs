using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>
    /// The part of a report that shows one pose: triangles, the paths of received rays, and the radar's view.
    /// </summary>
    public sealed class ReportScene
    {
        /// <summary>Maximum number of triangles drawn; larger scenes are simplified.</summary>
        public const int MaxTriangles = 60000;

        /// <summary>Maximum number of objects drawn.</summary>
        public const int MaxInstances = 2000;

        /// <summary>Scene, settings and view of the pose.</summary>
        public RadarPose Pose;

        /// <summary>Index of the pose in the run, from 0.</summary>
        public int Number;

        /// <summary>Result of the repeated trace of the pose.</summary>
        public RadarResult Result;

        /// <summary>
        /// Paths of received rays, evenly chosen: start, points of reflection, receiver; in the frame of the scene.
        /// </summary>
        public IReadOnlyList<double3[]> Paths = Array.Empty<double3[]>();

        /// <summary>The radar's view; null for none.</summary>
        public RadarPreviewImage Preview;

        /// <summary>Names of the picture's objects by their numbers.</summary>
        public Func<int, string> ObjectName = number => $"object {number}";

        /// <summary>
        /// The scene in the format of the report's page. Lengths in metres relative to the centre of the drawn scene,
        /// Unity's axes; arrays of numbers as base64, little-endian.
        /// </summary>
        internal JObject ToJson()
        {
            var sketches = SimplifiedMeshes(Pose.Scene.Instances);
            var drawn = Pose.Scene.Instances.Where(instance => instance.Mesh.TriangleCount > 0)
                .Take(MaxInstances).ToArray();
            double3 centre = Centre(drawn, sketches);
            var order = sketches.Keys.ToList();
            return new JObject
            {
                ["pose"] = Number,
                ["amplitude"] = Result.Amplitude,
                ["received"] = Result.RaysReceived,
                ["triangles"] = Pose.Scene.TriangleCount,
                ["drawn"] = drawn.Sum(instance => (long)sketches[instance.Mesh].TriangleCount),
                ["meshes"] = new JArray(order.Select(mesh => ToJson(sketches[mesh]))),
                ["instances"] = new JArray(drawn.Select(instance => new JObject
                {
                    ["mesh"] = order.IndexOf(instance.Mesh), ["place"] = ToJson(instance.ToWorld, centre)
                })),
                ["radar"] = ToJson(Pose.View, Pose.Settings, centre),
                ["paths"] = new JObject
                {
                    ["points"] =
                        Base64(Paths.SelectMany(path => path).SelectMany(point => Floats(point - centre)).ToArray(),
                            sizeof(float)),
                    ["counts"] = new JArray(Paths.Select(path => path.Length))
                },
                ["picture"] = Preview?.ToJson(ObjectName)
            };
        }

        // Small meshes keep all triangles; the large ones share the rest of the limit.
        static Dictionary<TriangleMesh, SimplifiedMesh> SimplifiedMeshes(MeshInstance[] instances)
        {
            const int min = 12;
            var sketches = new Dictionary<TriangleMesh, SimplifiedMesh>();
            var uses = instances.Where(instance => instance.Mesh.TriangleCount > 0).Take(MaxInstances)
                .GroupBy(instance => instance.Mesh)
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

        double3 Centre(MeshInstance[] drawn, Dictionary<TriangleMesh, SimplifiedMesh> sketches)
        {
            if (drawn.Length == 0)
                return Pose.View.Position;
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

        static JObject ToJson(in RadarView view, in RadarSettings settings, double3 midpoint)
        {
            double2 half = view.HalfSize(settings);
            return new JObject
            {
                ["place"] = ToJson(view.Position - midpoint),
                ["right"] = ToJson(view.Right),
                ["up"] = ToJson(view.Up),
                ["forward"] = ToJson(view.Forward),
                ["parallel"] = view.IsParallel,
                ["half"] = new JArray(half.x, half.y),
                ["receiver"] = ToJson(view.ReceiverCentre - midpoint),
                ["receiver_right"] = ToJson(view.ReceiverRight * view.ReceiverSize.x / 2),
                ["receiver_up"] = ToJson(view.ReceiverUp * view.ReceiverSize.y / 2)
            };
        }

        static JArray ToJson(double3 vector) => new JArray(vector.x, vector.y, vector.z);

        static float[] Floats(double3 vector) => new[] { (float)vector.x, (float)vector.y, (float)vector.z };

        static string Base64(Array numbers, int size)
        {
            var bytes = new byte[numbers.Length * size];
            Buffer.BlockCopy(numbers, 0, bytes, 0, bytes.Length);
            return Convert.ToBase64String(bytes);
        }
    }
}
