using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Each finding in a scene that has it, after its fix, and after Undo.</summary>
    public sealed class RadarCheckTests : InspectorFixture
    {
        const string Sampled = "for the amplitude to be trusted";

        [Test]
        public void Update_NothingWrong_FindsNothingAndTraces()
        {
            Assert.That(Findings(), Is.Empty);
            Assert.That(_radar.Trace().Undersampled, Is.False);
        }

        static IEnumerable<TestCaseData> Mended()
        {
            yield return Case("no receiver", test => test._radar.Receiver = null,
                "Error: RadarController of 'Radar' has no receiver");
            yield return Case("no kernel", test => test._radar.Kernel = null,
                "Error: RadarController of 'Radar' has no kernel");
            yield return Case("another kernel",
                test => test._radar.Kernel = TestKernels.Layout, "has no kernel 'Trace");
            yield return Case("no kernel of tubes", test =>
                {
                    test._radar.TubeKernel = null;
                    test.Change(settings => { settings.ToleranceDb = 1; return settings; });
                }, "Error: RadarController of 'Radar': a tolerance needs the kernels of ray tubes");
            yield return Case("empty root", test => test._radar.Roots.Add(null),
                "Error: RadarController of 'Radar': an entry of Roots is empty");
            yield return Case("disabled", test => test._radar.enabled = false,
                "Warning: RadarController of 'Radar' is disabled or inactive");
            yield return Case("inactive", test => test._radar.gameObject.SetActive(false),
                "Warning: RadarController of 'Radar' is disabled or inactive");
            yield return Case("aperture without height", test => test.MakeParallel(0),
                "Error: the Camera of 'Radar' is orthographic and its Size is 0");
            yield return Case("layers", test => test._radar.Layers = 1 << 5,
                "Warning: RadarController of 'Radar' traces nothing: no active object below its Roots");
            yield return Case("aim", test => test._radar.transform.rotation = Quaternion.Euler(0, 130, 0),
                "Warning: RadarController of 'Radar': no traced object is in its picture; their centre is 20 m away");
            yield return Case("aim of parallel rays",
                test => { test.MakeParallel(2); test._radar.transform.rotation = Quaternion.Euler(0, 30, 0); },
                "no traced object is in its picture");
            yield return Case("region", test => test.SetRegion(0, 0, 8, 8),
                "Warning: RadarController of 'Radar': no traced object is in the region of its picture");
            yield return Case("receiver that faces away",
                test => test._radar.Receiver.localRotation = Quaternion.Euler(0, 180, 0),
                "comes to its receiver 'Receiver'");
            yield return Case("small receiver", test => test._radar.ReceiverSize = new Vector2(0.5f, 0.5f),
                "fewer than the 16 needed for the amplitude");
            yield return Case("few rays", test =>
                    test.Change(settings => { (settings.RaysAcross, settings.RaysDown) = (16, 9); return settings; }),
                "fewer than 16 can hit it");
            // Turned by 25 degrees: neighbours return 2 * 0.26 m apart, and their paths differ by that times sin(25
            // degrees).
            yield return Case("coarse rays", test => test._radar.transform.rotation = Quaternion.Euler(0, 25, 0),
                "most of whose neighbours' paths differ by 0.5 wavelengths or more");
            yield return Case("coarse parallel rays",
                test => { test.MakeParallel(2); (test._radar.FitAperture, test._radar.RaySpacing) = (true, 3); },
                "fewer than 16 can hit it");
        }

        [TestCaseSource(nameof(Mended))]
        public void Fix_OfAFinding_MendsItAndUndoBringsItBack(Action<RadarCheckTests> spoil, string text)
        {
            Assert.That(Findings(), Has.None.Contains(text));
            spoil(this);
            var finding = Finding(text);
            Undo.ClearAll();

            finding.Fix.Apply();
            Assert.That(Findings(), Is.Empty);
            Assert.That(_radar.gameObject.scene.isDirty);
            Undo.PerformUndo();
            Assert.That(Findings(), Has.Some.Contains(text));
        }

        static IEnumerable<TestCaseData> LeftToTheUser()
        {
            yield return Case("frequency",
                test => test.Change(settings => { settings.FrequencyHz = 0; return settings; }),
                "Error: RadarController of 'Radar': frequency 0 Hz");
            yield return Case("bounces",
                test => test.Change(settings => { settings.MaxBounces = 17; return settings; }),
                "Error: RadarController of 'Radar': maximum bounces 17");
            yield return Case("receiver size", test => test._radar.ReceiverSize = new Vector2(3, -1),
                "Error: RadarController of 'Radar': receiver size 3 x -1 m");
            yield return Case("field of view",
                test => test._radar.GetComponent<Camera>().fieldOfView = 0, "field of view 0 deg");
            yield return Case("spacing",
                test => { test.MakeParallel(2); (test._radar.FitAperture, test._radar.RaySpacing) = (true, 0); },
                "Error: RadarController of 'Radar': ray spacing 0 m");
            yield return Case("nothing there", test => test._plate.SetActive(false),
                "Warning: RadarController of 'Radar' traces nothing: there is no active object below its Roots");
            yield return Case("lines", test => test._plate.GetComponent<MeshFilter>().sharedMesh = Lines(),
                "Error: submesh 0 of mesh 'Lines' of 'Plate' is made of Lines");
            yield return Case("rays for which there is no room", test => test.Change(settings =>
            {
                (settings.RaysAcross, settings.RaysDown) = (RadarSettings.RaysPerAxisLimit, 1);
                return settings;
            }), "fewer than 16 can hit it");
        }

        [TestCaseSource(nameof(LeftToTheUser))]
        public void Update_WhatOnlyTheUserCanMend_IsFoundWithoutAFix(Action<RadarCheckTests> spoil, string text)
        {
            Assert.That(Findings(), Has.None.Contains(text));
            spoil(this);
            Assert.That(Finding(text).Fix, Is.Null);
        }

        [Test]
        public void Update_WhatTheProductRefuses_IsSaidInItsOwnWords()
        {
            _radar.Receiver = null;
            _radar.Roots.Add(null);
            var refused = Assert.Throws<GlintException>(() => _radar.Gather());
            Assert.That(Findings(), Has.Some.Contains(refused.Message));
            _radar.Receiver = _plate.transform;
            refused = Assert.Throws<GlintException>(() => _radar.Gather());
            Assert.That(Findings(), Has.Some.Contains(refused.Message));
        }

        // The inspector and Undo write the field.
        [Test]
        public void Trace_AfterAnotherKernelWasAssigned_TakesIt()
        {
            _radar.Trace();
            _radar.Kernel = TestKernels.Layout;
            Assert.That(() => _radar.Trace(), Throws.TypeOf<GlintException>().With.Message.Contains("has no kernel 'Trace"));
            _radar.Kernel = TestKernels.Trace;
            _radar.Trace();
        }

        [Test]
        public void Update_SeveralThingsWrong_FindsAllErrorsFirst()
        {
            _radar.enabled = false;
            _radar.Receiver = null;
            _radar.Kernel = null;
            _check.Update();
            Assert.That(_check.Findings.Select(finding => finding.Severity),
                Is.EqualTo(new[] { Severity.Error, Severity.Error, Severity.Warning }));
            Assert.That(_check.Figures, Is.Null);
        }

        [Test]
        public void Update_CoarseRays_AreFoundWhereTheTraceIsUndersampled()
        {
            _radar.transform.rotation = Quaternion.Euler(0, 25, 0);
            Assert.That(Findings(), Has.Some.Contains(Sampled));
            Assert.That(_radar.Trace().Undersampled);
        }

        [Test]
        public void Update_LooksOnly()
        {
            _check.Update();
            Assert.That(_radar.Result, Is.Null);
            Assert.That(_radar.ObjectCount, Is.EqualTo(0), "the radar's own gatherer has seen nothing");
        }

        List<string> Findings()
        {
            _check.Update();
            return _check.Findings.Select(finding => finding.ToString()).ToList();
        }

        Finding Finding(string text)
        {
            _check.Update();
            return _check.Findings.Single(finding => finding.ToString().Contains(text));
        }

        void MakeParallel(float size)
        {
            var camera = _radar.GetComponent<Camera>();
            (camera.orthographic, camera.orthographicSize) = (true, size);
            _radar.RaySpacing = 0.05;
        }

        void SetRegion(int left, int bottom, int width, int height) => Change(settings =>
        {
            settings.Region = new RayRegion { Left = left, Bottom = bottom, Width = width, Height = height };
            return settings;
        });

        void Change(Func<RadarSettings, RadarSettings> change) => _radar.Settings = change(_radar.Settings);

        static Mesh Lines()
        {
            var mesh = new Mesh { name = "Lines", vertices = new[] { Vector3.zero, Vector3.up } };
            mesh.SetIndices(new[] { 0, 1 }, MeshTopology.Lines, 0);
            return mesh;
        }

        static TestCaseData Case(string name, Action<RadarCheckTests> spoil, string text) =>
            new TestCaseData(spoil, text).SetName(name);
    }
}
