using System.IO;
using System.Linq;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Checks of a RadarCrossSection before it runs, and its figures.</summary>
    public sealed class CrossSectionCheckTests
    {
        RadarCrossSection _radar;
        CrossSectionCheck _check;

        [SetUp]
        public void MakeScene()
        {
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
            var plate = GameObject.CreatePrimitive(PrimitiveType.Quad).transform;
            plate.localScale = new Vector3(0.3f, 0.2f, 1);
            _radar = SceneObjects.MakeCrossSection(plate.gameObject);
            _check = new CrossSectionCheck(_radar);
        }

        // A plate of 0.3 x 0.2 m: sqrt(0.13) / 2 = 0.1803 m, and 10 log10(pi 0.13 / 4) - 40 = -49.91 dBsm.
        [Test]
        public void Update_APlate_HasItsFigures()
        {
            (_radar.Azimuths, _radar.Elevations, _radar.Frequencies) = ("0:90:30", "0,10,20", "9e9,10e9");
            Assert.That(Findings(), Is.Empty);
            Assert.That(_check.Figures().Select(row => row.value),
                Is.EqualTo(new[] { "24", "2 triangles, 1 objects, radius 0.1803 m", "-49.91 dBsm" }));
            (_radar.Elevations, _radar.Receiver) = ("10", CrossSectionReceiver.Sweep);
            _radar.ReceiverAzimuths = "0:90:10";
            _check.Update();
            Assert.That(_check.Figures().First().value, Is.EqualTo("80"), "with every receiver");
            _radar.FloorDbsm = -30;
            _check.Update();
            Assert.That(_check.Figures().Last().value, Is.EqualTo("-30.00 dBsm"));
        }

        [Test]
        public void Update_InvalidList_SaysWhyAndHasNoFigures()
        {
            _radar.Frequencies = "10 GHz";
            Assert.That(Findings().Single(),
                Does.StartWith("Error: RadarCrossSection of 'Cross Section': frequencies \"10 GHz\": "));
            Assert.That(_check.Figures(), Is.Empty);
        }

        [Test]
        public void Update_EmptySceneOrTarget_IsFound()
        {
            _radar.Target.gameObject.SetActive(false);
            Assert.That(Findings().Single(), Does.Contain("its target 'Quad' has no triangles"));
            _radar.Target = null;
            Assert.That(Findings().Single(), Does.Contain("the loaded scenes have no triangles"));
        }

        [Test]
        public void Update_Disabled_IsFound()
        {
            _radar.enabled = false;
            Assert.That(Findings().Single(), Is.EqualTo(
                "Warning: RadarCrossSection of 'Cross Section' is disabled or inactive; enable it"));
        }

        [Test]
        public void Fix_WithoutKernel_AssignsItUntilUndone()
        {
            _radar.Kernel = null;
            Assert.That(Findings().Single(), Does.EndWith("Shaders/Tubes.compute"));
            Undo.IncrementCurrentGroup();
            _check.Findings[0].Fix.Apply();
            Assert.That(Findings(), Is.Empty);
            Undo.PerformUndo();
            Assert.That(Findings(), Has.Exactly(1).Items);
        }

        [Test]
        public void Results_OfARun_NameTheLargestOfEachPolarisation()
        {
            Assert.That(CrossSectionCheck.Results(_radar), Is.Empty);
            (_radar.Azimuths, _radar.ToleranceDb) = ("0,40", 0.1);
            _radar.OutputFolder = Path.Combine(Path.GetTempPath(),
                Path.GetRandomFileName());
            try
            {
                _radar.Run();
                while (_radar.IsRunning)
                    _radar.Step();
                var rows = CrossSectionCheck.Results(_radar).ToArray();
                Assert.That(rows.Select(row => row.label), Is.EqualTo(new[] { "Largest VV", "Largest HH", "Largest error" }));
                // 4 pi (0.06 / 0.03)^2 is 17 dBsm.
                Assert.That(rows[0].value, Does.Match(@"^1[67]\.[0-9]{2} dBsm at azimuth 0 deg, elevation 0 deg, "));
                Assert.That(rows[2].value, Does.EndWith("dB, tolerance met in 2 of 2 rows"));

                (_radar.Azimuths, _radar.Receiver) = ("0", CrossSectionReceiver.Sweep);
                _radar.ReceiverAzimuths = "0,125,150";
                _radar.Run();
                while (_radar.IsRunning)
                    _radar.Step();
                rows = CrossSectionCheck.Results(_radar).ToArray();
                Assert.That(rows[0].value, Does.Contain("azimuth 0 deg").And.EndWith("received at 0 deg, 0 deg"));
                Assert.That((rows[3].label, rows[3].value), Is.EqualTo(("Outside physical optics", "2 of 3 rows")));
            }
            finally
            {
                Directory.Delete(_radar.OutputFolder, true);
            }
        }

        string[] Findings()
        {
            _check.Update();
            return _check.Findings.Select(finding => finding.ToString()).ToArray();
        }
    }
}
