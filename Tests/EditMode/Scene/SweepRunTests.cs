using System;
using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using System.Threading;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>A sweep over a plate that turns in front of a wall, pose by pose.</summary>
    [Category("Slow")]
    public sealed class SweepRunTests
    {
        GameObject _wall, _target, _camera;
        RadarController _radar;

        // Rows of a sweep by tubes, one pose at a time: traced once for all tests that compare with them.
        List<string> _rowsOfTubes;

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
            if (_radar != null)
                _radar.Release();
            foreach (var item in new[] { _wall, _target, _camera })
                Object.DestroyImmediate(item);
        }

        [Test]
        public void Step_PosesAfterTheFirst_BuildNoBvhAndUploadNoTriangles()
        {
            using (var run = Sweep(new SweepPlan(new double[] { 0, 3, 40 })))
            {
                var first = run.Step().Result;
                Assert.That(first.Statistics.BvhsBuilt, Is.GreaterThan(0));
                Assert.That(first.RaysReceived, Is.GreaterThan(0));
                while (!run.IsComplete)
                {
                    var result = run.Step().Result;
                    Assert.That(result.Statistics.BvhsBuilt, Is.Zero);
                    Assert.That(result.Statistics.Triangles, Is.EqualTo(4));
                    Assert.That(result.RaysHit, Is.GreaterThan(0));
                }
            }
        }

        [Test]
        public void Step_WhateverTheRadarKeeps_CarriesNoRays()
        {
            _radar.RayReadback = RayReadback.All;
            using (var run = new SweepRun(new SweepSetup(_radar, SweepPlan.Single)))
                Assert.That(run.Step().Result.Rays, Is.Empty);
            Assert.That(_radar.Trace().Rays.Length, Is.EqualTo(160 * 90), "when asked");
            Assert.That(_radar.Trace(RayReadback.None).Rays, Is.Empty);
        }

        [Test]
        public void Step_Cancelled_KeepsTheRowsBeforeAndCanGoOn()
        {
            using (var temporary = new TemporaryFolder())
            using (var cancel = new CancellationTokenSource())
            {
                var folder = ResultsFolder.Open(temporary.PathOf("sweep"));
                using (var run = Sweep(new SweepPlan(new double[] { 0, 10 }), folder))
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

        /// <summary>Any failure within a pose; a lost device throws an exception there.</summary>
        [Test]
        public void Step_ThatFails_LeavesRowsFromWhichTheSweepResumes()
        {
            using (var temporary = new TemporaryFolder())
            {
                var plan = new SweepPlan(new double[] { 0, 10, 20, 30 });
                using (var run = Sweep(plan, ResultsFolder.Open(temporary.PathOf("whole"))))
                    while (!run.IsComplete)
                        run.Step();
                using (var run = Sweep(plan, ResultsFolder.Open(temporary.PathOf("sweep"))))
                {
                    run.Step();
                    run.Step();
                    Assert.Throws<NotSupportedException>(() => run.Step(new Disappearance()));
                }
                Assert.That(_target.transform.rotation, Is.EqualTo(Quaternion.identity), "put back");
                using (var run = Sweep(plan, ResultsFolder.Open(temporary.PathOf("sweep")), true))
                {
                    Assert.That(run.Done, Is.EqualTo(2));
                    run.Step();
                    run.Step();
                    Assert.That(run.IsComplete);
                }
                var (whole, resumed) = (Amplitudes(temporary.PathOf("whole")), Amplitudes(temporary.PathOf("sweep")));
                Assert.That(whole.Length, Is.EqualTo(5));
                Assert.That(resumed, Is.EqualTo(whole));
            }
        }

        // Between two steps the next pose is in flight.
        static readonly Action<RadarController>[] s_between =
        {
            radar => { }, radar => radar.Release(), radar => radar.Trace(RayReadback.All),
            radar => radar.TracePaths(new uint[] { 80 + 45 * 160 }), radar => radar.enabled = !radar.enabled
        };

        [Test]
        public void Step_OfPosesThatOverlap_GivesTheRowsOfOneAtATime([NUnit.Framework.Range(0, 4)] int between)
        {
            var plan = new SweepPlan(new double[] { 0, 1, 2, 3, 4, 20, 40 });
            var expected = RowsOneAtATime(plan);
            var rows = new List<string>();
            int ahead = 0;
            using (var run = Sweep(plan))
            {
                run.PosesAhead = 1;
                while (!run.IsComplete)
                {
                    rows.Add(Describe(run.Step()));
                    double shown = _target.transform.eulerAngles.y;
                    if (!run.IsComplete && Math.Abs(shown - plan[rows.Count].AngleDegrees.Value) < 1e-3)
                        ahead++;
                    s_between[between](_radar);
                }
            }
            Assert.That(rows, Is.EqualTo(expected));
            // On a busy machine a pose may have several slices, which do not overlap with the next pose.
            Assert.That(ahead, Is.GreaterThan(0), "steps after which the scene shows the next pose");
            Assert.That(_target.transform.rotation, Is.EqualTo(Quaternion.identity), "put back");
        }

        List<string> RowsOneAtATime(SweepPlan plan)
        {
            var rows = new List<string>();
            using (var run = Sweep(plan))
                while (!run.IsComplete)
                    rows.Add(Describe(run.Step()));
            return rows;
        }

        void SetTolerance()
        {
            var settings = TestRadar.Settings();
            settings.ToleranceDb = 1;
            (_radar.Settings, _radar.TubeKernel) = (settings, TestKernels.Amplitude);
        }

        [Test]
        public void Step_OfTubes_TracesPosesTogether_AndGivesTheRowsOfOneAtATime([NUnit.Framework.Range(0, 4)] int between)
        {
            var plan = new SweepPlan(new double[] { 0, 1, 2, 3, 4, 20, 40 });
            SetTolerance();
            _rowsOfTubes ??= RowsOneAtATime(plan);
            var rows = new List<string>();
            var shown = new List<double>();
            using (var run = Sweep(plan))
            {
                run.PosesAhead = int.MaxValue;
                while (!run.IsComplete)
                {
                    _radar.Tubes.PosesTogether = 3;
                    rows.Add(Describe(run.Step()));
                    shown.Add(_target.transform.eulerAngles.y);
                    s_between[between](_radar);
                }
            }
            Assert.That(rows, Is.EqualTo(_rowsOfTubes));
            Assert.That(shown[0], Is.EqualTo(2).Within(1e-3), "the scene is two poses ahead");
            if (between == 0)
                Assert.That(shown, Is.EqualTo(new double[] { 2, 2, 2, 20, 20, 20, 40 }).Within(1e-3));
        }

        /// <summary>A pose that cannot be traced does not take those before it along.</summary>
        [Test]
        public void FinishTrace_OfTubesBesideAPoseThatCannotBeTraced_HasItsResult()
        {
            SetTolerance();
            var expected = _radar.Trace();
            var good = _radar.StartTrace(RayReadback.None);
            var bad = _radar.StartTrace(RayReadback.None);
            bad.Pose.Settings.ToleranceDb = 11;
            Assert.That(_radar.FinishTrace(good).InPhase, Is.EqualTo(expected.InPhase));
            Assert.That(() => _radar.FinishTrace(bad), Throws.InstanceOf<GlintException>().With.Message.Contains("tolerance"));
            Assert.That(_radar.IsInFlight(bad), Is.False);
        }

        /// <summary>The scene shows the next pose after a step, unless the paths of this one are drawn.</summary>
        [Test]
        public void Step_WithRayPaths_OverlapsUnlessTheyAreShown([Values] bool areShown)
        {
            var paths = _camera.AddComponent<RayPaths>();
            var ahead = new List<bool>();
            var plan = new SweepPlan(new double[] { 0, 10, 20, 30 });
            using (var run = Sweep(plan))
            {
                run.PosesAhead = 1;
                while (run.Done < 3)
                {
                    if (areShown)
                        Camera.onPreCull(_camera.GetComponent<Camera>());
                    run.Step();
                    ahead.Add(Math.Abs(_target.transform.eulerAngles.y - 10 * run.Done) < 1e-3);
                }
            }
            Assert.That(ahead, Has.All.EqualTo(!areShown));
            Assert.That(paths.IsOutdated, Is.False);
        }

        [Test]
        public void Step_CancelledWhileTheNextPoseIsInFlight_CanGoOnWithTheSameRows([Values] bool ofTubes)
        {
            var plan = new SweepPlan(new double[] { 0, 10, 20, 30, 40 });
            if (ofTubes)
                SetTolerance();
            var expected = RowsOneAtATime(plan);
            var rows = new List<string>();
            using (var cancel = new CancellationTokenSource())
            using (var run = Sweep(plan))
            {
                if (ofTubes)
                    _radar.Tubes.PosesTogether = 2;
                run.PosesAhead = ofTubes ? int.MaxValue : 1;
                rows.Add(Describe(run.Step()));
                rows.Add(Describe(run.Step()));
                cancel.Cancel();
                Assert.That(() => run.Step(null, cancel.Token), Throws.InstanceOf<OperationCanceledException>());
                Assert.That(run.Done, Is.EqualTo(2));
                while (!run.IsComplete)
                    rows.Add(Describe(run.Step()));
            }
            Assert.That(rows, Is.EqualTo(expected));
            Assert.That(_target.transform.rotation, Is.EqualTo(Quaternion.identity), "put back");
        }

        [Test]
        public void Step_AfterTheRadarIsDestroyed_SaysSo()
        {
            using (var run = Sweep(new SweepPlan(new double[] { 0, 10 })))
            {
                run.Step();
                Object.DestroyImmediate(_camera);
                Assert.That(() => run.Step(), Throws.TypeOf<GlintException>().With.Message.Contains("was destroyed"));
            }
        }

        // What is traced in the first pose is the same; later ones are not.
        [Test]
        public void Identity_OfATargetWithAnotherPivot_IsAnother()
        {
            var pivot = new GameObject("Pivot").transform;
            _target.transform.SetParent(pivot);
            _radar.Roots.Add(pivot);
            var setup = new SweepSetup(_radar, new SweepPlan(new double[] { 0, 10 })) { Target = pivot };
            var before = RunDescription.IdentityOf(setup);
            Assert.That(RunDescription.IdentityOf(setup).DifferenceFrom(before), Is.Null);
            pivot.position += Vector3.right;
            _target.transform.position -= Vector3.right;
            Assert.That(RunDescription.IdentityOf(setup).DifferenceFrom(before), Does.StartWith("target_place was \"Pivot at 0,0,0"));
            _target.transform.SetParent(null);
            Object.DestroyImmediate(pivot.gameObject);
        }

        static readonly Action<RadarController, PoseInFlight>[] s_ends =
        {
            (radar, pose) => radar.Release(), (radar, pose) => radar.enabled = false,
            (radar, pose) => Object.DestroyImmediate(radar), (radar, pose) => radar.Abandon(pose)
        };

        // A read-back whose buffer is released before it is done has an error. Domain reload disables the component.
        [Test]
        public void Release_OfAPoseInFlight_WaitsForItsReadback([NUnit.Framework.Range(0, 3)] int end)
        {
            var pose = _radar.StartTrace(RayReadback.None);
            s_ends[end](_radar, pose);
            Assert.That(pose.Slice.Wait().Length, Is.GreaterThan(WorkCounts.First));
        }

        [Test]
        public void Step_ThatKeepsRaysAfterOneThatOverlapped_CarriesThem()
        {
            using (var run = Sweep(new SweepPlan(new double[] { 0, 10, 20 })))
            {
                run.PosesAhead = 1;
                run.Step();
                Assert.That(run.Step(readback: RayReadback.All).Result.Rays.Length, Is.EqualTo(160 * 90));
                Assert.That(run.Step().Result.Rays, Is.Empty);
            }
        }

        [Test]
        public void Step_WhileAScriptListens_LeavesTheSceneAsTraced()
        {
            var angles = new List<float>();
            _radar.Traced += radar => angles.Add(_target.transform.eulerAngles.y);
            using (var run = Sweep(new SweepPlan(new double[] { 0, 10, 20 })))
            {
                run.PosesAhead = 1;
                while (!run.IsComplete)
                    run.Step();
            }
            Assert.That(angles, Is.EqualTo(new[] { 0f, 10, 20 }).Within(1e-3f));
        }

        static string Describe(SweepRow row) => FormattableString.Invariant(
            $"{row.Pose}: {row.Result.InPhase:r} {row.Result.Quadrature:r} {row.Result.RaysHit} {row.Result.SamplingError:r}");

        static string[] Amplitudes(string folder) => Array.ConvertAll(
            File.ReadAllLines(Path.Combine(folder, "results.csv")), line => string.Join(",", line.Split(','), 0, 5));

        sealed class Disappearance : IProgress<double>
        {
            public void Report(double value) => throw new NotSupportedException("the device is gone");
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
            var whole = _radar.Trace(RayReadback.All);
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
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message,
                Does.Contain("region 130,0,37,21"));
        }

        [Test]
        public void Dispose_WhenASnapshotIsGone_SaysSoAndPutsTheRestBack()
        {
            var sea = new GameObject("Sea").AddComponent<Sea>();
            try
            {
                sea.transform.SetParent(_wall.transform, false);
                sea.Extent = new Vector2(1, 1);
                var snapshot = new GameObject("Snapshot").AddComponent<SeaSnapshot>();
                snapshot.transform.SetParent(sea.transform);
                snapshot.Set(SceneBuilder.Mesh(1, 1), SeaSettings.Default, 0, 0);
                sea.Snapshots.Add(snapshot);
                sea.Snapshot = 1;
                double frequency = _radar.Settings.FrequencyHz;
                var plan = new SweepPlan(axis => axis == SweepAxis.Snapshot ? new double[] { 1 }
                    : axis == SweepAxis.Frequency ? new[] { 5e9 } : null);
                var run = new SweepRun(new SweepSetup(_radar, plan) { Sea = sea });
                run.Step();
                Assert.That(_radar.Settings.FrequencyHz, Is.EqualTo(5e9));
                sea.Snapshots.Clear();
                LogAssert.Expect(LogType.Error, new Regex("not as it was before the sweep: .*has no snapshots"));
                run.Dispose();
                Assert.That(_radar.Settings.FrequencyHz, Is.EqualTo(frequency));
            }
            finally
            {
                Object.DestroyImmediate(sea.gameObject);
            }
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
                    snapshot.Set(SceneBuilder.Mesh(triangles, triangles), SeaSettings.Default, 0, 0);
                    sea.Snapshots.Add(snapshot);
                }
                sea.Snapshot = 2;
                var counts = new List<(int?, long)>();
                using (var run =
                    new SweepRun(new SweepSetup(_radar, new SweepPlan(null, new[] { 3, 1 })) { Sea = sea }))
                    while (!run.IsComplete)
                    {
                        var row = run.Step();
                        counts.Add((row.Pose.Snapshot, row.Result.Statistics.Triangles));
                    }
                long others = counts[1].Item2 - 1;
                Assert.That(counts, Is.EqualTo(new (int?, long)[] { (3, others + 3), (1, others + 1) }));
                Assert.That(sea.Snapshot, Is.EqualTo(2));
                Assert.Throws<GlintException>(
                    () => new SweepRun(new SweepSetup(_radar, new SweepPlan(null, new[] { 1, 4 })) { Sea = sea }),
                    "before any pose");
            }
            finally
            {
                Object.DestroyImmediate(sea.gameObject);
            }
        }

        [Test]
        public void Step_OverGrazingAnglesAndRanges_MovesTheRadarAboutThePointItLooksAt()
        {
            var owner = new GameObject("Owner").transform;
            try
            {
                owner.SetPositionAndRotation(new Vector3(3, 1, -2), Quaternion.Euler(0, 90, 0));
                _camera.transform.SetParent(owner, false);
                _camera.transform.localRotation = Quaternion.Euler(10, 0, 5);
                // Half a metre off the axis, which is 20 m long there.
                _target.transform.position = _camera.transform.TransformPoint(new Vector3(0.3f, -0.4f, 20));
                var aim = _camera.transform.TransformPoint(new Vector3(0, 0, 20));
                var (position, rotation) = (_camera.transform.localPosition, _camera.transform.localRotation);
                var plan = new SweepPlan((SweepAxis.Grazing, new double[] { 10, -30, 80 }),
                    (SweepAxis.Range, new double[] { 20, 4000 }));
                using (var run = Sweep(plan))
                    while (!run.IsComplete)
                    {
                        var pose = run.Step().Pose;
                        double grazing = pose[SweepAxis.Grazing].Value * Math.PI / 180,
                            range = pose[SweepAxis.Range].Value;
                        var forward = new Vector3((float)Math.Cos(grazing), -(float)Math.Sin(grazing), 0);
                        Assert.That(Vector3.Distance(_camera.transform.forward, forward),
                            Is.LessThan(1e-5), pose.ToString());
                        Assert.That(Vector3.Distance(_camera.transform.position, aim - (float)range * forward),
                            Is.LessThan(1e-5 * range), pose.ToString());
                        Assert.That(Vector3.Angle(_camera.transform.right, Quaternion.AngleAxis(90, Vector3.up)
                                * Quaternion.Euler((float)pose[SweepAxis.Grazing].Value, 0, 5) * Vector3.right),
                            Is.LessThan(0.1), "tilted as it was");
                        Assert.That(
                            Vector3.Distance(_radar.Receiver.position, _camera.transform.position - 0.2f * forward),
                            Is.LessThan(1e-5 * range + 1e-4), "the receiver moves with it");
                    }
                Assert.That(
                    (_camera.transform.parent, _camera.transform.localPosition, _camera.transform.localRotation),
                    Is.EqualTo((owner, position, rotation)));
                Assert.That(owner.childCount, Is.EqualTo(1));
            }
            finally
            {
                _camera.transform.SetParent(null);
                Object.DestroyImmediate(owner.gameObject);
            }
        }

        [Test]
        public void Step_OverRangesOnly_LeavesTheDirection()
        {
            var rotation = Quaternion.Euler(1, 2, 3);
            _camera.transform.rotation = rotation;
            using (var run = Sweep(new SweepPlan((SweepAxis.Range, new double[] { 7, 70 }))))
                while (!run.IsComplete)
                {
                    run.Step();
                    Assert.That(_camera.transform.rotation, Is.EqualTo(rotation));
                }
        }

        [Test]
        public void Step_OverFrequencies_GivesWhatARadarOfEachReceives()
        {
            var alone = new List<(double, double)>();
            foreach (double frequency in new[] { 9e9, 9.5e9 })
            {
                SetFrequency(frequency);
                alone.Add((_radar.Trace().InPhase, _radar.Result.Quadrature));
            }
            Assert.That(alone[0], Is.Not.EqualTo(alone[1]));
            SetFrequency(3e9);
            var swept = new List<(double, double)>();
            using (var run = Sweep(new SweepPlan((SweepAxis.Frequency, new[] { 9e9, 9.5e9 }))))
                while (!run.IsComplete)
                    swept.Add((run.Step().Result.InPhase, _radar.Result.Quadrature));
            Assert.That(swept, Is.EqualTo(alone));
            Assert.That(_radar.Settings.FrequencyHz, Is.EqualTo(3e9));
        }

        [Test]
        public void Sweep_OfARadarThatCannotBeMoved_IsRefusedWithTheWayOut()
        {
            _camera.transform.rotation = Quaternion.Euler(0, 180, 0);
            AssertUnmovable("'Target', which is not before it: turn the radar");
            _camera.transform.SetPositionAndRotation(new Vector3(0, 50, 20), Quaternion.Euler(90, 0, 0));
            AssertUnmovable("looks straight down");
            _radar.Receiver.SetParent(_wall.transform);
            AssertUnmovable("its receiver 'Receiver' would stay behind");
            _radar.Receiver.SetParent(_camera.transform);
            _camera.transform.SetParent(_wall.transform);
            AssertUnmovable("'Wall', above it, is scaled");
            _camera.transform.SetParent(_target.transform);
            AssertUnmovable("one is below the other");
            _camera.transform.SetParent(null);
        }

        void AssertUnmovable(string part) => Assert.That(
            Assert.Throws<GlintException>(() => Sweep(new SweepPlan((SweepAxis.Grazing, new double[] { 1 })))).Message,
            Does.StartWith("RadarController of 'Radar'").And.Contain(part).And.Not.Contain("\n"));

        SweepRun Sweep(SweepPlan plan, ResultsFolder folder = null, bool resume = false) =>
            new SweepRun(new SweepSetup(_radar, plan) { Target = _target.transform, Scene = "Scene" },
                folder, null, resume);

        void SetFrequency(double hertz)
        {
            var settings = _radar.Settings;
            settings.FrequencyHz = hertz;
            _radar.Settings = settings;
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
