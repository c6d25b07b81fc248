using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Checks of a Sweep before it is played.</summary>
    public sealed class SweepCheckTests
    {
        Sweep _sweep;
        Transform _target;
        SweepCheck _check;

        [SetUp]
        public void MakeScene()
        {
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
            _target = new GameObject("Target").transform;
            _sweep = new GameObject("Sweep").AddComponent<Sweep>();
            (_sweep.Target, _sweep.Angles) = (_target, "0:45:1");
            _check = new SweepCheck(_sweep);
        }

        [Test]
        public void Update_OneRadar_CountsThePoses()
        {
            AddRadar("Radar");
            Assert.That(Findings(), Is.Empty);
            Assert.That(_check.Plan.Count, Is.EqualTo(46));
            Assert.That(_check.Rows().Single().value, Is.EqualTo("46"));
        }

        [TestCase("0:45:x", "step x")]
        [TestCase("", "no angles")]
        [TestCase("0:4000:1", "4000")]
        public void Update_AnglesThatAreNone_SaysWhy(string angles, string text)
        {
            AddRadar("Radar");
            _sweep.Angles = angles;
            var refused = Assert.Throws<UsageException>(() => SweepAxis.Angle.Parse(angles));
            Assert.That(Findings().Single(), Is.EqualTo("Error: " + refused.Message));
            Assert.That(_check.Plan, Is.Null);
        }

        [Test]
        public void Update_NeitherTargetNorSnapshots_IsFound()
        {
            AddRadar("Radar");
            _sweep.Target = null;
            Assert.That(Findings().Single(), Does.StartWith("Error: Sweep of 'Sweep' has no target and no snapshots"));
        }

        [Test]
        public void Update_SeveralLists_CountsEveryValueWithEveryOther()
        {
            AddRadar("Radar");
            (_sweep.Angles, _sweep.GrazingAngles, _sweep.Distances, _sweep.Frequencies) =
                ("0:10:5", "5,10", "50,60,70", "9e9,10e9");
            Assert.That(Findings(), Is.Empty);
            Assert.That(_check.Plan.Count, Is.EqualTo(3 * 2 * 3 * 2));
            _sweep.Angles = "";
            Assert.That(Findings(), Is.Empty, "the target is not turned");
            Assert.That(_check.Plan.Count, Is.EqualTo(2 * 3 * 2));
            _sweep.Frequencies = "10 GHz";
            Assert.That(Findings().Single(), Does.StartWith("Error: frequencies \"10 GHz\": "));
        }

        [Test]
        public void Update_RadarToBeMovedAboutNoTarget_IsFound()
        {
            AddRadar("Radar");
            (_sweep.Target, _sweep.Distances) = (null, "50,60");
            Assert.That(Findings().Single(),
                Does.StartWith("Error: Sweep of 'Sweep' has grazing angles or distances and no target"));
            (_sweep.Distances, _sweep.Frequencies) = ("", "9e9,10e9");
            Assert.That(Findings(), Is.Empty);
            Assert.That(_check.Plan.Count, Is.EqualTo(2));
        }

        [Test]
        public void Update_SnapshotsOfNoSea_IsFound()
        {
            AddRadar("Radar");
            _sweep.Snapshots = "1:3";
            Assert.That(Findings().Single(), Does.Contain("has no Sea component"));
            new GameObject("Sea").AddComponent<Sea>();
            Assert.That(Findings().Single(), Does.Contain("Sea of 'Sea' has no snapshots"));
        }

        [Test]
        public void Fix_WithoutRadar_MakesOneThatLooksAtTheTarget()
        {
            Assert.That(Findings().Single(), Does.Contain("has no radar"));
            _check.Findings[0].Fix.Apply();
            Assert.That(Findings(), Is.Empty);
            Undo.PerformUndo();
            Assert.That(Findings(), Has.Exactly(1).Items);
        }

        [Test]
        public void Fix_WithSeveralRadars_TakesAnEnabledOne()
        {
            AddRadar("Off").enabled = false;
            var radar = AddRadar("First");
            AddRadar("Second");
            Assert.That(Findings().Single(), Does.Contain("has 2 radars"));
            _check.Findings[0].Fix.Apply();
            Assert.That(_sweep.Radar == radar || _sweep.Radar.name == "Second");
            Assert.That(Findings(), Is.Empty);
        }

        string[] Findings()
        {
            _check.Update();
            return _check.Findings.Select(finding => finding.ToString()).ToArray();
        }

        static RadarController AddRadar(string name) =>
            new GameObject(name, typeof(Camera)).AddComponent<RadarController>();
    }
}
