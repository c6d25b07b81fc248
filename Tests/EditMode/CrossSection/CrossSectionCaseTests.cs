using System;
using System.Collections.Generic;
using System.Diagnostics;
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

        /// <summary>Part of a row's tolerance that a trace has.</summary>
        public const double PartOfTolerance = 0.6;

        static readonly Lazy<string[]> s_lines = new Lazy<string[]>(() =>
            AssetDatabase.LoadAssetAtPath<TextAsset>(Folder + "CrossSectionCases.txt").text
                .Split(new[] { '\n', '\r' }, StringSplitOptions.RemoveEmptyEntries).Skip(1).ToArray());

        // With it the page is written, when all cases have been traced, and not compared.
        static readonly bool s_writes = Environment.GetEnvironmentVariable("GLINT_WRITE_PAGES") != null;

        readonly List<CrossSectionCaseRow> _traced = new List<CrossSectionCaseRow>();

        string _mesh;

        static IEnumerable<string> Cases => CrossSectionCasePage.Cases.Select(each => each.Name);

        [TestCaseSource(nameof(Cases)), Timeout(300000)]
        public void Trace_PublishedCase_IsWithinItsTolerance(string name)
        {
            RadarScene scene = null;
            var published = RowsOf(name);
            var traced = new List<CrossSectionCaseRow>();
            // Receivers of the same wave share a trace.
            foreach (var wave in published.GroupBy(row => (row.Wave, row.Polarisation.IsCross)))
            {
                var receivers = wave.GroupBy(row => row.Receiver).ToArray();
                var pose = wave.First().Pose();
                if (scene == null || !pose.Scene.Surfaces.SequenceEqual(scene.Surfaces) || wave.First().Target != _mesh)
                    (scene, _mesh) = (pose.Scene, wave.First().Target);
                pose.Scene = scene;
                pose.Receivers = receivers.Select(rows => rows.First().ReceiverAspect()).ToArray();
                pose.Polarisations = Polarisation.All.Intersect(wave.Select(row => row.Polarisation)).ToArray();
                pose.ToleranceDb = PartOfTolerance * wave.Min(row => row.ToleranceDb);
                var result = Trace(pose, out double milliseconds);
                var errors = wave.Key.IsCross ? result.CrossErrors : result.Errors;
                for (int i = 0; i < receivers.Length; i++)
                    traced.AddRange(receivers[i].Select(row => new CrossSectionCaseRow(name, row,
                        row.Polarisation.Of(result.S[i, 0]), errors[i, 0], result, milliseconds)));
            }
            _traced.AddRange(traced.OrderBy(row => Array.IndexOf(published, row.Row)));
            Assert.That(traced.Where(row => !row.IsWithinTolerance), Is.Empty);
            if (!s_writes)
                CrossSectionCasePage.AssertHas(traced);
        }

        // For the page a pose is timed when its scene is on the device.
        CrossSectionResult Trace(CrossSectionPose pose, out double milliseconds)
        {
            if (s_writes)
                Tracer.Trace(pose);
            var watch = Stopwatch.StartNew();
            var result = Tracer.Trace(pose);
            milliseconds = watch.Elapsed.TotalMilliseconds;
            return result;
        }

        [OneTimeTearDown]
        public void WritePage()
        {
            if (s_writes)
                CrossSectionCasePage.Write(_traced.OrderBy(row => Array.IndexOf(Cases.ToArray(), row.Case)).ToArray());
        }

        [Test, Timeout(60000)]
        public void Page_HasEveryRowOfTheTable()
        {
            if (!s_writes)
                CrossSectionCasePage.AssertHasRows(Cases.Select(name => (name, RowsOf(name))));
        }

        // ka = 100: physical optics fails slowly above 90 degrees.
        [Test]
        [Timeout(600000)]
        public void Sphere_BistaticTo120Degrees_IsAboutMie()
        {
            var rows = RowsOf("sphere_bistatic").Where((_, i) => i % 4 < 2).ToArray();
            var pose = rows[0].Pose();
            pose.Receivers = rows.Where((_, i) => i % 2 == 0).Select(row => row.ReceiverAspect()).ToArray();
            pose.ToleranceDb = PartOfTolerance * 0.1;
            var result = Tracer.Trace(pose);
            for (int i = 0; i < rows.Length; i++)
            {
                double angle = 30 * (i / 2);
                double dbsm = ScatteringMatrix.Dbsm(rows[i].Polarisation.Of(result.S[i / 2, 0]));
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
