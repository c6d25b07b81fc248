using System.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor.SceneManagement;
using static Unity.Mathematics.math;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>The figures of the published experiment's scene.</summary>
    public sealed class StoredSceneFiguresTests
    {
        [TearDown]
        public void LeaveAnEmptyScene() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);

        [Test]
        public void SceneOfTheCornerReflector_IsItsGeometryInCode()
        {
            EditorSceneManager.OpenScene("Packages/com.glint.scenes/CornerReflector.unity", OpenSceneMode.Single);
            var pose = Object.FindFirstObjectByType<RadarController>().Gather();
            RadarView expected = CornerReflector.View, view = pose.View;
            // Transforms are float32: some micrometres at 41 m, and some 1e-7 in a direction.
            foreach (var (ours, theirs, tolerance) in new[]
            {
                (view.Position, expected.Position, 5e-6), (view.ReceiverCentre, expected.ReceiverCentre, 5e-6),
                (view.Forward, expected.Forward, 2e-7), (view.Up, expected.Up, 2e-7),
                (view.ReceiverForward, expected.ReceiverForward, 2e-7), (view.ReceiverUp, expected.ReceiverUp, 2e-7),
                (view.ReceiverRight, expected.ReceiverRight, 2e-7)
            })
                Assert.That(length(ours - theirs), Is.LessThan(tolerance));
            Assert.That((view.VerticalFovDegrees, view.ReceiverSize),
                Is.EqualTo((expected.VerticalFovDegrees, expected.ReceiverSize)));
            Assert.That(Corners(pose.Scene), Is.EqualTo(Corners(new RadarScene(CornerReflector.Mesh))));
        }

        // Stored before there was clutter: the field is not in the file.
        [Test]
        public void SeaOfAStoredScene_HasClutterOff()
        {
            EditorSceneManager.OpenScene("Packages/com.glint.scenes/ShipLargeSea.unity", OpenSceneMode.Single);
            Assert.That(Object.FindFirstObjectByType<Sea>().Clutter, Is.EqualTo(SeaClutterSettings.Off));
        }

        // In steps of 0.1 mm, in any order.
        static double3[] Corners(RadarScene scene) => scene.Instances.SelectMany(
                instance => instance.Mesh.Vertices.Select(vertex => instance.ToWorld.Point(vertex)))
            .Select(point => round(1e4 * point) + 0.0).Distinct().OrderBy(point => point.x).ThenBy(point => point.y)
            .ThenBy(point => point.z).ToArray();

        [Test]
        public void OfTheCornerReflector_AreThoseOfItsMeasures()
        {
            EditorSceneManager.OpenScene("Packages/com.glint.scenes/CornerReflector.unity", OpenSceneMode.Single);
            var check = new RadarCheck(Object.FindFirstObjectByType<RadarController>());
            check.Update();
            Assert.That(check.Findings, Is.Empty);

            // Its plates fill a cube along its axes from -0.211 to 15.8985 m, which is rotated about (7.871, 7.871,
            // 8.052) m. The axes are tilted by 49.132 degrees.
            double lean = radians(49.132), side = (15.8985 - 0.211) / 2;
            double3 along = double3(0, -sin(lean), -cos(lean)), z = double3(0, cos(lean), -sin(lean));
            double3 centre = sqrt(2.0) * (side - 7.871) * along + (side - 8.052) * z;
            // The camera, 41.112 m away at an elevation of 9.974 degrees, looks down by 9.985 degrees.
            double3 camera = 41.112 * double3(0, sin(radians(9.974)), -cos(radians(9.974)));
            double3 forward = double3(0, -sin(radians(9.985)), cos(radians(9.985))), toCentre = centre - camera;
            double height = 2 * tan(radians(30.0)) * dot(toCentre, forward);
            var figures = check.Figures;
            Assert.That(figures.Distance, Is.EqualTo(length(toCentre)).Within(1e-3));
            Assert.That(figures.Distance, Is.EqualTo(41.3).Within(0.1));
            Assert.That(figures.Footprint.Value.y, Is.EqualTo(height).Within(1e-3));
            Assert.That(figures.Footprint.Value.x, Is.EqualTo(height * 1920 / 1080).Within(1e-3));
            Assert.That(figures.RaySpacing.Value, Is.EqualTo(height / 1080).Within(1e-6));
            Assert.That(figures.Settings.RaysEmitted, Is.EqualTo(1920 * 1080));
            Assert.That((figures.Objects, figures.Triangles), Is.EqualTo((3, 36)));
        }
    }
}
