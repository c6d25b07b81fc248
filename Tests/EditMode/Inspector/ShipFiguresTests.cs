using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>A ship's mesh, rebuilt from its measures.</summary>
    public sealed class ShipFiguresTests
    {
        Ship _ship;

        [SetUp]
        public void MakeShip()
        {
            _ship = SceneObjects.MakeShip(null);
            Undo.ClearAll();
        }

        [TearDown]
        public void RemoveShip() => Object.DestroyImmediate(_ship.gameObject);

        [Test]
        public void Measures_NameEveryFieldThatCanBeSet_WithALabelAndATooltip()
        {
            var fields = typeof(ShipSettings).GetFields(BindingFlags.Public | BindingFlags.Instance)
                .Select(field => field.Name);
            Assert.That(ShipSettings.Measures.Select(it => it.Row.field), Is.EqualTo(fields));
            Assert.That(ShipSettings.Measures.Select(it => it.Row),
                Has.All.Matches<(string field, string label, string tooltip)>(
                it => it.label.Length > 0 && it.tooltip.EndsWith(".")));
        }

        [Test]
        public void Measures_EachOfThem_HaveTheValueOfTheirField()
        {
            CheckValues(default(ShipSettings), ShipSettings.Measures);
            CheckValues(default(SeaSettings), SeaSettings.Measures);
        }

        // Each field in turn is the only one that is not 0.
        static void CheckValues(object settings, IReadOnlyList<Measure> measures)
        {
            foreach (var set in measures)
            {
                var field = settings.GetType().GetField(set.Field);
                field.SetValue(settings, Convert.ChangeType(7, field.FieldType));
                Assert.That(measures.Where(measure => measure.Of(settings) == 7), Is.EqualTo(new[] { set }), set.Field);
                field.SetValue(settings, Convert.ChangeType(0, field.FieldType));
            }
        }

        [Test]
        public void Remake_FromOtherMeasures_IsThatShipAndUndoBringsTheOneBeforeBack()
        {
            var before = Mesh;
            var measures = ShipSettings.Default;
            measures.Length = 70;
            _ship.Settings = measures;
            ShipFigures.Remake(_ship).Apply();

            Assert.That(Mesh, Is.Not.SameAs(before));
            Assert.That(Mesh.bounds.size.z, Is.EqualTo(70).Within(0.5));
            Assert.That(ShipFigures.Rows(_ship).Single().value,
                Does.Contain($"{ShipModel.Build(measures).TriangleCount:N0} triangles"));
            Undo.PerformUndo();
            Assert.That(Mesh, Is.SameAs(before));
        }

        [Test]
        public void Check_MeasuresThatMakeNoShip_IsSaidAsTheModelSaysIt()
        {
            Assert.That(ShipFigures.Check(_ship), Is.Null);
            var measures = ShipSettings.Default;
            measures.Length = 10;
            _ship.Settings = measures;
            var refused = Assert.Throws<GlintException>(() => ShipModel.Build(measures));
            Assert.That(ShipFigures.Check(_ship).Text, Is.EqualTo(refused.Message));
        }

        Mesh Mesh => _ship.GetComponent<MeshFilter>().sharedMesh;
    }
}
