using System.Linq;
using System.Reflection;
using Glint.Core;
using Glint.Editor;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>The objects of the menu GameObject > Glint.</summary>
    public sealed class SceneObjectsTests
    {
        [SetUp]
        public void BeginEmpty()
        {
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
            Undo.ClearAll();
        }

        [TearDown]
        public void LeaveAnEmptyScene()
        {
            foreach (var radar in Object.FindObjectsByType<RadarController>(FindObjectsSortMode.None))
                radar.Release();
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
        }

        [Test]
        public void RadarAndCornerReflector_AreThePublishedExperimentButForTheReceiver()
        {
            SceneObjects.MakeCornerReflector(null);
            var radar = SceneObjects.MakeRadar(null);
            var check = new RadarCheck(radar);
            check.Update();
            Assert.That(check.Findings, Is.Empty);

            radar.Settings = TestRadar.Settings(480, 270);
            var result = radar.Trace();
            var expected = TestKernels.TraceOnce(CornerReflector.Mesh, radar.Settings,
                AccuracyScene.PublishedView(CornerReflector.Distance, AccuracyScene.PublishedGrazingDegrees));
            Assert.That(result.RaysReceived, Is.GreaterThan(20));
            Assert.That(result.RaysHit, Is.EqualTo(expected.RaysHit).Within(5));
            Assert.That(result.RaysReceived, Is.EqualTo(expected.RaysReceived).Within(3));
            var paths = radar.GetComponent<RayPaths>();
            paths.Lines();
            Assert.That(paths.Count, Is.EqualTo(result.RaysReceived));
        }

        [Test]
        public void RadarScreen_OfAShip_TurnsOnItsMast()
        {
            var ship = new GameObject("Ship").transform;
            ship.position = new Vector3(10, 1, 20);
            var screen = SceneObjects.MakeScreen(ship.gameObject);
            Assert.That(screen.transform.position, Is.EqualTo(new Vector3(10, 16, 20)));
            Assert.That(screen.OwnShip, Is.SameAs(ship));
            screen.Radar = ScreenBench.Small();
            screen.Advance(0.1);
            Assert.That(screen.Picture.width, Is.EqualTo(screen.Display.Side));
            Assert.That(SceneObjects.MakeScreen(null).OwnShip, Is.Null);
        }

        [Test]
        public void Radar_OfASelectedObject_LooksAtItsMiddleFromWhereAllOfItIsSeen()
        {
            var box = GameObject.CreatePrimitive(PrimitiveType.Cube).transform;
            (box.position, box.localScale) = (new Vector3(100, 5, -30), new Vector3(20, 4, 6));
            var radar = SceneObjects.MakeRadar(box.gameObject);
            var check = new RadarCheck(radar);
            check.Update();

            Assert.That(check.Findings.Where(finding => finding.Text.Contains("picture")), Is.Empty);
            Assert.That(Vector3.Angle(radar.transform.forward, box.position - radar.transform.position),
                Is.LessThan(0.01));
            // Three half-diagonals away; the view's height is 2 tan(30 deg) times its distance.
            Assert.That(check.Figures.Distance, Is.EqualTo(1.5 * math.sqrt(20 * 20 + 4 * 4 + 6 * 6)).Within(1e-3));
            Assert.That(check.Figures.Footprint.Value.y, Is.GreaterThan(check.Figures.TargetSize));
            Assert.That(radar.transform.parent == null, "it does not move with what it looks at");
        }

        [Test]
        public void Sea_IsBuiltAndTraced()
        {
            var sea = SceneObjects.MakeSea(null);
            var radar = SceneObjects.MakeRadar(null);
            var waves = SeaSettings.Default;
            Assert.That(radar.Gather().Scene.TriangleCount, Is.EqualTo(2 * waves.Cells * waves.Cells * sea.TileCount));
            Assert.That(sea.TileCount, Is.EqualTo(2));
            Assert.That(sea.GetComponentInChildren<MeshRenderer>().sharedMaterial != null);
            Assert.That(sea.Clutter, Is.EqualTo(SeaClutterSettings.On));
            Assert.That(radar.Gather().Scene.Seas.Single().Tiles.Count, Is.EqualTo(2));
        }

        [Test]
        public void Ship_IsTheStandardOne()
        {
            var ship = SceneObjects.MakeShip(null);
            Assert.That(SceneObjects.MakeRadar(ship.gameObject).Gather().Scene.TriangleCount,
                Is.EqualTo(ShipModel.Build(ShipSettings.Default).TriangleCount));
            Assert.That(ship.Settings, Is.EqualTo(ShipSettings.Default));
        }

        [Test]
        public void CrossSection_OfASelectedObject_IsReadyToRun()
        {
            var box = GameObject.CreatePrimitive(PrimitiveType.Cube);
            GameObject.CreatePrimitive(PrimitiveType.Sphere);
            var made = SceneObjects.MakeCrossSection(box);
            var check = new CrossSectionCheck(made);
            check.Update();
            Assert.That(check.Findings, Is.Empty);
            Assert.That((made.Target, made.transform.parent == null), Is.EqualTo((box.transform, true)));
            Assert.That(check.Setup.Scene.TriangleCount, Is.EqualTo(12), "the cube alone");
        }

        [Test]
        public void Made_BelowAnObject_StandsThereUnderANameOfItsOwnAndIsSelected()
        {
            var parent = new GameObject("Parent") { layer = 5 };
            parent.transform.position = new Vector3(1, 2, 3);
            var first = SceneObjects.MakeCornerReflector(parent);
            var second = SceneObjects.MakeCornerReflector(parent);
            Assert.That(second.transform.parent, Is.SameAs(parent.transform));
            Assert.That(second.transform.position, Is.EqualTo(parent.transform.position));
            Assert.That(second.GetComponentsInChildren<Transform>().Select(part => part.gameObject.layer),
                Is.All.EqualTo(5));
            Assert.That(first.name, Is.Not.EqualTo(second.name));
            Assert.That(Selection.activeGameObject, Is.SameAs(second));
        }

        [Test]
        public void Undo_TakesEachAway()
        {
            SceneObjects.MakeCornerReflector(null);
            SceneObjects.MakeSea(null);
            SceneObjects.MakeShip(null);
            SceneObjects.MakeRadar(null);
            SceneObjects.MakeCrossSection(null);
            for (int left = 4; left >= 0; left--)
            {
                Undo.PerformUndo();
                Assert.That(EditorSceneManager.GetActiveScene().rootCount, Is.EqualTo(left));
            }
        }

        [Test]
        public void Menu_HasSixItemsThatMakeThem()
        {
            var items = typeof(GlintMenu).GetMethods(BindingFlags.Static | BindingFlags.NonPublic)
                .Where(method => method.IsDefined(typeof(MenuItem), false)).ToArray();
            Assert.That(items.Select(item => item.GetCustomAttribute<MenuItem>().menuItem), Is.EquivalentTo(new[]
                {
                    "GameObject/Glint/Radar", "GameObject/Glint/Cross section", "GameObject/Glint/Corner reflector",
                    "GameObject/Glint/Sea", "GameObject/Glint/Ship", "GameObject/Glint/Radar screen"
                }));
            foreach (var item in items)
                item.Invoke(null, new object[] { new MenuCommand(null) });
            Assert.That(EditorSceneManager.GetActiveScene().rootCount, Is.EqualTo(6));
        }
    }
}
