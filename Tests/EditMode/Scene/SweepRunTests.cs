using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>A sweep over a plate that turns in front of a wall, pose by pose.</summary>
    public sealed class SweepRunTests
    {
        GameObject _wall, _target, _camera;
        RadarController _radar;

        [SetUp]
        public void MakeScene()
        {
            _wall = Plate("Wall", 30, 40);
            _target = Plate("Target", 4, 20);
            _camera = new GameObject("Radar", typeof(Camera));
            _camera.GetComponent<Camera>().fieldOfView = 30;
            var receiver = new GameObject("Receiver").transform;
            receiver.SetParent(_camera.transform);
            receiver.localPosition = new Vector3(0, 0, -0.2f);
            _radar = _camera.AddComponent<RadarController>();
            _radar.Settings = TestRadar.Settings();
            _radar.Receiver = receiver;
            _radar.Kernel = TestKernels.Trace;
            _radar.Roots.AddRange(new[] { _wall.transform, _target.transform });
        }

        [TearDown]
        public void RemoveScene()
        {
            _radar.Release();
            foreach (var item in new[] { _wall, _target, _camera })
                Object.DestroyImmediate(item);
        }

        [Test]
        public void Step_PosesAfterTheFirst_BuildNoTreeAndUploadNoTriangles()
        {
            using (var run = new SweepRun(_radar, new SweepPlan(new double[] { 0, 3, 40 }), _target.transform, null, "Scene", null))
            {
                var first = run.Step().Result;
                Assert.That(first.Work.TreesBuilt, Is.GreaterThan(0));
                Assert.That(first.RaysReceived, Is.GreaterThan(0));
                while (!run.IsComplete)
                {
                    var result = run.Step().Result;
                    Assert.That(result.Work.TreesBuilt, Is.Zero);
                    Assert.That(result.Triangles, Is.EqualTo(4));
                    Assert.That(result.RaysHit, Is.GreaterThan(0));
                }
            }
        }

        [Test]
        public void Step_WhateverTheRadarKeeps_CarriesNoRays()
        {
            _radar.KeptRays = KeptRays.All;
            using (var run = new SweepRun(_radar, SweepPlan.Single, null, null, "Scene", null))
                Assert.That(run.Step().Result.Rays, Is.Empty);
            Assert.That(_radar.Trace().Rays.Length, Is.EqualTo(160 * 90), "when asked");
            Assert.That(_radar.Trace(KeptRays.None).Rays, Is.Empty);
        }

        [Test]
        public void Step_Cancelled_KeepsTheRowsBeforeAndCanGoOn()
        {
            using (var temporary = new TemporaryFolder())
            using (var cancel = new CancellationTokenSource())
            {
                var folder = ResultsFolder.Open(temporary.PathOf("sweep"));
                using (var run = new SweepRun(_radar, new SweepPlan(new double[] { 0, 10 }), _target.transform, null, "Scene", folder))
                {
                    run.Step();
                    var before = _radar.Result;
                    cancel.Cancel();
                    Assert.That(() => run.Step(null, cancel.Token), Throws.InstanceOf<OperationCanceledException>());
                    Assert.That(run.Done, Is.EqualTo(1));
                    Assert.That(_radar.Result, Is.SameAs(before));
                    Assert.That(File.ReadAllLines(folder.CsvPath).Length, Is.EqualTo(2), "header and a row");
                    run.Step();
                    Assert.That(run.IsComplete);
                }
                Assert.That(File.ReadAllLines(folder.CsvPath).Length, Is.EqualTo(3));
            }
        }

        [Test]
        public void Trace_WithProgress_EndsAtOne()
        {
            var progress = new Reports();
            _radar.Trace(progress);
            Assert.That(progress.Values, Is.Not.Empty.And.Ordered);
            Assert.That(progress.Values[progress.Values.Count - 1], Is.EqualTo(1));
        }

        [Test]
        public void Settings_Region_IsKeptAndTraced()
        {
            var whole = _radar.Trace(KeptRays.All);
            var settings = TestRadar.Settings();
            settings.Region = new RayRegion { Left = 60, Bottom = 30, Width = 37, Height = 21 };
            _radar.Settings = settings;
            Assert.That(_radar.Settings, Is.EqualTo(settings));
            var part = _radar.Trace();
            Assert.That(part.RaysEmitted, Is.EqualTo(37 * 21));
            int received = 0;
            foreach (var ray in whole.Rays)
            {
                int x = (int)ray.Pixel % 160 - 60, y = (int)ray.Pixel / 160 - 30;
                received += ray.IsReceived && x >= 0 && x < 37 && y >= 0 && y < 21 ? 1 : 0;
            }
            Assert.That(received, Is.GreaterThan(0));
            Assert.That(part.RaysReceived, Is.EqualTo(received));

            settings.Region = new RayRegion { Left = 130, Bottom = 0, Width = 37, Height = 21 };
            _radar.Settings = settings;
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message, Does.Contain("region 130,0,37,21"));
        }

        [Test]
        public void Step_OverSnapshots_ShowsEachAndPutsTheFirstBack()
        {
            var sea = new GameObject("Sea").AddComponent<Sea>();
            try
            {
                sea.transform.SetParent(_wall.transform, false);
                sea.transform.localPosition = new Vector3(0, -20, 0);
                sea.Extent = new Vector2(1, 1);
                for (int triangles = 1; triangles <= 3; triangles++)
                {
                    var snapshot = new GameObject("Snapshot").AddComponent<SeaSnapshot>();
                    snapshot.transform.SetParent(sea.transform);
                    (snapshot.Settings, snapshot.Tile) = (SeaSettings.Default, SceneBuilder.Mesh(triangles, triangles));
                    sea.Snapshots.Add(snapshot);
                }
                sea.Snapshot = 2;
                var counts = new List<(int?, long)>();
                using (var run = new SweepRun(_radar, new SweepPlan(null, new[] { 3, 1 }), null, sea, "Scene", null))
                    while (!run.IsComplete)
                    {
                        var row = run.Step();
                        counts.Add((row.Pose.Snapshot, row.Result.Triangles));
                    }
                long others = counts[1].Item2 - 1;
                Assert.That(counts, Is.EqualTo(new (int?, long)[] { (3, others + 3), (1, others + 1) }));
                Assert.That(sea.Snapshot, Is.EqualTo(2));
                Assert.Throws<GlintException>(() => new SweepRun(_radar, new SweepPlan(null, new[] { 1, 4 }), null, sea, "Scene", null), "before any pose");
            }
            finally
            {
                Object.DestroyImmediate(sea.gameObject);
            }
        }

        static GameObject Plate(string name, float side, float distance)
        {
            var plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
            plate.name = name;
            plate.transform.position = new Vector3(0, 0, distance);
            plate.transform.localScale = new Vector3(side, side, 1);
            return plate;
        }

        sealed class Reports : IProgress<double>
        {
            public readonly List<double> Values = new List<double>();

            public void Report(double value) => Values.Add(value);
        }
    }
}
