using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.RegularExpressions;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>The component that computes cross sections on play, in Scenes/CrossSection.unity.</summary>
    [Category("Slow")]
    public sealed class RadarCrossSectionTests
    {
        // Of each plate of the scene's dihedral, metres; of the default frequency.
        const double Width = 0.3, Height = 0.2, Wavelength = Signal.SpeedOfLight / 10e9;

        const int MaxFrames = 400;

        string _folder;
        RadarCrossSection _radar;

        [UnitySetUp]
        public IEnumerator LoadScene()
        {
            _folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            yield return PlayScene.Load("CrossSection");
            _radar = Object.FindFirstObjectByType<RadarCrossSection>(FindObjectsInactive.Include);
            _radar.OutputFolder = _folder;
        }

        [TearDown]
        public void RemoveFolder()
        {
            if (Directory.Exists(_folder))
                Directory.Delete(_folder, true);
        }

        /// <summary>A dihedral of two plates that meet at x = z = 0 and open towards -Z.</summary>
        [UnityTest]
        [Timeout(180000)]
        public IEnumerator Play_TheScene_ComputesACircleOfItsDihedralAndWritesTheFiles()
        {
            // Cancel_ByAListener has the rows of the scene's own step.
            Assert.That(_radar.Azimuths, Is.EqualTo("0:359:1"));
            _radar.Azimuths = "0:355:5";
            _radar.enabled = true;
            yield return Finish();

            Assert.That((_radar.Rows.Count, _radar.RowCount, _radar.ResultsPath, _radar.Problem),
                Is.EqualTo((72, 72, _folder, (string)null)));
            Assert.That(_radar.Rows.Select(row => row.Planned.AzimuthDegrees),
                Is.EqualTo(Enumerable.Range(0, 72).Select(i => 5 * i)));
            Assert.That(_radar.Rows.Count(row => row.MeetsTolerance), Is.EqualTo(72));
            var lines = File.ReadAllLines(Path.Combine(_folder, "rcs.csv"));
            Assert.That(lines.Length, Is.EqualTo(73));
            Assert.That(lines[0], Does.StartWith("azimuth_deg,elevation_deg,frequency_hz"));
            foreach (string file in new[] { "results.json", "rcs.npz" })
                Assert.That(File.Exists(Path.Combine(_folder, file)), file);

            // The same dihedral in coordinates, without a scene.
            int[] chosen = { 0, 20, 45, 90, 135, 210, 300 };
            var expected = Compute(Dihedral(), chosen.Select(azimuth => (double)azimuth).ToArray());
            for (int i = 0; i < chosen.Length; i++)
            {
                var row = _radar.Rows[chosen[i] / 5];
                // Both are within the tolerance in 95 % of cases.
                double Allowed(Complex amplitude) => 2 * (Math.Pow(10, 0.1 / 20) - 1)
                    * Math.Max(amplitude.Magnitude, Math.Pow(10, row.FloorDbsm / 20));
                Assert.That((row.S.VV - expected[i].S.VV).Magnitude, Is.LessThan(Allowed(row.S.VV)),
                    $"{chosen[i]} deg, VV");
                Assert.That((row.S.HH - expected[i].S.HH).Magnitude, Is.LessThan(Allowed(row.S.HH)),
                    $"{chosen[i]} deg, HH");
            }
        }

        /// <summary>
        /// On axis the double bounce sends back what two plates at 45 degrees intercept: sigma = 8 pi (a b / lambda)^2. It
        /// has opposite signs in VV and HH, and single bounces have the same. Seen square from behind, one face is a plate:
        /// 4 pi (a b / lambda)^2.
        /// </summary>
        [UnityTest]
        public IEnumerator Play_Dihedral_HasItsClosedForms()
        {
            (_radar.Azimuths, _radar.HasEdges, _radar.ToleranceDb) = ("0,135", false, 0.01);
            _radar.enabled = true;
            yield return Finish();
            double square = Math.PI * Math.Pow(Width * Height / Wavelength, 2);
            var s = _radar.Rows[0].S;
            Assert.That(Dbsm((s.VV - s.HH) / 2), Is.EqualTo(10 * Math.Log10(8 * square)).Within(0.01));
            Assert.That(Dbsm(_radar.Rows[1].S.VV), Is.EqualTo(10 * Math.Log10(4 * square)).Within(0.02));
        }

        /// <summary>Only the target is traced, although the dihedral is in the scene too.</summary>
        [UnityTest]
        public IEnumerator Play_OtherTarget_HasTheClosedFormsOfAPlate()
        {
            SetPlate();
            (_radar.Azimuths, _radar.HasEdges, _radar.ToleranceDb) = ("0,20", false, 0.01);
            _radar.enabled = true;
            yield return Finish();
            double area = Width * Height / Wavelength, sine = Math.Sin(Math.PI / 9);
            double phase = 2 * Math.PI / Wavelength * Width * sine;
            double[] levels =
            {
                10 * Math.Log10(4 * Math.PI * area * area),
                10 * Math.Log10(
                    4 * Math.PI * Math.Pow(area * Math.Cos(Math.PI / 9) * Math.Sin(phase) / phase, 2))
            };
            for (int i = 0; i < levels.Length; i++)
                Assert.That(Dbsm(_radar.Rows[i].S.HH), Is.EqualTo(levels[i]).Within(0.03), $"row {i}");
        }

        /// <summary>A plate that is lit from 30 degrees sends to -30 degrees what it intercepts.</summary>
        [UnityTest]
        public IEnumerator Play_FixedReceiver_ReceivesTheMirrorDirection()
        {
            SetPlate();
            (_radar.Azimuths, _radar.HasEdges, _radar.ToleranceDb) = ("30", false, 0.02);
            (_radar.Receiver, _radar.ReceiverAzimuth) = (CrossSectionReceiver.Fixed, -30);
            _radar.enabled = true;
            yield return Finish();
            double area = Width * Height / Wavelength * Math.Cos(Math.PI / 6);
            Assert.That(Dbsm(_radar.Rows.Single().S.VV),
                Is.EqualTo(10 * Math.Log10(4 * Math.PI * area * area)).Within(0.05));
        }

        /// <summary>
        /// Receivers have the elevation of the radar. Over the width of a vertical plate all phases are equal for the one
        /// in the mirror azimuth, which gets most.
        /// </summary>
        [UnityTest]
        public IEnumerator Play_SweepOfReceivers_HasItsMaximumInTheMirrorAzimuth()
        {
            SetPlate();
            (_radar.Azimuths, _radar.Elevations, _radar.HasEdges, _radar.ToleranceDb) = ("30", "20", false, 0.02);
            (_radar.Receiver, _radar.ReceiverAzimuths) = (CrossSectionReceiver.Sweep, "-60:60:10");
            _radar.enabled = true;
            yield return Finish();
            var largest = _radar.Rows.OrderByDescending(row => row.S.VV.Magnitude).First().Planned;
            Assert.That(_radar.Rows.Select(row => row.Planned.ReceiverElevationDegrees), Is.All.EqualTo(20));
            Assert.That((_radar.Rows.Count, largest.ReceiverAzimuthDegrees), Is.EqualTo((13, -30)));
        }

        /// <summary>
        /// At a range R each place of a plate, seen square from a distance r, adds cos(angle) (R / r)^2
        /// exp(-2 j k (r - R)) to physical optics, up to the polarisation, which is within 4 degrees of V.
        /// </summary>
        [UnityTest]
        public IEnumerator Play_APlateAtARange_HasTheSumOverItsPlaces()
        {
            const double Range = 2;
            SetPlate();
            (_radar.Azimuths, _radar.HasEdges, _radar.ToleranceDb, _radar.Range) = ("0", false, 0.02, Range);
            _radar.enabled = true;
            yield return Finish();
            var sum = Complex.Zero;
            const int Across = 150, Down = 100;
            for (int i = 0; i < Across; i++)
                for (int j = 0; j < Down; j++)
                {
                    double x = Width * ((i + 0.5) / Across - 0.5), y = Height * ((j + 0.5) / Down - 0.5);
                    double distance = Math.Sqrt(Range * Range + x * x + y * y), cosine = Range / distance;
                    sum += cosine * Math.Pow(Range / distance, 2)
                        * Complex.Exp(new Complex(0, -4 * Math.PI / Wavelength * (distance - Range)));
                }
            double s = 2 * Math.Sqrt(Math.PI) * Width * Height / Wavelength * sum.Magnitude / (Across * Down);
            Assert.That(Dbsm(_radar.Rows.Single().S.VV), Is.EqualTo(Dbsm(s)).Within(0.05));
            double farField = 10 * Math.Log10(4 * Math.PI * Math.Pow(Width * Height / Wavelength, 2));
            Assert.That(Dbsm(s), Is.LessThan(farField - 0.5), "the range makes a difference");
        }

        /// <summary>A trace has up to 16 receivers.</summary>
        [UnityTest]
        public IEnumerator Play_ManyReceivers_ComputesATraceAFrame()
        {
            (_radar.Azimuths, _radar.ToleranceDb) = ("0,30", 1);
            (_radar.Receiver, _radar.ReceiverAzimuths) = (CrossSectionReceiver.Sweep, "0:90:5");
            _radar.enabled = true;
            var perFrame = new List<int>();
            do
            {
                yield return null;
                perFrame.Add(_radar.Rows.Count);
            }
            while (_radar.IsRunning && perFrame.Count < MaxFrames);
            Assert.That(perFrame.Distinct().Where(count => count > 0), Is.EqualTo(new[] { 16, 19, 35, 38 }));
        }

        [UnityTest]
        public IEnumerator Play_AReceiverBehindTheTarget_WarnsThatItIsOutsidePhysicalOptics()
        {
            (_radar.Azimuths, _radar.ToleranceDb) = ("0", 1);
            (_radar.Receiver, _radar.ReceiverAzimuths) = (CrossSectionReceiver.Sweep, "0,150");
            LogAssert.Expect(LogType.Warning, new Regex("^RadarCrossSection of 'Cross Section': 1 of 2 rows are outside "
                + "physical optics, with radar and receiver more than 120 degrees apart"));
            _radar.enabled = true;
            yield return Finish();
            Assert.That(_radar.Rows.Count, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator Play_TwoFrequencies_ComputesADirectionAFrameAndRaisesAnEventForEachRow()
        {
            (_radar.Azimuths, _radar.Frequencies, _radar.ToleranceDb) = ("0,30,60", "9e9,10e9", 1);
            var raised = new List<CrossSectionRow>();
            var perFrame = new List<int>();
            _radar.RowComputed += raised.Add;
            _radar.enabled = true;
            do
            {
                yield return null;
                perFrame.Add(_radar.Rows.Count);
            }
            while (_radar.IsRunning && perFrame.Count < MaxFrames);
            Assert.That(perFrame.Distinct().Where(count => count > 0), Is.EqualTo(new[] { 2, 4, 6 }));
            Assert.That(raised, Is.EqualTo(_radar.Rows));
        }

        [UnityTest]
        [Timeout(600000)]
        public IEnumerator Cancel_ByAListener_EndsTheRunAndKeepsTheRows()
        {
            (_radar.Frequencies, _radar.ToleranceDb) = ("9e9,10e9", 1);
            _radar.RowComputed += row =>
            {
                if (_radar.Rows.Count == 3)
                    _radar.Cancel();
            };
            _radar.enabled = true;
            yield return Finish();
            Assert.That((_radar.Rows.Count, _radar.RowCount, _radar.Problem), Is.EqualTo((3, 720, (string)null)));
            Assert.That(File.ReadAllLines(Path.Combine(_folder, "rcs.csv")).Length, Is.EqualTo(4));
            Assert.That(File.Exists(Path.Combine(_folder, "results.json")), Is.False);

            _radar.Azimuths = "0";
            _radar.Run();
            yield return Finish();
            Assert.That((_radar.Rows.Count, _radar.RowCount), Is.EqualTo((2, 2)), "from the first row");
        }

        [UnityTest]
        public IEnumerator Run_ByAListenerOfTheLastRow_BeginsTheNextRun()
        {
            (_radar.Azimuths, _radar.ToleranceDb) = ("0,30", 1);
            int rows = 0;
            _radar.RowComputed += row =>
            {
                rows++;
                if (rows != 2)
                    return;
                _radar.Azimuths = "60";
                _radar.Run();
            };
            _radar.enabled = true;
            yield return Finish();
            Assert.That((rows, _radar.Rows.Count, _radar.RowCount, _radar.Problem), Is.EqualTo((3, 1, 1, (string)null)));
            Assert.That(File.Exists(Path.Combine(_folder, "results.json")));
        }

        [UnityTest]
        public IEnumerator Disable_DuringARun_EndsItAndGivesTheFolderBack()
        {
            _radar.ToleranceDb = 1;
            _radar.enabled = true;
            yield return null;
            yield return null;
            Assert.That(_radar.IsRunning);
            _radar.enabled = false;
            Assert.That(_radar.IsRunning, Is.False);
            Assert.That(_radar.Rows.Count, Is.GreaterThan(0));
            Assert.That(() => ResultsFolder.Open(_folder, ResultTable.CrossSection).Dispose(), Throws.Nothing);
        }

        [UnityTest]
        public IEnumerator Play_WithoutRunOnStart_WaitsForRun()
        {
            (_radar.RunOnStart, _radar.Azimuths, _radar.ToleranceDb) = (false, "0", 1);
            _radar.enabled = true;
            yield return null;
            yield return null;
            Assert.That((_radar.IsRunning, _radar.Rows.Count), Is.EqualTo((false, 0)));
            _radar.Run();
            yield return Finish();
            Assert.That(_radar.Rows.Count, Is.EqualTo(1));
        }

        // What is refused, by a change of the scene's component.
        static readonly Dictionary<string, (Action<RadarCrossSection> change, string message)> s_refused =
            new Dictionary<string, (Action<RadarCrossSection>, string)>
            {
                ["target without mesh"] = (it => it.Target = new GameObject("Empty").transform,
                    "its target 'Empty' has no triangles: choose an active object with an enabled MeshRenderer"),
                ["frequency of 0"] = (it => it.Frequencies = "0",
                    "frequencies 0: each frequency must be from 1 to 1e12 hertz"),
                ["frequency given twice"] = (it => it.Frequencies = "1e9,1e9",
                    "the frequency 1000000000 hertz is given twice: give each once"),
                ["range of two parts"] = (it => it.Azimuths = "0:45", "azimuths 0:45: a range has three parts"),
                ["frequency for the size"] = (it =>
                {
                    it.Target.localScale = 1000 * UnityEngine.Vector3.one;
                    it.Frequencies = "1e12";
                }, "1e+12 Hz is too high for its size of"),
                ["elevation"] = (it => it.Elevations = "91",
                    "elevations 91: each elevation must be from -90 to 90 degrees"),
                ["polarisation"] = (it => it.Polarisations = "vv,rl", "polarisations vv,rl: rl is none"),
                ["tolerance"] = (it => it.ToleranceDb = 0, "its tolerance is 0 dB: it must be from 0.001 to 10"),
                ["floor"] = (it => it.FloorDbsm = double.NaN, "its floor is NaN dBsm: it must be from -200 to 200"),
                ["bounces"] = (it => it.MaxBounces = 0, "its number of bounces is 0: it must be from 1"),
                ["crease angle"] = (it => it.CreaseDegrees = 91,
                    "its crease angle is 91 degrees: it must be from 0 to 90"),
                ["receiver"] = (
                    it => (it.Receiver, it.ReceiverElevation) = (CrossSectionReceiver.Fixed, -91),
                    "its receiver elevation is -91 degrees: it must be from -90 to 90"),
                ["receivers"] = (
                    it => (it.Receiver, it.ReceiverAzimuths) = (CrossSectionReceiver.Sweep, "0:400:10"),
                    "receiver azimuths 0:400:10: each azimuth must be from -360 to 360 degrees"),
                ["no receivers"] = (
                    it => (it.Receiver, it.ReceiverAzimuths) = (CrossSectionReceiver.Sweep, ""),
                    "receiver azimuths \"\": no azimuths: give FROM:TO:STEP"),
                ["receivers at two elevations"] = (
                    it => (it.Receiver, it.Elevations) = (CrossSectionReceiver.Sweep, "0,10"),
                    "there are 2 elevations, and the receivers have that of the radar: give one elevation"),
                ["range below 0"] = (it => it.Range = -3,
                    "its range is -3 m: it must be from 1e-6 to 1e6, or 0 for a plane wave and the far field"),
                ["range without a value"] = (it => it.Range = double.NaN, "its range is NaN m: it must be from"),
                ["range inside of the target"] = (it => it.Range = 0.1,
                    "a range of 0.1 m is inside of it: its farthest corner is"),
                ["no kernel"] = (it => it.Kernel = null,
                    "has no kernel: assign Packages/com.glint.radar/Shaders/Tubes.compute"),
                ["another kernel"] = (
                    it => it.Kernel =
                        PlayAsset.Load<ComputeShader>("Packages/com.glint.radar/Shaders/Trace.compute"),
                    "compute shader 'Trace' has no kernel 'TubeCells'")
            };

        static IEnumerable<string> Refused => s_refused.Keys;

        [UnityTest]
        public IEnumerator Run_ThatIsRefused_SaysWhyAndWritesNothing([ValueSource(nameof(Refused))] string what)
        {
            var (change, message) = s_refused[what];
            change(_radar);
            LogAssert.Expect(LogType.Error,
                new Regex("^RadarCrossSection of 'Cross Section'.*" + Regex.Escape(message)));
            _radar.enabled = true;
            yield return null;
            Assert.That(_radar.Problem, Does.Contain(message));
            Assert.That(Regex.Matches(_radar.Problem, _radar.Subject).Count, Is.EqualTo(1), "names itself once");
            Assert.That((_radar.IsRunning, _radar.Rows.Count), Is.EqualTo((false, 0)));
            Assert.That(Directory.Exists(_folder), Is.False);
        }

        IEnumerator Finish()
        {
            int frames = 0;
            do
                yield return null;
            while (_radar.IsRunning && ++frames < MaxFrames);
        }

        void SetPlate()
        {
            var plate = GameObject.CreatePrimitive(PrimitiveType.Quad).transform;
            plate.localScale = new UnityEngine.Vector3((float)Width, (float)Height, 1);
            _radar.Target = plate;
        }

        IReadOnlyList<CrossSectionRow> Compute(TriangleMesh mesh, double[] azimuths)
        {
            var plan = new CrossSectionPlan(azimuths, new double[] { 0 }, new[] { 10e9 });
            var setup = new CrossSectionSetup(new RadarScene(mesh), plan);
            setup.PhaseCentre = setup.BoxCentre;
            using (var run = new CrossSectionRun(setup, _radar.Kernel))
                return Enumerable.Range(0, run.Count).Select(_ => run.Step()).ToArray();
        }

        static TriangleMesh Dihedral()
        {
            float side = (float)(Width / Math.Sqrt(2)), half = (float)Height / 2;
            return new TriangleMesh(new[]
            {
                new float3(0, -half, 0), new float3(0, half, 0), new float3(side, -half, -side),
                new float3(side, half, -side), new float3(-side, -half, -side), new float3(-side, half, -side)
            }, new[] { 0, 1, 2, 2, 1, 3, 0, 4, 1, 1, 4, 5 });
        }

        static double Dbsm(Complex amplitude) => ScatteringMatrix.Dbsm(amplitude);
    }
}
