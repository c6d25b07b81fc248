using System;
using System.Collections.Generic;
using System.Threading;
using Glint.Core;
using UnityEngine;
using UnityEngine.Serialization;

namespace Glint
{
    /// <summary>
    /// Computes the radar cross section of an object over azimuth, and writes the files of <c>glint rcs</c>. It begins
    /// when the scene is played, and computes one direction a frame. In edit mode its inspector runs it.
    /// </summary>
    [AddComponentMenu("Glint/Radar Cross Section")]
    [HelpPage("rcs.md")]
    [ExecuteAlways] // for OnDisable in edit mode, which releases the buffers and the folder
    [DisallowMultipleComponent]
    public sealed class RadarCrossSection : MonoBehaviour
    {
        [SerializeField, Tooltip("Object whose cross section is computed, with all below it. Empty: everything in the "
            + "loaded scenes.")]
        Transform _target;

        [SerializeField, Tooltip("Azimuths of the radar, degrees, positive as Unity's rotation about Y; at 0 it is on "
            + "the -Z side and looks along +Z. FROM:TO:STEP, FROM and (when whole steps reach it) TO included, or a "
            + "list with commas.")]
        string _azimuths = "0:359:1";

        [SerializeField, Tooltip("Elevations of the radar above the horizontal, degrees: a range or list.")]
        string _elevations = "0";

        [SerializeField, Tooltip("Frequencies, hertz: a range or list.")]
        string _frequencies = "10e9";

        [SerializeField, Tooltip("Elements of the scattering matrix, received before sent: all, or of vv, hv, vh and "
            + "hh, with commas. V is the radar's up, H its right.")]
        string _polarisations = "vv,hh";

        [SerializeField, FormerlySerializedAs("_isBistatic"), Tooltip("Radar: what sends also receives. Fixed: one "
            + "receiver in a fixed direction. Sweep: receivers at the elevation of the radar.")]
        CrossSectionReceiver _receiver;

        [SerializeField, Tooltip("Azimuth of the fixed receiver, degrees.")]
        double _receiverAzimuth;

        [SerializeField, Tooltip("Elevation of the fixed receiver, degrees.")]
        double _receiverElevation;

        [SerializeField, Tooltip("Azimuths of the receivers of a sweep, degrees: a range or list. They are at the "
            + "elevation of the radar, which then has one.")]
        string _receiverAzimuths = "0:180:5";

        [SerializeField, Tooltip("Metres from the centre of the target's box to radar and receivers, for a spherical "
            + "wave. 0: a plane wave and the far field.")]
        double _range;

        [SerializeField, Tooltip("The error asked for, decibels: 95 % of the amplitudes are within it. It is the error "
            + "of the integration, not of physical optics.")]
        double _tolerance = CrossSectionPose.DefaultToleranceDb;

        [SerializeField, Tooltip("The tolerance is relative to Floor where the cross section is below it. Off: 40 dB "
            + "below the sphere around the target.")]
        bool _setFloor;

        [SerializeField, Tooltip("With Set Floor, dBsm.")]
        double _floor = -60;

        [SerializeField, Range(1, RadarSettings.BounceLimit), Tooltip("Maximum number of bounces of a ray.")]
        int _maxBounces = 4;

        [SerializeField, Tooltip("Metal edges add their fringe fields. Off: physical optics only.")]
        bool _edges = true;

        [SerializeField, Tooltip("Edges bent by more than this angle, degrees, are sharp; facets that meet at smaller "
            + "ones are one curved surface.")]
        double _creaseAngle = CrossSectionPose.DefaultCreaseDegrees;

        [SerializeField, Tooltip("Begins when the scene is played. Off: a script calls Run.")]
        bool _runOnStart = true;

        [SerializeField, Tooltip("Folder for rcs.csv, rcs.npz and results.json, relative to the project, in a player "
            + "to Application.persistentDataPath. Empty: Results/<scene>-rcs.")]
        string _outputFolder = "";

        [SerializeField, Tooltip("Packages/com.glint.radar/Shaders/Tubes.compute")]
        ComputeShader _kernel;

        readonly LogProgress _progress = new LogProgress();
        readonly List<CrossSectionRow> _rows = new List<CrossSectionRow>();
        PlayWatch _play;
        CrossSectionRun _run;

        /// <summary>The object, with all below it; null: everything in the loaded scenes.</summary>
        public Transform Target { get => _target; set => _target = value; }

        /// <summary>Azimuths of the radar, degrees: FROM:TO:STEP or a list with commas.</summary>
        public string Azimuths { get => _azimuths; set => _azimuths = value; }

        /// <summary>Elevations of the radar, degrees: FROM:TO:STEP or a list with commas.</summary>
        public string Elevations { get => _elevations; set => _elevations = value; }

        /// <summary>Frequencies, hertz: FROM:TO:STEP or a list with commas.</summary>
        public string Frequencies { get => _frequencies; set => _frequencies = value; }

        /// <summary>Elements of the scattering matrix: all, or names with commas.</summary>
        public string Polarisations { get => _polarisations; set => _polarisations = value; }

        /// <summary>What receives.</summary>
        public CrossSectionReceiver Receiver { get => _receiver; set => _receiver = value; }

        /// <summary>Direction of the fixed receiver, degrees.</summary>
        public double ReceiverAzimuth { get => _receiverAzimuth; set => _receiverAzimuth = value; }

        /// <inheritdoc cref="ReceiverAzimuth"/>
        public double ReceiverElevation { get => _receiverElevation; set => _receiverElevation = value; }

        /// <summary>Azimuths of the receivers of a sweep, degrees: FROM:TO:STEP or a list with commas.</summary>
        public string ReceiverAzimuths { get => _receiverAzimuths; set => _receiverAzimuths = value; }

        /// <summary>Metres from the phase centre to radar and receivers; 0: a plane wave and the far field.</summary>
        public double Range { get => _range; set => _range = value; }

        /// <summary>The error asked for, decibels.</summary>
        public double ToleranceDb { get => _tolerance; set => _tolerance = value; }

        /// <summary>
        /// Cross section below which the tolerance is that of this one, dBsm; null: <see cref="CrossSectionFloor"/>.
        /// </summary>
        public double? FloorDbsm
        {
            get => _setFloor ? _floor : (double?)null;
            set => (_setFloor, _floor) = (value.HasValue, value ?? _floor);
        }

        /// <summary>Maximum number of bounces of a path.</summary>
        public int MaxBounces { get => _maxBounces; set => _maxBounces = value; }

        /// <summary>Whether edges add their fringe fields.</summary>
        public bool HasEdges { get => _edges; set => _edges = value; }

        /// <summary>Bend of edges above which they are sharp, degrees.</summary>
        public double CreaseDegrees { get => _creaseAngle; set => _creaseAngle = value; }

        /// <summary>Whether it begins when the scene is played.</summary>
        public bool RunOnStart { get => _runOnStart; set => _runOnStart = value; }

        /// <summary>
        /// Folder for the result files, relative to the project or, in a player, to Application.persistentDataPath;
        /// empty: Results/&lt;scene&gt;-rcs.
        /// </summary>
        public string OutputFolder { get => _outputFolder; set => _outputFolder = value; }

        /// <summary>Packages/com.glint.radar/Shaders/Tubes.compute.</summary>
        public ComputeShader Kernel { get => _kernel; set => _kernel = value; }

        /// <summary>Raised after each row.</summary>
        public event Action<CrossSectionRow> RowComputed;

        /// <summary>True from <see cref="Run"/> until all rows are written.</summary>
        public bool IsRunning => _run != null;

        /// <summary>The rows of the run last begun; null before it.</summary>
        public CrossSectionPlan RunPlan { get; private set; }

        /// <summary>Rows that the run last begun has in the end; 0 before it.</summary>
        public int RowCount => RunPlan?.Count ?? 0;

        /// <summary>The rows of this run so far; they stay after its end.</summary>
        public IReadOnlyList<CrossSectionRow> Rows => _rows;

        /// <summary>Folder of its result files; null before it.</summary>
        public string ResultsPath { get; private set; }

        /// <summary>Why the run could not begin or continue; null if nothing was wrong.</summary>
        public string Problem { get; private set; }

        /// <summary>Name in messages.</summary>
        public string Subject => $"RadarCrossSection of '{name}'";

        string SceneName => RunDescription.SceneOf(this);

        /// <summary>The rows to compute.</summary>
        /// <exception cref="GlintException">A list is malformed, or there are too many rows.</exception>
        public CrossSectionPlan Plan()
        {
            double[] azimuths = Read(CrossSectionRanges.Azimuths.Read, _azimuths, "azimuths"),
                elevations = Read(CrossSectionRanges.Elevations.Read, _elevations, "elevations"),
                frequencies = Read(SweepAxis.Frequency.List.Read, _frequencies, "frequencies"),
                receivers = _receiver == CrossSectionReceiver.Sweep
                    ? Read(CrossSectionRanges.Azimuths.Read, _receiverAzimuths, "receiver azimuths")
                    : null;
            if (_receiver == CrossSectionReceiver.Fixed)
            {
                Require("receiver azimuth", _receiverAzimuth, CrossSectionRanges.Azimuth, "degrees");
                Require("receiver elevation", _receiverElevation, CrossSectionRanges.Elevation, "degrees");
            }
            try
            {
                switch (_receiver)
                {
                    case CrossSectionReceiver.Fixed:
                        return new CrossSectionPlan(azimuths, elevations, frequencies, new[] { _receiverAzimuth },
                            _receiverElevation);
                    case CrossSectionReceiver.Sweep:
                        return CrossSectionPlan.OfReceivers(azimuths, elevations, frequencies, receivers);
                    default:
                        return new CrossSectionPlan(azimuths, elevations, frequencies);
                }
            }
            catch (UsageException problem)
            {
                throw new GlintException($"{Subject}: {problem.Message}", problem);
            }
        }

        /// <summary>The rows to compute, with the scene in its current state.</summary>
        /// <param name="gatherer">Its warnings name the objects that are left out.</param>
        /// <exception cref="GlintException">
        /// A field has no valid value, the target has no mesh, or a mesh cannot be traced.
        /// </exception>
        public CrossSectionSetup Setup(SceneGatherer gatherer)
        {
            var plan = Plan(); // before the scene is gathered, which may take long
            var polarisations = Read(Polarisation.Read, _polarisations, "polarisations");
            Require("tolerance", _tolerance, CrossSectionRanges.Tolerance, "dB");
            Require("crease angle", _creaseAngle, CrossSectionRanges.Crease, "degrees");
            Require("number of bounces", _maxBounces, Interval.Closed(1, RadarSettings.BounceLimit), "");
            if (_range != 0)
                Require("range", _range, SweepAxis.Range.List.Range, "m", ", or 0 for a plane wave and the far field");
            if (_setFloor)
                Require("floor", _floor, CrossSectionRanges.Level, "dBsm");
            var scene = gatherer.Gather(~0, _target == null ? new Transform[0] : new[] { _target }, null);
            if (scene.TriangleCount == 0)
                throw new GlintException(HasNoMesh);
            var setup = new CrossSectionSetup(scene, plan) { Subject = Subject, Polarisations = polarisations };
            (setup.ToleranceDb, setup.GivenFloorDbsm, setup.CreaseDegrees) = (_tolerance, FloorDbsm, _creaseAngle);
            (setup.MaxBounces, setup.HasEdges, setup.PhaseCentre) = (_maxBounces, _edges, setup.BoxCentre);
            setup.Range = _range == 0 ? double.PositiveInfinity : _range;
            string path = gameObject.scene.path;
            (setup.ScenePath, setup.Objects) = (string.IsNullOrEmpty(path) ? null : path, gatherer.ObjectCount);
            return setup;
        }

        /// <summary>
        /// Begins from the first row. In play mode the rows follow, a direction a frame; in edit mode the caller takes
        /// each <see cref="Step"/>. If it cannot begin, <see cref="Problem"/> and the console say why.
        /// </summary>
        public void Run() => Attempt(Begin);

        /// <summary>Ends the run; its rows are kept.</summary>
        public void Cancel() => End();

        /// <summary>
        /// Computes the rows of the next direction, or of its next 16 receivers if it has more, and writes them. After
        /// the last ones it writes the other files. Without a run it does nothing.
        /// </summary>
        /// <param name="progress">Receives the fraction of the trace done, 0 to 1; may be null.</param>
        /// <param name="cancel">Ends the run.</param>
        public void Step(IProgress<double> progress = null, CancellationToken cancel = default) => Attempt(() =>
        {
            if (!IsRunning)
                return;
            // A listener may end the run, or begin another one.
            var run = _run;
            for (int end = _rows.Count + RowsOfStep; _run == run && _rows.Count < end;)
            {
                var row = run.Step(progress, cancel);
                bool isComplete = run.IsComplete;
                _rows.Add(row);
                _progress.Advance(_rows.Count, row.ToString());
                RowComputed?.Invoke(row);
                if (!isComplete || IsRunning && _run != run)
                    continue;
                End();
                Warn();
            }
        });

        // In the editor, when the component is added or reset. The kernel is among the default references of this
        // script.
        void Reset() => _target = GetComponentInChildren<MeshFilter>(true) != null ? transform : null;

        void OnEnable() => _play.Enable(this);

        void Start() => RunOnPlay();

        void Update()
        {
            RunOnPlay();
            if (IsRunning && Application.IsPlaying(gameObject))
                Step();
        }

        void RunOnPlay()
        {
            if (_play.Begins(this) && _runOnStart)
                Run();
        }

        void OnDisable() => End();

        void Begin()
        {
            End();
            (Problem, RunPlan, ResultsPath) = (null, null, null);
            _rows.Clear();
            if (!isActiveAndEnabled)
                throw new GlintException(SceneSearch.IsDisabled(this));
            CrossSectionTracer.Check(_kernel, Subject);
            var gatherer = new SceneGatherer();
            var setup = Setup(gatherer);
            foreach (string warning in gatherer.Warnings)
                Debug.LogWarning($"{Subject}: {warning}", this);
            var folder = ResultsFolder.Open(string.IsNullOrEmpty(_outputFolder)
                ? RunDescription.DefaultFolder(SceneName, ResultTable.CrossSection)
                : RunDescription.InProject(_outputFolder), ResultTable.CrossSection);
            _run = new CrossSectionRun(setup, _kernel, folder);
            foreach (string warning in setup.Warnings(Subject))
                Debug.LogWarning(warning, this);
            (RunPlan, ResultsPath) = (setup.Plan, folder.FolderPath);
            _progress.Start(SceneName, RowCount);
        }

        void End()
        {
            _run?.Dispose();
            _run = null;
        }

        // Receivers of several traces would take long for one frame.
        int RowsOfStep => RunPlan.Receivers > TubeKernels.MaxReceivers
            ? Math.Min(TubeKernels.MaxReceivers, RunPlan.Receivers - _rows.Count % RunPlan.Receivers)
            : RunPlan.Count / RunPlan.Poses;

        void Warn()
        {
            var warnings = new RowWarnings();
            foreach (var row in _rows)
                warnings.Add(row);
            foreach (string warning in warnings.Of(Subject, _tolerance, "tolerance or floor"))
                Debug.LogWarning(warning, this);
        }

        string HasNoMesh => Subject
            + (_target == null ? ": the loaded scenes have" : $": its target '{_target.name}' has")
            + " no triangles: choose an active object with an enabled MeshRenderer and a mesh, at or below it";

        T Read<T>(Func<string, T> read, string text, string field) => Values.Parse(read, text, $"{Subject}: {field}");

        void Require(string field, double value, Interval range, string unit, string otherwise = "")
        {
            if (!range.Contains(value))
                throw new GlintException(FormattableString.Invariant(
                    $"{Subject}: its {field} is {value:R} {unit}").TrimEnd() + $": it must be {range}{otherwise}");
        }

        // A run that cannot continue reports why and ends; its rows are kept.
        void Attempt(Action step)
        {
            try
            {
                step();
            }
            catch (OperationCanceledException)
            {
                End();
            }
            catch (GlintException problem)
            {
                End();
                Problem = problem.Message;
                Debug.LogError(Problem, this);
            }
            catch (Exception fault)
            {
                End();
                Problem = fault.Message;
                Debug.LogException(fault, this);
            }
        }
    }

    /// <summary>What receives, for a <see cref="RadarCrossSection"/>. Stored as numbers.</summary>
    public enum CrossSectionReceiver
    {
        /// <summary>The radar.</summary>
        Radar = 0,

        /// <summary>One receiver in a fixed direction.</summary>
        Fixed = 1,

        /// <summary>Receivers at the elevation of the radar.</summary>
        Sweep = 2
    }
}
