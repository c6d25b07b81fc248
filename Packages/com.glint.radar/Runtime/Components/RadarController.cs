using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using Debug = UnityEngine.Debug;

namespace Glint
{
    /// <summary>
    /// A radar at a camera: one ray a pixel is reflected through the scene on the GPU, and the received rays are summed
    /// coherently. Position, rotation and vertical field of view are the Camera's; rays across and down set the aspect
    /// ratio. An orthographic Camera emits parallel rays from an aperture of twice its Size in height.
    /// It traces one pose when the scene starts and whenever
    /// <see cref="Trace(IProgress{double}, CancellationToken)"/> is called.
    /// </summary>
    [AddComponentMenu("Glint/Radar Controller")]
    [HelpPage("editor.md")]
    [RequireComponent(typeof(Camera))]
    [ExecuteAlways] // for OnDisable and OnDestroy in edit mode, which release the buffers
    [DisallowMultipleComponent]
    public sealed class RadarController : MonoBehaviour
    {
        [SerializeField, Tooltip("Carrier frequency in hertz.")]
        double _frequencyHz = 10e9;

        [SerializeField, Min(1), Tooltip("Rays across the view. With Rays Down it sets the aspect ratio.")]
        int _raysAcross = 1920;

        [SerializeField, Min(1), Tooltip("Rays down the view, over the Camera's field of view; for an orthographic "
            + "Camera over twice its Size.")]
        int _raysDown = 1080;

        [SerializeField, Tooltip("Only for an orthographic Camera: the rays just cover the traced objects, Ray "
            + "Spacing apart. The Camera's Size, Rays Across and Rays Down are then ignored.")]
        bool _fitAperture;

        [SerializeField, Tooltip("Distance between rays in metres, with Fit Aperture.")]
        double _raySpacing = 0.01;

        [SerializeField, Range(1, RadarSettings.BounceLimit), Tooltip("Maximum number of bounces of a ray.")]
        int _maxBounces = 4;

        [SerializeField, Min(0), Tooltip("Tolerance of the amplitude in decibels, such as 0.1: it is integrated over "
            + "ray tubes, and no single rays are kept. 0: one phasor a ray, as in the published experiment.")]
        double _toleranceDb;

        [SerializeField, Tooltip("Leaves out the estimate of the sampling error, which traces smaller rays around "
            + "received ones. A pose is faster, but undersampling is not detected.")]
        bool _skipSamplingError;

        [SerializeField, Tooltip("Centre of the receiver, which faces along this transform's forward axis. "
            + "It is neither target nor obstacle.")]
        Transform _receiver;

        [SerializeField, Tooltip("Width and height of the receiver in metres. 0 x 0 with an orthographic Camera: as "
            + "large as the aperture, and on its axis.")]
        Vector2 _receiverSize = new Vector2(3, 3);

        [SerializeField, Tooltip("Layers to trace.")]
        LayerMask _layers = ~0;

        [SerializeField, Tooltip("Objects to trace, with their children. Empty: everything in the loaded scenes.")]
        List<Transform> _roots = new List<Transform>();

        [SerializeField, Tooltip("Watched: meshes that scripts make at run time are read beside each pose, and a change "
            + "is always seen. Declared: they are not read, and a script that changes a mesh calls MarkChanged.")]
        MeshChanges _meshChanges;

        [SerializeField, Tooltip("Rays that a result stores one by one. All takes 48 bytes a ray.")]
        RayReadback _keptRays = RayReadback.Received;

        [SerializeField, Tooltip("Left and bottom edge, in rays, of the part of the picture to trace.")]
        Vector2Int _regionCorner;

        [SerializeField, Tooltip("Rays across and down of the part of the picture to trace; "
            + "other rays are not emitted. 0 x 0: the whole picture.")]
        Vector2Int _regionSize;

        [SerializeField, Tooltip("Packages/com.glint.radar/Shaders/Trace.compute")]
        ComputeShader _kernel;

        [SerializeField, Tooltip("Packages/com.glint.radar/Shaders/Amplitude.compute; only for a tolerance.")]
        ComputeShader _tubeKernel;

        [SerializeField, Tooltip("Packages/com.glint.radar/Shaders/Tubes.compute; only for a sea with clutter.")]
        ComputeShader _clutterKernel;

        static readonly ProfilerMarker s_gather = new ProfilerMarker("Glint.Gather");

        readonly SceneGatherer _gatherer = new SceneGatherer();
        readonly HashSet<string> _warned = new HashSet<string>();
        PlayWatch _play;
        RayTracer _tracer;
        AmplitudeTracer _amplitudes;
        CrossSectionTracer _crossSections; // of scenes with a sea that has clutter
        readonly List<PoseInFlight> _pending = new List<PoseInFlight>(); // of ray tubes: the first one finished traces all
        (ComputeShader, ComputeShader, ComputeShader)? _kernelsInUse; // of the tracers; null: there are none
        RadarPose _traced;
        ulong _tracedContent;

        /// <summary>
        /// Frequency, rays, bounces, tolerance, the part of the picture, and whether the sampling error is estimated.
        /// Checked when a pose is traced.
        /// </summary>
        public RadarSettings Settings
        {
            get => new RadarSettings
            {
                FrequencyHz = _frequencyHz, RaysAcross = _raysAcross, RaysDown = _raysDown, MaxBounces = _maxBounces,
                SkipSamplingError = _skipSamplingError, ToleranceDb = _toleranceDb,
                Region = new RayRegion
                {
                    Left = _regionCorner.x, Bottom = _regionCorner.y, Width = _regionSize.x, Height = _regionSize.y
                },
            };
            set
            {
                (_frequencyHz, _raysAcross, _raysDown, _maxBounces, _skipSamplingError) = (value.FrequencyHz,
                    value.RaysAcross, value.RaysDown, value.MaxBounces, value.SkipSamplingError);
                _toleranceDb = value.ToleranceDb;
                _regionCorner = new Vector2Int(value.Region.Left, value.Region.Bottom);
                _regionSize = new Vector2Int(value.Region.Width, value.Region.Height);
            }
        }

        /// <summary>
        /// With an orthographic Camera: the rays cover the traced objects, <see cref="RaySpacing"/> apart.
        /// The Camera's size and the rays across and down of <see cref="Settings"/> are then ignored.
        /// </summary>
        public bool FitAperture { get => _fitAperture; set => _fitAperture = value; }

        /// <summary>Distance from ray to ray with <see cref="FitAperture"/>, metres.</summary>
        public double RaySpacing { get => _raySpacing; set => _raySpacing = value; }

        /// <summary>Centre of the receiver, which faces along the transform's forward axis.</summary>
        public Transform Receiver { get => _receiver; set => _receiver = value; }

        /// <summary>
        /// Width and height of the receiver, metres. 0 x 0 with an orthographic Camera: those of the aperture, on its
        /// axis.
        /// </summary>
        public Vector2 ReceiverSize { get => _receiverSize; set => _receiverSize = value; }

        /// <summary>Layers to trace.</summary>
        public LayerMask Layers { get => _layers; set => _layers = value; }

        /// <summary>Objects to trace, with all below them; empty: everything in the loaded scenes.</summary>
        public List<Transform> Roots => _roots;

        /// <summary>
        /// How a pose learns that a mesh has changed. Its identity, counts and bounds are always compared, and <see
        /// cref="MarkChanged"/> is always heard.
        /// </summary>
        public MeshChanges MeshChanges { get => _meshChanges; set => _meshChanges = value; }

        /// <summary>Rays that a result carries.</summary>
        public RayReadback RayReadback { get => _keptRays; set => _keptRays = value; }

        /// <summary>Packages/com.glint.radar/Shaders/Trace.compute.</summary>
        public ComputeShader Kernel { get => _kernel; set => _kernel = value; }

        /// <summary>
        /// Packages/com.glint.radar/Shaders/Amplitude.compute; only used with
        /// <see cref="RadarSettings.ToleranceDb"/>.
        /// </summary>
        public ComputeShader TubeKernel { get => _tubeKernel; set => _tubeKernel = value; }

        /// <summary>
        /// Packages/com.glint.radar/Shaders/Tubes.compute; only used if a sea has clutter.
        /// </summary>
        public ComputeShader ClutterKernel { get => _clutterKernel; set => _clutterKernel = value; }

        /// <summary>
        /// Count the nodes visited and pairs tested: <see cref="TraceStatistics"/>. Slower; for benchmarks.
        /// </summary>
        public bool CountVisits { get; set; }

        /// <summary>Raised after each pose traced.</summary>
        public event Action<RadarController> Traced;

        /// <summary>The last pose traced; null before the first.</summary>
        public RadarResult Result { get; private set; }

        /// <summary>
        /// Traces the scene in its current state; returns when the sums are complete.
        /// The result carries the rays given by <see cref="RayReadback"/>.
        /// </summary>
        /// <param name="progress">Told how much of the pose is done, 0 to 1; may be null.</param>
        /// <param name="cancel">
        /// Ends the pose while trees are built or between two dispatches; the result before stays.
        /// </param>
        /// <exception cref="GlintException">
        /// The radar or a mesh is not fit to be traced, or the device cannot hold the work.
        /// </exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public RadarResult Trace(IProgress<double> progress = null, CancellationToken cancel = default) =>
            Trace(_keptRays, progress, cancel);

        /// <summary>Traces the scene in its current state; returns when the sums are complete.</summary>
        /// <param name="readback">Rays that the result carries; None is the fastest.</param>
        /// <param name="progress">Receives the fraction done, 0 to 1; may be null.</param>
        /// <param name="cancel">
        /// Ends the pose while trees are built or between two dispatches; the result before stays.
        /// </param>
        /// <exception cref="GlintException">
        /// The radar or a mesh is not fit to be traced, or the device cannot hold the work.
        /// </exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public RadarResult Trace(RayReadback readback, IProgress<double> progress = null,
            CancellationToken cancel = default) =>
            FinishTrace(StartTrace(readback, cancel), progress, cancel);

        /// <summary>
        /// Begins to trace the scene in its current state. The scene may change, and the next pose start, before it is
        /// finished.
        /// </summary>
        internal PoseInFlight StartTrace(RayReadback readback, CancellationToken cancel = default)
        {
            DropOldKernels();
            // Before the scene is gathered, which may take long.
            var settings = Describe().Settings;
            if (settings.ToleranceDb > 0)
                AmplitudeTracer.Check(_tubeKernel, Subject);
            else
            {
                _tracer ??= new RayTracer(_kernel, Subject);
                if (!IsFitted)
                    DispatchPlan.Check(settings, readback, Subject);
            }

            var inFlight = StartOnce(readback, cancel);
            // Beside the device's work.
            bool isCurrent = _gatherer.ConfirmMeshes();
            long bytesHashedBeside = _gatherer.BytesHashed - inFlight.Statistics.BytesHashed;
            // Once only: the second gather reads what has changed, and all else was just confirmed.
            if (!isCurrent)
            {
                Abandon(inFlight);
                inFlight = StartOnce(readback, cancel);
            }
            inFlight.Statistics.BytesHashedBeside = bytesHashedBeside;
            inFlight.Content = _gatherer.Content();
            return inFlight;
        }

        /// <summary>Computes the factors of seas with a published level for the scene as it is.</summary>
        /// <returns>False if no sea has such a level.</returns>
        internal bool SetClutterLevels()
        {
            var pose = Gather();
            if (pose.Scene.Seas.All(sea => sea.Clutter.Settings.Level == ClutterLevel.Physics))
                return false;
            CrossSections.SetLevels(CrossSectionPose.Of(pose));
            return true;
        }

        CrossSectionTracer CrossSections => _crossSections ??= new CrossSectionTracer(_clutterKernel, Subject);

        /// <summary>Waits for a pose; it becomes <see cref="Result"/>.</summary>
        internal RadarResult FinishTrace(PoseInFlight inFlight, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            var result = _pending.Contains(inFlight) ? FinishTubes(inFlight, progress, cancel)
                : _tracer.Finish(inFlight, progress, cancel);
            if (inFlight.Pose.Scene.Seas.Count > 0)
            {
                var echo = CrossSections.Trace(CrossSectionPose.Of(inFlight.Pose), progress, cancel);
                result = result.With(PoseEcho.Of(echo));
            }
            (_traced.Settings, _traced.View) = (inFlight.Pose.Settings, inFlight.Pose.View);
            _tracedContent = inFlight.Content;
            Result = result;
            if (Paths != null)
                Paths.Follow();
            Traced?.Invoke(this);
            return result;
        }

        // Traces it with all others that were started, which it does not depend on.
        RadarResult FinishTubes(PoseInFlight inFlight, IProgress<double> progress, CancellationToken cancel)
        {
            try
            {
                if (inFlight.Result == null)
                    TraceTubes(_pending.Where(pose => pose.Result == null).ToArray(), progress, cancel);
            }
            catch (GlintException) when (_pending.Count > 1)
            {
                // Another one may be at fault: its own step says so.
                TraceTubes(new[] { inFlight }, progress, cancel);
            }
            finally
            {
                _pending.Remove(inFlight);
            }
            return inFlight.Result;
        }

        void TraceTubes(PoseInFlight[] together, IProgress<double> progress, CancellationToken cancel)
        {
            var results = Tubes.Trace(Array.ConvertAll(together, pose => pose.Pose), progress, cancel,
                Array.ConvertAll(together, pose => pose.Statistics));
            for (int i = 0; i < together.Length; i++)
                together[i].Result = results[i];
        }

        /// <summary>Gives up a pose that will not be finished; may be null.</summary>
        internal void Abandon(PoseInFlight inFlight)
        {
            if (!_pending.Remove(inFlight))
                _tracer?.Abandon(inFlight);
        }

        /// <summary>Whether a pose was started and its buffers were not released since.</summary>
        internal bool IsInFlight(PoseInFlight inFlight) => inFlight != null
            && (_pending.Contains(inFlight) || _tracer != null && _tracer.IsInFlight(inFlight));

        /// <summary>
        /// Whether the next pose may start before this one is finished, beside others that were started. A script that
        /// listens to <see cref="Traced"/> finds the scene as it was traced, and so do ray paths that are shown.
        /// </summary>
        /// <param name="started">This one and the others.</param>
        internal bool MayOverlap(PoseInFlight inFlight, int started) =>
            Traced == null && (Paths == null || !Paths.NeedsScene) && (_pending.Contains(inFlight)
                ? inFlight.Result == null && started < Tubes.PosesTogether
                : started == 1 && _tracer.MayOverlap(inFlight));

        /// <summary>Traces poses that have a tolerance.</summary>
        internal AmplitudeTracer Tubes => _amplitudes ??= new AmplitudeTracer(_tubeKernel, Subject);

        /// <summary>Draws the rays of each pose; null: no component does.</summary>
        internal RayPaths Paths { get; set; }

        /// <summary>
        /// Pixels of the rays received in the last pose, in ascending order: x + y * rays across, from the lower left
        /// corner. Empty after <see cref="Release"/>. Ray tubes keep no single rays: with a tolerance one a pixel is
        /// traced now, through the scene in its current state.
        /// </summary>
        /// <param name="cancel">Cancels that trace between two dispatches.</param>
        /// <exception cref="GlintException">The radar or a mesh cannot be traced.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public uint[] ReceivedPixels(CancellationToken cancel = default)
        {
            if (Result != null && _traced.Settings.ToleranceDb > 0)
            {
                var pose = GatherForTracer();
                (pose.Settings.ToleranceDb, pose.Settings.SkipSamplingError) = (0, true);
                _tracer.Trace(pose, RayReadback.None, null, cancel);
            }
            return _tracer?.ReceivedPixels() ?? Array.Empty<uint>();
        }

        /// <summary>
        /// Traces the paths of single rays through the scene in its current state, with the objects that they hit
        /// (<see cref="ObjectAt"/>).
        /// </summary>
        /// <param name="pixels">
        /// x + y * rays across, from the lower left corner; for example <see cref="ReceivedPixels"/>.
        /// </param>
        /// <param name="progress">Receives the fraction done, 0 to 1; may be null.</param>
        /// <param name="cancel">Cancels between two dispatches.</param>
        /// <returns>
        /// A path for each pixel, in their order. Positions are in metres relative to the origin of the pose's scene.
        /// </returns>
        /// <exception cref="GlintException">
        /// The radar or a mesh cannot be traced, or a pixel is outside the picture.
        /// </exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public RayPath[] TracePaths(uint[] pixels, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            var pose = GatherForTracer();
            return _tracer.TracePaths(pose, pixels, progress, cancel);
        }

        /// <summary>
        /// Traces the radar's view of the scene in its current state, for display: about 130,000 rays over the part of
        /// the view that hits anything.
        /// </summary>
        /// <param name="cancel">Cancels between two dispatches.</param>
        /// <exception cref="GlintException">The radar or a mesh cannot be traced.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public RadarPreviewImage TracePreview(CancellationToken cancel = default)
        {
            var pose = GatherForTracer();
            return RadarPreviewTracer.Trace(_tracer, pose, cancel);
        }

        /// <summary>An object of the scene last gathered, by the number in a <see cref="PathHit"/>.</summary>
        /// <exception cref="ArgumentOutOfRangeException">
        /// There is no object of this number, or it is <see cref="MeshRange.NoObject"/>.
        /// </exception>
        public Transform ObjectAt(int number) => _gatherer.ObjectAt(number);

        /// <summary>
        /// Announces that a transform will move, so that its first motion causes no rebuild: what moves as a whole gets
        /// a mesh of its own. Unannounced motion is detected and costs one rebuild.
        /// </summary>
        public void ExpectMotion(Transform transform) => _gatherer.ExpectMotion(transform);

        /// <summary>
        /// Announces that a script has changed the vertices or indices of a mesh. Every radar reads it in its next pose.
        /// Needed for a mesh of <see cref="MeshMaker"/> that another script changes, for a stored mesh that is changed
        /// in edit mode without EditorUtility.SetDirty, and for every changed mesh if <see cref="MeshChanges"/> is
        /// Declared. A change of its counts or bounds is seen without it.
        /// </summary>
        /// <exception cref="GlintException">There is no mesh.</exception>
        public static void MarkChanged(Mesh mesh) => MeshWatch.MarkChanged(mesh);

        /// <summary>
        /// The pose of the scene in its current state: scene, settings and view.
        /// Scene and view are in the axes and metres of the world, relative to the nearest common ancestor of the
        /// radar, its receiver and all traced objects; without one, relative to the world's origin. Unchanged meshes
        /// are the same objects as in the last call.
        /// </summary>
        /// <exception cref="GlintException">The radar or a mesh cannot be traced.</exception>
        public RadarPose Gather() => Gather(confirmLater: false);

        /// <summary>
        /// The same by another gatherer, which warns of objects that are not traced. This radar's own gatherer is not
        /// changed.
        /// </summary>
        public RadarPose Gather(SceneGatherer gatherer) => Gather(gatherer, false);

        RadarPose Gather(bool confirmLater)
        {
            try
            {
                return Gather(_gatherer, confirmLater);
            }
            finally
            {
                foreach (string warning in _gatherer.Warnings)
                    if (_warned.Add(warning))
                        Debug.LogWarning($"{Subject}: {warning}", this);
            }
        }

        RadarPose Gather(SceneGatherer gatherer, bool confirmLater)
        {
            var pose = Describe();
            if (_roots.Exists(root => root == null))
                throw new GlintException(HasEmptyRoot);
            gatherer.MeshChanges = _meshChanges;
            pose.Scene = gatherer.Gather(_layers, _roots, _receiver, transform, confirmLater);
            var radarFrame = PoseOf(gatherer, transform, "the radar");
            (pose.View.Position, pose.View.Right, pose.View.Up, pose.View.Forward) =
                (radarFrame.Origin, radarFrame.X, radarFrame.Y, radarFrame.Z);
            radarFrame = PoseOf(gatherer, _receiver, $"its receiver '{_receiver.name}'");
            (pose.View.ReceiverCentre, pose.View.ReceiverRight, pose.View.ReceiverUp, pose.View.ReceiverForward) =
                (radarFrame.Origin, radarFrame.X, radarFrame.Y, radarFrame.Z);
            if (IsFitted)
                ApertureFit.Cover(ref pose, _raySpacing, Subject);
            if (MatchesAperture(pose.View))
                ApertureFit.MatchReceiver(ref pose);
            return pose;
        }

        /// <summary>
        /// Whether the pose just gathered by <see cref="Gather()"/> is that of <see cref="Result"/>: the same meshes,
        /// transforms, radar and rays.
        /// </summary>
        internal bool IsAsTraced(in RadarPose pose) => Result != null && pose.Settings.Equals(_traced.Settings)
            && pose.View.Equals(_traced.View) && _gatherer.Content() == _tracedContent;

        /// <summary>The scene's gatherer.</summary>
        internal SceneGatherer Gatherer => _gatherer;

        /// <summary>Objects with a mesh in the last <see cref="Gather()"/>.</summary>
        internal int ObjectCount => _gatherer.ObjectCount;

        /// <summary>Releases the GPU's buffers and the gathered scene; the next pose recreates them.</summary>
        public void Release()
        {
            _gatherer.Forget();
            _tracer?.Dispose();
            _amplitudes?.Dispose();
            _crossSections?.Dispose();
            _pending.Clear();
            (_tracer, _amplitudes, _crossSections, _kernelsInUse) = (null, null, null, null);
        }

        /// <summary>Name in messages.</summary>
        public string Subject => $"RadarController of '{name}'";

        /// <summary>Message about a radar without receiver.</summary>
        public string HasNoReceiver =>
            $"{Subject} has no receiver: assign a Transform behind the camera to its field Receiver";

        /// <summary>Message about a radar without camera.</summary>
        public string HasNoCamera => $"'{name}' has a RadarController and no Camera: add one, its position, "
            + "rotation and field of view are the radar's";

        /// <summary>Message about an orthographic camera whose size is not positive.</summary>
        public string HasNoHeight => FormattableString.Invariant(
            $"the Camera of '{name}' is orthographic and its Size is {GetComponent<Camera>().orthographicSize}: give it half the aperture's height in metres, above 0");

        /// <summary>Message about an empty entry of Roots.</summary>
        public string HasEmptyRoot => $"{Subject}: an entry of Roots is empty: assign an object or remove the entry";

        /// <summary>Whether the aperture is fitted for each pose.</summary>
        public bool IsFitted => _fitAperture && GetComponent<Camera>().orthographic;

        // The scene as the gatherer takes it; watched meshes are not confirmed yet.
        PoseInFlight StartOnce(RayReadback readback, CancellationToken cancel)
        {
            var watch = Stopwatch.StartNew();
            RadarPose pose;
            using (s_gather.Auto())
                pose = Gather(confirmLater: true);
            if (pose.Scene.Seas.Count > 0 && _clutterKernel == null)
                throw new GlintException($"{Subject}: a sea with clutter needs the kernels of cross sections: assign "
                    + "Packages/com.glint.radar/Shaders/Tubes.compute to Clutter Kernel");
            var statistics = new TraceStatistics
            {
                Objects = _gatherer.ObjectCount, BytesHashed = _gatherer.BytesHashed,
                Timings = new Timings { GatherMs = watch.Elapsed.TotalMilliseconds }
            };
            if (pose.Settings.ToleranceDb > 0)
            {
                var inFlight = new PoseInFlight { Pose = pose, Readback = readback, Statistics = statistics };
                _pending.Add(inFlight);
                return inFlight;
            }
            _tracer.CountVisits = CountVisits;
            return _tracer.Start(pose, readback, cancel, statistics);
        }

        // Tracers of kernels that were assigned before; the inspector and Undo write the fields.
        void DropOldKernels()
        {
            var kernels = (_kernel, _tubeKernel, _clutterKernel);
            if (_kernelsInUse != null && _kernelsInUse != kernels)
                Release();
            _kernelsInUse = kernels;
        }

        RadarPose GatherForTracer()
        {
            DropOldKernels();
            var pose = Gather();
            _tracer ??= new RayTracer(_kernel, Subject);
            return pose;
        }

        Affine PoseOf(SceneGatherer gatherer, Transform node, string role)
        {
            var pose = gatherer.PoseOf(node);
            FiniteCheck.RefuseNotFinite(pose, node, $"{Subject}: {role}");
            return pose;
        }

        bool MatchesAperture(in RadarView view) => view.IsParallel && _receiverSize.x == 0 && _receiverSize.y == 0;

        // Everything that does not depend on transforms, validated. A fitted aperture has an arbitrary size here.
        RadarPose Describe()
        {
            if (_receiver == null)
                throw new GlintException(HasNoReceiver);
            if (!TryGetComponent<Camera>(out var camera))
                throw new GlintException(HasNoCamera);
            if (IsFitted)
                ApertureFit.CheckSpacing(_raySpacing, Subject);
            else if (camera.orthographic && !(camera.orthographicSize > 0))
                throw new GlintException(HasNoHeight);

            var pose = new RadarPose { Settings = Settings };
            pose.View.VerticalFovDegrees = camera.fieldOfView;
            pose.View.ApertureHeight = IsFitted ? _raySpacing : camera.orthographic ? 2.0 * camera.orthographicSize : 0;
            pose.View.ReceiverSize = (float2)_receiverSize;
            if (MatchesAperture(pose.View))
                ApertureFit.MatchReceiver(ref pose);
            var settings = pose.Settings;
            if (IsFitted)
                settings.Region = default; // the region refers to the fitted picture, which is not known yet
            settings.Validate(Subject);
            pose.View.Validate(Subject);
            return pose;
        }

        // In the editor, when the component is added or reset. RequireComponent adds the Camera; the kernel is among the
        // default references of this script.
        void Reset() => _receiver = transform.Find(MeshFileScene.ReceiverName);

        void Start() => TraceOnPlay();

        void Update() => TraceOnPlay();

        void TraceOnPlay()
        {
            if (!_play.Begins(this))
                return;
            try
            {
                var result = Trace();
                Debug.Log(FormattableString.Invariant(
                    $"{Subject}: amplitude {result.Amplitude:g7}, {result.RaysReceived} of {result.RaysHit} rays that hit were received"),
                    this);
                if (result.Undersampled)
                    Debug.LogWarning($"{Subject}: the amplitude is unreliable: its rays are too far apart, "
                        + "or too few return; give it more rays or a narrower view", this);
            }
            catch (GlintException problem)
            {
                Debug.LogError(problem.Message, this);
            }
        }

        void OnEnable() => _play.Enable(this);

        void OnDisable() => Release();

        // A radar traced while disabled gets no OnDisable.
        void OnDestroy() => Release();
    }
}
