using System.Linq;
using System.Reflection;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The figures of a sea in its inspector.</summary>
    public sealed class SeaFiguresTests
    {
        Sea _sea;

        [SetUp]
        public void MakeSea() => _sea = new GameObject("Sea").AddComponent<Sea>();

        [TearDown]
        public void RemoveSea() => Object.DestroyImmediate(_sea.gameObject);

        [Test]
        public void Waves_NameEveryFieldThatCanBeSet_WithALabelAndATooltip()
        {
            var fields = typeof(SeaSettings).GetFields(BindingFlags.Public | BindingFlags.Instance)
                .Select(field => field.Name);
            Assert.That(SeaFigures.Waves.Select(it => it.field), Is.EqualTo(fields));
            Assert.That(SeaFigures.Waves, Has.All.Matches<(string field, string label, string tooltip)>(
                it => it.label.Length > 0 && it.tooltip.EndsWith(".")));
        }

        [Test]
        public void Clutter_NamesEveryFieldThatCanBeSet_WithALabelAndATooltip()
        {
            var fields = typeof(SeaClutterSettings).GetFields(BindingFlags.Public | BindingFlags.Instance)
                .Select(field => field.Name);
            Assert.That(SeaFigures.Clutter.Select(it => it.field), Is.EqualTo(fields));
            Assert.That(SeaFigures.Clutter, Has.All.Matches<(string field, string label, string tooltip)>(
                it => it.label.Length > 0 && it.tooltip.EndsWith(".")));
        }

        // 64 grid points over 64 m hold 31.5 waves.
        [Test]
        public void Rows_WithClutter_SayWhatTheMeshLeavesOut()
        {
            Assert.That(SeaFigures.Rows(_sea).Select(row => row.label), Has.None.EqualTo("Clutter wind"));
            _sea.Clutter = SeaClutterSettings.On;
            Assert.That(Row("Clutter wind"), Is.EqualTo("7.0 m/s"));
            Assert.That(Row("Mesh ends at"), Is.EqualTo("3.093 rad/m, waves of 2.032 m"));
            Assert.That(Row("Step there"), Is.EqualTo("0.0 dB"));
            Assert.That(Row("Breaking"), Is.EqualTo("0.29 %"));
            double height = 1e3 * new ShortWaves(new SeaSurface(_sea.Waves)).HeightDeviation(3.0925, 2000);
            Assert.That(Row("Height left out"), Is.EqualTo($"{height:0.0} mm"));
        }

        // Waves of half their wind's height have a quarter of its variance: a step of 6 dB.
        [Test]
        public void Check_ClutterThatDoesNotFit_IsReported()
        {
            _sea.Clutter = SeaClutterSettings.On;
            Assert.That(SeaFigures.Check(_sea), Is.Null);
            var waves = _sea.Waves;
            waves.HeightFactor = 0.5;
            _sea.Waves = waves;
            Assert.That(SeaFigures.Check(_sea).Severity, Is.EqualTo(Severity.Warning));
            Assert.That(SeaFigures.Check(_sea).Text, Does.Contain("6.0 dB above"));
            var settings = _sea.Clutter;
            settings.Wind = 1;
            _sea.Clutter = settings;
            Assert.That(SeaFigures.Check(_sea).Severity, Is.EqualTo(Severity.Error));
            Assert.That(SeaFigures.Check(_sea).Text, Does.StartWith("Sea of 'Sea': "));
            Assert.That(SeaFigures.Rows(_sea).Select(row => row.label), Has.None.EqualTo("Clutter wind"));
        }

        [Test]
        public void Rows_OfWaves_CountTilesAndTriangles()
        {
            _sea.Extent = new Vector2(128, 192);
            _sea.Rebuild();
            // 2 x 3 tiles of 64 m, 64 x 64 cells of two triangles each.
            Assert.That(Row("Tiles"), Is.EqualTo("6, 49,152 triangles"));
            Assert.That(Row("Tile"), Is.EqualTo("64 m, 8,192 triangles"));
            Assert.That(Row("Waves"), Is.EqualTo("Elfouhaily, height of the wind, wind 7 m/s to 0 deg"));
            Assert.That(Row("Shown"), Is.EqualTo("waves at 0 s"));
            _sea.enabled = false;
            Assert.That(Row("Tiles"), Is.EqualTo("0, 0 triangles"));
        }

        [Test]
        public void Rows_OfSnapshots_SayWhichIsShown()
        {
            foreach (int number in new[] { 1, 2 })
                _sea.Snapshots.Add(AssetDatabase.LoadAssetAtPath<GameObject>(
                    $"Packages/com.glint.meshes/SeaState5/Snapshot 0{number}.prefab").GetComponent<SeaSnapshot>());
            _sea.Snapshots.Add(null);
            _sea.Snapshot = 2;
            var settings = StoredSeas.SeaState5.Settings;
            Assert.That(Row("Shown"), Does.StartWith("snapshot 2: Snapshot 02, 10 s, "));
            Assert.That(Row("Waves"), Does.StartWith("Phillips, 2.5 m high"));
            Assert.That(Row("Tile"), Is.EqualTo($"64 m, {2 * settings.Cells * settings.Cells:N0} triangles"));
            Assert.That(SeaFigures.Name(_sea, 3), Is.EqualTo("3 (empty)"));
        }

        [Test]
        public void Check_WhatCannotBeShown_IsSaidAsRebuildSaysIt()
        {
            Assert.That(SeaFigures.Check(_sea), Is.Null);
            _sea.Snapshots.Add(null);
            var refused = Assert.Throws<GlintException>(() => _sea.Rebuild());
            Assert.That(SeaFigures.Check(_sea).Text, Is.EqualTo(refused.Message));
        }

        [Test]
        public void Check_SeaWithoutMaterial_WarnsAndAssignsUnitysOwn()
        {
            _sea.Material = null;
            var finding = SeaFigures.Check(_sea);
            Assert.That(finding.Severity, Is.EqualTo(Severity.Warning));
            Assert.That(finding.Text, Does.StartWith("Sea of 'Sea' has no material"));
            finding.Fix.Apply();
            Assert.That(_sea.Material, Is.EqualTo(ProjectAssets.StandardMaterial));
            Assert.That(_sea.GetComponentInChildren<MeshRenderer>().sharedMaterial != null);
            Assert.That(SeaFigures.Check(_sea), Is.Null);
        }

        string Row(string label) => SeaFigures.Rows(_sea).Single(row => row.label == label).value;
    }
}
