using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>
    /// The part of a report that shows the target of cross sections or range profiles, and its hot spots.
    /// </summary>
    public sealed class CrossSectionScene
    {
        static readonly Command[] s_commands = { Commands.Rcs, Commands.Echo, Commands.Isar };

        readonly StoredRun _run;
        readonly RadarScene _scene;
        readonly int _row;

        /// <summary>The scene of a run.</summary>
        /// <param name="row">Index of the row that the report opens with; below 0: the strongest.</param>
        public CrossSectionScene(StoredRun run, RadarScene scene, int row) =>
            (_run, _scene, _row) = (run, scene, row);

        /// <summary>Opens the scene of a stored run.</summary>
        /// <exception cref="GlintException">The scene or mesh file does not exist any more.</exception>
        public static CrossSectionScene Of(StoredRun run, int row)
        {
            if (run.Info.Command == null)
                throw new GlintException("the results name no command: their scene cannot be opened again");
            string name = run.Info.Command.FirstOrDefault();
            var command = s_commands.SingleOrDefault(each => each.Name == name)
                ?? throw new GlintException($"the results are those of a command '{name}', and this version "
                    + $"opens the scenes of {string.Join(", ", s_commands.Select(each => each.Name))}: use the version "
                    + "that wrote them");
            var line = CommandLine.Parse(command, run.Info.Command.Skip(1).ToArray());
            return new CrossSectionScene(run, CrossSectionCommand.OpenScene(line).scene, row);
        }

        /// <summary>
        /// The scene in the format of the report's page: the model, and the corners of all hot spots, nine numbers a
        /// triangle, beside their objects and numbers.
        /// </summary>
        public JObject ToJson()
        {
            var model = new ReportModel(_scene, 0);
            var parts = new SceneParts(_scene);
            var corners = new List<float>();
            var names = new JArray();
            bool isChanged = CrossSectionSetup.ContentOf(_scene) != _run.Info.Sweep.Find(SweepIdentity.Content);
            var spots = _run.Rows.Where(row => row.Contributions != null)
                .SelectMany(row => row.Contributions.HotSpots).Select(spot => (spot.Object, spot.Triangle)).Distinct();
            foreach (var (objectNumber, triangle) in isChanged ? Enumerable.Empty<(int, int)>() : spots)
            {
                var points = parts.CornersOf(objectNumber, triangle)
                    ?? throw new GlintException($"the results are damaged: object {objectNumber} of the scene has no "
                        + $"triangle {triangle}, which is a hot spot");
                corners.AddRange(points.SelectMany(point => Floats(point - model.Centre)));
                names.Add(new JArray(objectNumber, triangle));
            }
            return new JObject(model.ToJson())
            {
                ["pose"] = _row < 0 ? null : (JToken)_row,
                ["is_changed"] = isChanged,
                ["centre"] = ReportModel.ToJson(_scene.Origin + model.Centre),
                ["hot_spots"] = new JObject
                {
                    ["names"] = names, ["corners"] = ReportModel.Base64(corners.ToArray(), sizeof(float))
                }
            };
        }

        static float[] Floats(double3 vector) => new[] { (float)vector.x, (float)vector.y, (float)vector.z };
    }
}
