using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>
    /// The kernels' cross sections against a table of closed forms, Mie's series and converged integrals of an
    /// independent program: CrossSectionCases.txt, with the columns of <see cref="PublishedRow"/> after the case.
    /// </summary>
    [Category("Slow")]
    public sealed class CrossSectionCaseTests : CrossSectionFixture
    {
        const string Folder = "Packages/com.glint.tests/EditMode/CrossSection/";

        // Part of a row's tolerance that a trace has. It is that of VV and HH; weaker cross-polarised echoes take this one.
        const double PartOfTolerance = 0.6, CrossToleranceDb = 0.005;

        // Stands for no echo at all.
        const double NothingDbsm = -120;

        static readonly Lazy<string[]> s_lines = new Lazy<string[]>(() =>
            AssetDatabase.LoadAssetAtPath<TextAsset>(Folder + "CrossSectionCases.txt").text
                .Split(new[] { '\n', '\r' }, StringSplitOptions.RemoveEmptyEntries).Skip(1).ToArray());

        string _mesh;

        // Known before assets can be loaded.
        static readonly string[] Cases =
        {
            "plate_po", "plate_po_oblique", "plate_bistatic", "plate_forward", "plate_near", "dihedral_plane",
            "dihedral_turned_0", "dihedral_turned_22p5", "dihedral_turned_45", "trihedral_triple",
            "trihedral_triple_cut", "sphere_mie", "sphere_bistatic", "cylinder_broadside", "cylinder_tilted",
            "top_hat_double", "two_plates", "hidden_plate", "plate_pec_layer", "plate_magnetic_layer",
            "plate_half_space", "plate_sea_water", "trihedral_all", "dihedral_100deg", "dihedral_oblique",
            "dihedral_bistatic", "two_plates_bistatic", "plate_edges"
        };

        [TestCaseSource(nameof(Cases)), Timeout(300000)]
        public void Trace_PublishedCase_IsWithinItsTolerance(string name)
        {
            var wrong = new List<string>();
            RadarScene scene = null;
            // Receivers of the same wave share a trace.
            foreach (var wave in RowsOf(name).GroupBy(row => (row.Wave, row.IsCrossPolarised)))
            {
                var receivers = wave.GroupBy(row => row.Receiver).ToArray();
                var pose = wave.First().Pose();
                if (scene == null || !pose.Scene.Surfaces.SequenceEqual(scene.Surfaces) || wave.First().Target != _mesh)
                    (scene, _mesh) = (pose.Scene, wave.First().Target);
                pose.Scene = scene;
                pose.Receivers = receivers.Select(rows => rows.First().ReceiverAspect()).ToArray();
                pose.ToleranceDb = wave.Key.IsCrossPolarised ? CrossToleranceDb
                    : PartOfTolerance * wave.Min(row => row.ToleranceDb);
                var result = Tracer.Trace(pose);
                for (int i = 0; i < receivers.Length; i++)
                    foreach (var row in receivers[i])
                    {
                        var s = PublishedRow.Of(result.S[i, 0], row.Polarisation);
                        double dbsm = Math.Max(NothingDbsm, ScatteringMatrix.Dbsm(s));
                        if (!(Math.Abs(dbsm - row.Dbsm) <= row.ToleranceDb))
                            wrong.Add($"{row}: {dbsm:f3}, error said {result.Errors[i, 0]:g3} m");
                    }
            }
            Assert.That(wrong, Is.Empty);
        }

        // ka = 100: physical optics fails slowly above 90 degrees.
        [Test]
        [Timeout(600000)]
        public void Sphere_BistaticTo120Degrees_IsAboutMie()
        {
            var rows = RowsOf("sphere_bistatic");
            var pose = rows[0].Pose();
            pose.Receivers = rows.Where((_, i) => i % 2 == 0).Select(row => row.ReceiverAspect()).ToArray();
            pose.ToleranceDb = PartOfTolerance * 0.1;
            var result = Tracer.Trace(pose);
            for (int i = 0; i < rows.Length; i++)
            {
                double angle = 15 * (i / 2);
                double dbsm = ScatteringMatrix.Dbsm(PublishedRow.Of(result.S[i / 2, 0], rows[i].Polarisation));
                TestContext.WriteLine(FormattableString.Invariant(
                    $"| {angle} | {rows[i].Polarisation} | {rows[i].Dbsm:0.000} | {dbsm:0.000} | {dbsm - rows[i].Dbsm:+0.000;-0.000} |"));
                Assert.That(dbsm, Is.EqualTo(rows[i].Dbsm)
                    .Within(angle > 90 ? 0.6 : 0.1), $"{rows[i]}");
            }
        }

        [Test, Timeout(60000)]
        public void Cases_AreThoseOfTheTable() =>
            Assert.That(s_lines.Value.Select(line => line.Split(' ')[0]).Distinct(), Is.EqualTo(Cases));

        static PublishedRow[] RowsOf(string name) =>
            s_lines.Value.Where(line => line.StartsWith(name + " ", StringComparison.Ordinal))
                .Select(line => new PublishedRow(line.Substring(name.Length + 1))).ToArray();
    }
}
