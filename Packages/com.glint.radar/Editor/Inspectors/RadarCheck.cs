using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Checks a radar and the scene in their current state: problems that keep it from tracing or may mislead, and
    /// figures. It has its own gatherer, so that the radar's is not affected.
    /// </summary>
    sealed class RadarCheck
    {
        readonly RadarController _radar;
        readonly SceneGatherer _gatherer = new SceneGatherer();
        readonly VisibleRenderers _visible = new VisibleRenderers();
        readonly SceneBoxes _boxes = new SceneBoxes();
        readonly List<Finding> _findings = new List<Finding>();

        public RadarCheck(RadarController radar) => _radar = radar;

        /// <summary>
        /// Whether there is a scene to check: a prefab asset, or one open in prefab mode, traces nothing.
        /// </summary>
        public static bool CanLook(Component component) =>
            !EditorUtility.IsPersistent(component) && !EditorSceneManager.IsPreviewSceneObject(component);

        /// <summary>Findings of the last update, errors first.</summary>
        public IReadOnlyList<Finding> Findings => _findings;

        /// <summary>Figures of the last update; null if nothing can be traced.</summary>
        public RadarFigures Figures { get; private set; }

        /// <summary>Duration of the last update, by which callers may space theirs.</summary>
        public double Seconds { get; private set; }

        /// <summary>
        /// Updates the findings. It gathers the scene, as <see cref="RadarController.Gather()"/> does.
        /// </summary>
        public void Update()
        {
            var watch = Stopwatch.StartNew();
            _findings.Clear();
            Figures = null;
            CheckRadar();
            Finding.Add(_findings, () => RayTracer.Check(_radar.Kernel, _radar.Subject),
                () => RadarFixes.AssignKernel(_radar));
            if (_radar.Settings.ToleranceDb > 0)
                Finding.Add(_findings, () => AmplitudeTracer.Check(_radar.TubeKernel, _radar.Subject),
                    () => RadarFixes.AssignTubeKernel(_radar));
            if (SceneSearch.FindEnabled<Sea>().Any(sea => sea.Clutter.IsOn))
                Finding.Add(_findings, () => CrossSectionTracer.Check(_radar.ClutterKernel, _radar.Subject),
                    () => RadarFixes.AssignClutterKernel(_radar));
            CheckMeshes();
            if (_findings.All(finding => finding.Severity != Severity.Error))
                CheckPose();
            var ordered = _findings.OrderByDescending(finding => finding.Severity).ToList();
            _findings.Clear();
            _findings.AddRange(ordered);
            Seconds = watch.Elapsed.TotalSeconds;
        }

        void Add(Severity severity, string text, Fix fix = null, UnityEngine.Object where = null) =>
            _findings.Add(new Finding(severity, text, fix, where));

        void CheckRadar()
        {
            if (!_radar.isActiveAndEnabled)
                Add(Severity.Warning, SceneSearch.IsDisabled(_radar), RadarFixes.Enable(_radar));
            if (_radar.Receiver == null)
                Add(Severity.Error, _radar.HasNoReceiver, RadarFixes.MakeReceiver(_radar));
            if (!_radar.TryGetComponent<Camera>(out var camera))
                Add(Severity.Error, _radar.HasNoCamera, RadarFixes.AddCamera(_radar));
            else if (camera.orthographic && !_radar.IsFitted && !(camera.orthographicSize > 0))
                Add(Severity.Error, _radar.HasNoHeight, RadarFixes.FitAperture(_radar));
            if (_radar.Roots.Exists(root => root == null))
                Add(Severity.Error, _radar.HasEmptyRoot, RadarFixes.RemoveEmptyRoots(_radar));
        }

        void CheckMeshes()
        {
            var roots = _radar.Roots.FindAll(root => root != null);
            var seen = _visible.Find(_radar.Layers, roots, _radar.Receiver).OfType<MeshRenderer>()
                .Select(renderer =>
                    (renderer, mesh: renderer.TryGetComponent<MeshFilter>(out var filter) ? filter.sharedMesh : null))
                .Where(pair => pair.mesh != null).Distinct().ToList();
            var batched = seen.FindAll(pair => pair.renderer.isPartOfStaticBatch).ConvertAll(pair => pair.renderer);
            if (batched.Count > 0)
                Add(Severity.Error, SceneGatherer.InStaticBatch(batched[0]) + More(batched.Count),
                    Application.isPlaying ? null : RadarFixes.ClearBatching(batched), batched[0]);
            var marked = seen.FindAll(pair => !pair.renderer.isPartOfStaticBatch
                && RadarFixes.IsBatchingStatic(pair.renderer)).ConvertAll(pair => pair.renderer);
            if (marked.Count > 0)
                Add(Severity.Warning, $"'{marked[0].name}' is marked Batching Static, and cannot be traced once Unity "
                    + "has merged it with others when the scene is played: clear Batching Static among its static "
                    + $"flags{More(marked.Count)}", RadarFixes.ClearBatching(marked), marked[0]);
            var unreadable = seen.FindAll(pair => !pair.renderer.isPartOfStaticBatch && !pair.mesh.isReadable)
                .GroupBy(pair => pair.mesh).Select(group => group.First()).ToList();
            if (unreadable.Count > 0)
                Add(Severity.Error,
                    SceneGatherer.NotReadable(unreadable[0].mesh, unreadable[0].renderer) + More(unreadable.Count),
                    RadarFixes.MakeReadable(unreadable.ConvertAll(pair => pair.mesh)), unreadable[0].renderer);
            if (seen.Count == 0)
                CheckLayers(roots);
        }

        void CheckLayers(List<Transform> roots)
        {
            string where = roots.Count == 0 ? "in the loaded scenes" : "below its Roots";
            if (_visible.Find(~0, roots, _radar.Receiver).OfType<MeshRenderer>().Any())
                Add(Severity.Warning, $"{_radar.Subject} traces nothing: no active object {where} with an enabled "
                    + "MeshRenderer is on its Layers: choose others", RadarFixes.TraceAllLayers(_radar));
            else
                Add(Severity.Warning, $"{_radar.Subject} traces nothing: "
                    + $"there is no active object {where} with an enabled MeshRenderer and a mesh: add one");
        }

        static string More(int count) => count > 1 ? $" (and {count - 1} more)" : "";

        // All other refusals of a trace, with their messages, and checks that need a pose.
        void CheckPose()
        {
            RadarPose pose = default;
            if (!Finding.Add(_findings, () =>
            {
                pose = _radar.Gather(_gatherer);
                DispatchPlan.Check(pose.Settings, _radar.RayReadback, _radar.Subject);
            }))
                return;
            foreach (string warning in _gatherer.Warnings)
                Add(Severity.Warning, $"{_radar.Subject}: {warning}");
            _boxes.Update(pose.Scene);
            if (_boxes.IsEmpty)
                return;
            Figures = new RadarFigures(pose, _boxes, _gatherer.ObjectCount, _radar.RayReadback);
            if (_boxes.AreSeen(pose))
                CheckSampling();
            else
                CheckAim(pose);
        }

        void CheckAim(RadarPose pose)
        {
            pose.Settings.Region = default;
            if (_boxes.AreSeen(pose))
                Add(Severity.Warning, $"{_radar.Subject}: no traced object is in the region of its picture: "
                    + "choose another, or trace the whole picture", RadarFixes.TraceWholePicture(_radar));
            else
                Add(Severity.Warning, FormattableString.Invariant(
                    $"{_radar.Subject}: no traced object is in its picture; their centre is {Figures.Distance:g4} m away: turn the radar towards it"),
                    RadarFixes.LookAt(_radar, Figures.Centre - pose.View.Position));
        }

        // The conditions by which SamplingEstimate flags a result, as far as the scene's bounds decide them.
        void CheckSampling()
        {
            if (_radar.Settings.ToleranceDb > 0)
                return; // the tubes follow the tolerance, not the rays
            string remedy = _radar.IsFitted ? "use a smaller Ray Spacing" : "give it more rays or a narrower view";
            if (Figures.MaxRaysHit < SamplingEstimate.FewestRays)
                Add(Severity.Warning, FormattableString.Invariant(
                    $"{_radar.Subject}: its rays are {Figures.RaySpacing:g3} m apart at the target, which is {Figures.TargetSize:g3} m large: fewer than {SamplingEstimate.FewestRays} can hit it, too few for the amplitude to be trusted: {remedy}"),
                    Denser());
            else if (!(Figures.Forecast is SamplingForecast forecast))
                Add(Severity.Warning, $"{_radar.Subject}: no ray that a mirror at the target sends straight back comes "
                    + $"to its receiver '{_radar.Receiver.name}': put it behind the camera, facing as the camera does",
                    RadarFixes.AlignReceiver(_radar), _radar.Receiver);
            else if (forecast.IsTooFew)
                Add(Severity.Warning, FormattableString.Invariant(
                    $"{_radar.Subject}: a mirror at the target, facing the radar, would send {forecast.RaysReceived:0.#} rays to its receiver, fewer than the {SamplingEstimate.FewestRays} needed for the amplitude to be trusted: give it a larger receiver, or {remedy}"),
                    Denser());
            else if (forecast.IsTooCoarse)
                Add(Severity.Warning, FormattableString.Invariant(
                    $"{_radar.Subject}: its rays are {forecast.RaySpacing:g3} m apart at the target: a mirror there, facing the radar, would return rays most of whose neighbours' paths differ by {SamplingEstimate.StepApart} wavelengths or more (up to {forecast.LargestPathStep:0.##}), too much for the amplitude to be trusted; other returns may do better: {remedy}"),
                    Denser());
        }

        Fix Denser() => RadarFixes.TraceDenser(_radar, Figures.EnoughTimes(_radar.Subject));
    }
}
