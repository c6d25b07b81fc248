using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor.SceneManagement;
using UnityEngine;
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
        public void OfTheCornerReflector_AreThoseOfItsMeasures()
        {
            EditorSceneManager.OpenScene("Packages/com.glint.scenes/CornerReflector.unity", OpenSceneMode.Single);
            var check = new RadarCheck(Object.FindFirstObjectByType<RadarController>());
            check.Update();
            Assert.That(check.Findings, Is.Empty);

            // Its plates fill a cube along its axes from -0.2 to 15.9 m, which turns about the point 8 m up each: the middle of the cube lies 0.15 m nearer to the vertex.
            // The axes' sum: they lean over by 49.25 degrees.
            double lean = radians(49.25);
            double3 axes = sqrt(2.0) * double3(0, -sin(lean), -cos(lean)) + double3(0, cos(lean), -sin(lean));
            // The camera looks down by 10 degrees at that point, 41.08 m away.
            double3 forward = double3(0, -sin(radians(10.0)), cos(radians(10.0))), toMiddle = 41.08 * forward - 0.15 * axes;
            double height = 2 * tan(radians(30.0)) * dot(toMiddle, forward);
            var figures = check.Figures;
            Assert.That(figures.Distance, Is.EqualTo(length(toMiddle)).Within(1e-3));
            Assert.That(figures.Distance, Is.EqualTo(41.3).Within(0.1));
            Assert.That(figures.Footprint.Value.y, Is.EqualTo(height).Within(1e-3));
            Assert.That(figures.Footprint.Value.x, Is.EqualTo(height * 1920 / 1080).Within(1e-3));
            Assert.That(figures.RaySpacing.Value, Is.EqualTo(height / 1080).Within(1e-6));
            Assert.That(figures.Settings.RaysEmitted, Is.EqualTo(1920 * 1080));
            Assert.That((figures.Objects, figures.Triangles), Is.EqualTo((3, 36)));
        }
    }
}
