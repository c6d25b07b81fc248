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

        /// <summary>Number of received rays of which paths are chosen: one a pixel.</summary>
        public int Received;

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
            var model = new ReportModel(Pose.Scene, Pose.View.Position);
            double3 centre = model.Centre;
            return new JObject(model.ToJson())
            {
                ["pose"] = Number,
                ["amplitude"] = Result.Amplitude,
                ["received"] = Result.RaysReceived,
                ["radar"] = ToJson(Pose.View, Pose.Settings, centre),
                ["paths"] = new JObject
                {
                    ["received"] = Received,
                    ["points"] =
                        ReportModel.Base64(Paths.SelectMany(path => path)
                            .SelectMany(point => Floats(point - centre)).ToArray(), sizeof(float)),
                    ["counts"] = new JArray(Paths.Select(path => path.Length))
                },
                ["picture"] = Preview?.ToJson(ObjectName)
            };
        }

        static JObject ToJson(in RadarView view, in RadarSettings settings, double3 midpoint)
        {
            double2 half = view.HalfSize(settings);
            return new JObject
            {
                ["place"] = ReportModel.ToJson(view.Position - midpoint),
                ["right"] = ReportModel.ToJson(view.Right),
                ["up"] = ReportModel.ToJson(view.Up),
                ["forward"] = ReportModel.ToJson(view.Forward),
                ["parallel"] = view.IsParallel,
                ["half"] = new JArray(half.x, half.y),
                ["receiver"] = ReportModel.ToJson(view.ReceiverCentre - midpoint),
                ["receiver_right"] = ReportModel.ToJson(view.ReceiverRight * view.ReceiverSize.x / 2),
                ["receiver_up"] = ReportModel.ToJson(view.ReceiverUp * view.ReceiverSize.y / 2)
            };
        }

        static float[] Floats(double3 vector) => new[] { (float)vector.x, (float)vector.y, (float)vector.z };
    }
}
