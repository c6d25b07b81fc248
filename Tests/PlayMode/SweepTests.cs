using System.Collections;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>The component that sweeps on play.</summary>
    public sealed class SweepTests
    {
        string _folder;
        Sweep _sweep;
        Transform _target;

        [UnitySetUp]
        public IEnumerator LoadScene()
        {
            _folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            yield return PlayScene.Load("CornerReflector");
            _target = GameObject.Find("Corner Reflector").transform;
            Object.Destroy(Object.FindFirstObjectByType<Sweep>().gameObject);

            var holder = new GameObject("Test sweep");
            holder.SetActive(false);
            _sweep = holder.AddComponent<Sweep>();
            _sweep.Target = _target;
            _sweep.OutputFolder = _folder;
            yield return null;
        }

        [TearDown]
        public void RemoveFolder()
        {
            if (Directory.Exists(_folder))
                Directory.Delete(_folder, true);
        }

        [UnityTest]
        public IEnumerator Play_ThreeAngles_TracesOneAFrameWritesTheFilesAndPutsTheTargetBack()
        {
            _target.rotation = Quaternion.Euler(0, 5, 0);
            var initial = _target.rotation;
            _sweep.Angles = "0,20,40";
            _sweep.gameObject.SetActive(true);
            int frames = 0;
            do
            {
                yield return null;
                frames++;
            }
            while (_sweep.IsRunning && frames < 20);

            Assert.That(frames, Is.InRange(3, 5), "one pose a frame");
            Assert.That((_sweep.PosesDone, _sweep.Poses, _sweep.ResultsPath, _sweep.Problem),
                Is.EqualTo((3, 3, _folder, (string)null)));
            Assert.That(Quaternion.Angle(_target.rotation, initial), Is.LessThan(1e-3f));
            var lines = File.ReadAllLines(Path.Combine(_folder, "results.csv"));
            Assert.That(lines.Length, Is.EqualTo(4));
            Assert.That(lines.Skip(1).Select(line => line.Split(',')[0]), Is.EqualTo(new[] { "0", "20", "40" }));
            Assert.That(File.ReadAllText(Path.Combine(_folder, "results.json")), Does.Contain("Corner Reflector"));
        }

        [UnityTest]
        public IEnumerator Play_RefusedByTheRadar_LeavesTheFolderFree()
        {
            var radar = Object.FindFirstObjectByType<RadarController>();
            var receiver = radar.Receiver;
            radar.Receiver = null;
            LogAssert.Expect(LogType.Error, new Regex("has no receiver"));
            _sweep.Angles = "0";
            _sweep.gameObject.SetActive(true);
            yield return null;
            Assert.That((_sweep.IsRunning, _sweep.Problem), Is.EqualTo((false, radar.HasNoReceiver)));
            radar.Receiver = receiver;
            ResultsFolder.Open(_folder).Dispose();
        }

        /// <summary>Read-backs are done when frames run, one pose a frame while the next one is in flight.</summary>
        [UnityTest]
        public IEnumerator Play_PosesThatOverlap_HaveTheRowsOfPosesOneAtATime()
        {
            var radar = Object.FindFirstObjectByType<RadarController>();
            var settings = radar.Settings;
            (settings.RaysAcross, settings.RaysDown) = (160, 90); // a pose is one slice, whatever the machine does
            radar.Settings = settings;
            _sweep.Angles = "0,10,20,30,40";
            var initial = _target.rotation;
            _sweep.gameObject.SetActive(true);
            int frames = 0, ahead = 0;
            do
            {
                yield return null;
                frames++;
                var next = Quaternion.Euler(0, 10 * _sweep.PosesDone, 0) * initial;
                if (_sweep.IsRunning && Quaternion.Angle(_target.rotation, next) < 0.1f)
                    ahead++;
            }
            while (_sweep.IsRunning && frames < 20);

            Assert.That((frames, _sweep.Problem), Is.EqualTo((5, (string)null)), "one pose a frame");
            Assert.That(ahead, Is.EqualTo(4), "frames after which the scene shows the next pose");
            var rows = File.ReadAllLines(Path.Combine(_folder, "results.csv")).Skip(1)
                .Select(line => double.Parse(line.Split(',')[1], CultureInfo.InvariantCulture)).ToArray();
            for (int i = 0; i < 5; i++)
            {
                _target.rotation = Quaternion.Euler(0, 10 * i, 0) * initial;
                Assert.That(rows[i], Is.EqualTo(radar.Trace(RayReadback.None).Amplitude).Within(1e-9), $"row {i}");
            }
            Assert.That(rows.Distinct().Count(), Is.EqualTo(5), "the poses differ");
        }

        [UnityTest]
        public IEnumerator Play_DistancesAndFrequencies_TracesEachWithEachAndPutsTheRadarBack()
        {
            var radar = Object.FindFirstObjectByType<RadarController>();
            var (position, frequency) = (radar.transform.position, radar.Settings.FrequencyHz);
            (_sweep.Angles, _sweep.Distances, _sweep.Frequencies) = ("", "40,60", "9e9,10e9");
            _sweep.gameObject.SetActive(true);
            for (int frames = 0; frames < 20 && (frames < 2 || _sweep.IsRunning); frames++)
                yield return null;

            var lines = File.ReadAllLines(Path.Combine(_folder, "results.csv"));
            Assert.That(lines[0], Does.EndWith(",range_m,frequency_hz"));
            Assert.That(lines.Skip(1).Select(line => string.Join(" ", line.Split(',').TakeLast(2))),
                Is.EqualTo(new[] { "40 9000000000", "60 9000000000", "40 10000000000", "60 10000000000" }));
            Assert.That(Vector3.Distance(radar.transform.position, position), Is.LessThan(1e-4f));
            Assert.That(radar.Settings.FrequencyHz, Is.EqualTo(frequency));
        }

        [UnityTest]
        public IEnumerator Play_WithoutTarget_SaysSoAndWritesNothing()
        {
            _sweep.Target = null;
            LogAssert.Expect(LogType.Error, new Regex("'Test sweep' has no target"));
            _sweep.gameObject.SetActive(true);
            yield return null;
            yield return null;
            Assert.That(_sweep.Problem, Does.Contain("'Test sweep' has no target"));
            Assert.That(_sweep.IsRunning, Is.False);
            Assert.That(Directory.Exists(_folder), Is.False);
        }

        [UnityTest]
        public IEnumerator Play_MalformedAngles_SaysSoAndWritesNothing()
        {
            _sweep.Angles = "0:45";
            LogAssert.Expect(LogType.Error, new Regex("0:45.*FROM:TO:STEP"));
            _sweep.gameObject.SetActive(true);
            yield return null;
            Assert.That(_sweep.IsRunning, Is.False);
            Assert.That(Directory.Exists(_folder), Is.False);
        }

        [UnityTest]
        public IEnumerator Destroy_OfTheTargetDuringASweep_EndsItWithAnErrorAndKeepsTheRows()
        {
            _sweep.Angles = "10:40:10";
            _sweep.gameObject.SetActive(true);
            yield return null;
            yield return null;
            LogAssert.Expect(LogType.Error, new Regex("target of the sweep was destroyed"));
            Object.Destroy(_target.gameObject);
            yield return null;
            yield return null;
            Assert.That(_sweep.IsRunning, Is.False);
            Assert.That(File.ReadAllLines(Path.Combine(_folder, "results.csv")).Length, Is.InRange(2, 4));
        }

        [UnityTest]
        public IEnumerator Disable_DuringASweep_PutsTheTargetBackAndKeepsTheRows()
        {
            var initial = _target.rotation;
            _sweep.Angles = "10:40:10";
            _sweep.gameObject.SetActive(true);
            yield return null;
            yield return null;
            _sweep.gameObject.SetActive(false);
            Assert.That(Quaternion.Angle(_target.rotation, initial), Is.LessThan(1e-3f));
            Assert.That(_sweep.IsRunning, Is.False);
            Assert.That(File.ReadAllLines(Path.Combine(_folder, "results.csv")).Length, Is.GreaterThanOrEqualTo(2));
        }
    }
}
