using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Glint
{
    /// <summary>
    /// A radar screen (PPI) that turns while the scene plays. The antenna is at this object's position and turns
    /// clockwise; <see cref="Picture"/> is a texture for UI Toolkit, uGUI and materials. It shows the meshes of the scene,
    /// each enabled <see cref="RadarReflector"/>, the sea, rain and noise. Everything runs on the device, and the main
    /// thread never waits for it.
    /// </summary>
    [AddComponentMenu("Glint/Radar Screen")]
    [HelpPage("screen.md")]
    [ExecuteAlways] // so that buffers are released in edit mode too
    [DisallowMultipleComponent]
    public sealed class RadarScreen : MonoBehaviour
    {
        [SerializeField, Tooltip("Own ship: its forward axis is the heading. Empty: this object.")]
        Transform _ownShip;

        [SerializeField, Tooltip("Sea around the radar, with clutter. It is endless for the screen, whatever its extent. "
            + "Empty: none.")]
        Sea _sea;

        [SerializeField, Tooltip("Layers whose meshes are traced. Seas are not among them.")]
        LayerMask _layers = ~0;

        [SerializeField, Tooltip("Transmitter, antenna and range cells. A change starts the picture again.")]
        ScreenRadar _radar = ScreenRadar.Default;

        [SerializeField, Tooltip("Levels of the antenna, where the radar's Pattern is Table: CSV with the columns "
            + "angle_deg, azimuth_db and elevation_db.")]
        TextAsset _patternTable;

        [SerializeField, Tooltip("Controls of the receiver.")]
        ScreenReceiver _receiver = ScreenReceiver.Default;

        [SerializeField, Tooltip("How the picture is drawn.")]
        ScreenDisplay _display = ScreenDisplay.Default;

        [SerializeField, Tooltip("How ReadDetections finds targets.")]
        ScreenDetection _detection = ScreenDetection.Default;

        [SerializeField, Tooltip("Colour outside of the range scale.")]
        Color _outside = new Color(0.09f, 0.1f, 0.12f);

        [SerializeField, Tooltip("Colour without echo.")]
        Color _background = new Color(0.01f, 0.03f, 0.08f);

        [SerializeField, Tooltip("Colour of full video.")]
        Color _echo = new Color(1, 0.85f, 0.1f);

        [SerializeField, Tooltip("Colour of full trails.")]
        Color _trail = new Color(0.1f, 0.35f, 0.8f);

        [SerializeField, Tooltip("Colour of the range rings.")]
        Color _rings = new Color(0.1f, 0.35f, 0.25f);

        [SerializeField, Tooltip("Colour of the heading line.")]
        Color _heading = new Color(0.8f, 0.8f, 0.8f);

        [SerializeField, Tooltip("Colour of bearing line and range marker.")]
        Color _marker = new Color(0.2f, 0.8f, 0.9f);

        [SerializeField, Tooltip("Packages/com.glint.radar/Shaders/Screen.compute.")]
        ComputeShader _kernel;

        [SerializeField, Tooltip("Packages/com.glint.radar/Shaders/SeaField.compute.")]
        ComputeShader _seaKernel;

        ScreenTracer _tracer;
        RenderTexture _picture;
        Compass _compass;
        ScreenSea _waves;
        FollowedScene _scene;
        readonly HashSet<string> _warned = new HashSet<string>();
        ScreenTargets _targets;
        ScreenPoint[] _points = new ScreenPoint[16];
        OtherRadar[] _others = new OtherRadar[4];
        Vector3 _tileMiddle;
        double _turns, _headingTurns;
        // Stale: the turn begins again. Changed: settings are checked.
        bool _isStale, _isChanged, _hasFailed;
        (Sea, ComputeShader, ComputeShader, TextAsset) _madeOf;
        (int layers, Transform ownShip) _gatheredOf;

        /// <summary>
        /// The picture, which stays the same object until the component is destroyed or its size changes; null where
        /// the device cannot draw into textures, where <see cref="ReadPicture"/> has it, and before the first frame.
        /// </summary>
        public Texture Picture => _picture;

        /// <summary>Own ship, whose forward axis is the heading; null: this object.</summary>
        public Transform OwnShip
        {
            get => _ownShip;
            set => (_ownShip, _hasFailed) = (value, false);
        }

        /// <summary>Bytes on the device of the meshes, their BVHs and their points.</summary>
        public long MeshBytes => _targets?.Bytes ?? 0;

        /// <summary>Layers whose meshes are traced, except those of seas.</summary>
        public LayerMask Layers
        {
            get => _layers;
            set => (_layers, _hasFailed) = (value, false);
        }

        /// <summary>Meshes that are traced; 0 before the first frame.</summary>
        public int ObjectCount => _scene?.Scene?.Instances.Length ?? 0;

        /// <summary>Their triangles.</summary>
        public long TriangleCount => _scene?.Scene?.TriangleCount ?? 0;

        /// <summary>Points of the meshes' surfaces that echo; 0 before the first frame.</summary>
        public int PointCount => _targets?.Count ?? 0;

        /// <summary>
        /// Distance of these points on large objects, metres: half a cell, or more if the points were too many.
        /// </summary>
        public double PointSpacing => _targets?.Spacing ?? 0;

        /// <summary>
        /// Sea around the radar; null: none. It is endless for the screen. A change of its settings is seen when the
        /// picture starts again, its time at once.
        /// </summary>
        public Sea Sea
        {
            get => _sea;
            set => (_sea, _isStale) = (value, true);
        }

        /// <summary>Transmitter, antenna and range cells. Another radar starts the picture again.</summary>
        /// <exception cref="GlintException">A setting is out of its range.</exception>
        public ScreenRadar Radar
        {
            get => _radar;
            set
            {
                value.Validate(Subject);
                (_radar, _isStale) = (value, true);
            }
        }

        /// <summary>
        /// The antenna's levels, where the <see cref="Radar"/> has the pattern <see cref="ScreenPattern.Table"/>: a CSV
        /// file whose first line is angle_deg,azimuth_db,elevation_db.
        /// </summary>
        public TextAsset PatternTable { get => _patternTable; set => (_patternTable, _isStale) = (value, true); }

        /// <summary>Controls of the receiver.</summary>
        /// <inheritdoc cref="Radar" path="/exception"/>
        public ScreenReceiver Receiver
        {
            get => _receiver;
            set
            {
                value.Validate(Subject);
                _receiver = value;
            }
        }

        /// <summary>How the picture is drawn.</summary>
        /// <inheritdoc cref="Radar" path="/exception"/>
        public ScreenDisplay Display
        {
            get => _display;
            set
            {
                value.Validate(Subject);
                _isStale |= value.Side != _display.Side;
                _display = value;
            }
        }

        /// <summary>How <see cref="ReadDetections"/> finds targets.</summary>
        /// <inheritdoc cref="Radar" path="/exception"/>
        public ScreenDetection Detection
        {
            get => _detection;
            set
            {
                value.Validate(Subject);
                _detection = value;
            }
        }

        /// <summary>Packages/com.glint.radar/Shaders/Screen.compute.</summary>
        public ComputeShader Kernel { get => _kernel; set => (_kernel, _isStale) = (value, true); }

        /// <summary>Packages/com.glint.radar/Shaders/SeaField.compute; only with a sea.</summary>
        public ComputeShader SeaKernel { get => _seaKernel; set => (_seaKernel, _isStale) = (value, true); }

        /// <summary>True bearing of the antenna in degrees from 0 to 360, clockwise from north.</summary>
        public double AntennaDegrees => 360 * (_turns - Math.Floor(_turns));

        /// <summary>True heading of the own ship in degrees from 0 to 360.</summary>
        public double HeadingDegrees => 360 * (_headingTurns - Math.Floor(_headingTurns));

        /// <summary>Spokes, cells and levels of the turn that is shown; null before the first frame.</summary>
        public ScreenGeometry Geometry => _tracer?.Geometry;

        /// <summary>Spokes, cells and levels of the settings.</summary>
        /// <inheritdoc cref="Radar" path="/exception"/>
        public ScreenGeometry NewGeometry() => new ScreenGeometry(_radar, Subject, TableText);

        internal ScreenTracer Tracer => _tracer;

        Transform Own => _ownShip == null ? transform : _ownShip;

        string Subject => $"RadarScreen of '{name}'";

        string TableText => _patternTable == null ? null : _patternTable.text;

        /// <summary>
        /// Reads the scene's meshes again in the next frame: after new objects, and after changes of meshes, materials
        /// or layers. That objects have moved or gone is seen without it.
        /// </summary>
        public void GatherAgain() => (_gatheredOf, _hasFailed) = (default, false);

        /// <summary>
        /// Reads the levels of a turn, dB over noise, spoke by spoke. It waits for the device: not for each frame.
        /// </summary>
        /// <exception cref="GlintException">There was no frame yet.</exception>
        public float[] ReadLevels()
        {
            var levels = new float[Ready().Levels.Capacity];
            _tracer.Levels.ReadBack(levels, levels.Length);
            return levels;
        }

        /// <summary>
        /// Reads the levels of a turn and detects targets on the processor. It waits for the device: not for each frame.
        /// </summary>
        /// <inheritdoc cref="ReadLevels" path="/exception"/>
        public List<ScreenDetected> ReadDetections() => _detection.Detect(Ready().Geometry, ReadLevels());

        /// <summary>
        /// Reads the video of a turn, 0 to 1, spoke by spoke: with persistence, and without. It waits for the device.
        /// </summary>
        /// <inheritdoc cref="ReadLevels" path="/exception"/>
        public float2[] ReadVideo()
        {
            var video = new float2[Ready().Video.Capacity];
            _tracer.Video.ReadBack(video, video.Length);
            return video;
        }

        /// <summary>
        /// Reads the video of the spokes that the last frame finished, as <see cref="ReadVideo"/>.
        /// </summary>
        /// <param name="first">Number of the first spoke, counted from north in the first turn.</param>
        /// <inheritdoc cref="ReadLevels" path="/exception"/>
        public float2[] ReadFrame(out long first)
        {
            first = Ready().Slice.FirstFinished;
            return _tracer.ReadFrame();
        }

        /// <summary>
        /// The picture as bytes of red, green, blue and 255, row by row from the bottom, computed by the processor from
        /// the device's video. It waits for the device, and is the way where <see cref="Picture"/> is null.
        /// </summary>
        /// <inheritdoc cref="ReadLevels" path="/exception"/>
        public byte[] ReadPicture()
        {
            var trails = new float[Ready().Trails.Capacity];
            _tracer.Trails.ReadBack(trails, trails.Length);
            return new ScreenPicture(_tracer.Geometry, View(), ReadVideo(), trails).Draw();
        }

        /// <summary>Colours the pixels of detections as bearing line and range marker.</summary>
        /// <param name="picture">Bytes of <see cref="ReadPicture"/>, or of <see cref="Picture"/>.</param>
        /// <inheritdoc cref="ReadLevels" path="/exception"/>
        public void Mark(byte[] picture, IEnumerable<ScreenDetected> detections)
        {
            double scale = Ready().Geometry.Radar.RangeScale;
            var view = View();
            foreach (var detected in detections)
                view.Mark(picture, detected.BearingDegrees / 360, detected.Range / scale);
        }

        /// <summary>Advances the antenna, traces what it comes to, and draws; Unity's Update calls it.</summary>
        /// <param name="seconds">Since the frame before.</param>
        /// <exception cref="GlintException">
        /// A setting is out of its range, the device lacks something, or the time is negative or not finite.
        /// </exception>
        public void Advance(double seconds)
        {
            if (!(seconds >= 0 && seconds < double.PositiveInfinity))
                throw new GlintException(FormattableString.Invariant(
                    $"{Subject}: a frame of {seconds} s: give a time of 0 or more"));
            Prepare();
            double before = _headingTurns;
            _headingTurns = Heading();
            _turns += seconds * _radar.TurnsAMinute / 60 + Math.IEEERemainder(_headingTurns - before, 1);
            FollowTargets();
            _tracer.Begin(_turns);
            AddSea();
            AddTargets();
            int points = GatherPoints();
            _tracer.AddPoints(_points, points, _waves != null);
            _tracer.AddRain();
            SetOtherRadars();
            _tracer.Finish(_receiver, FromWorld(transform.position).xz, _headingTurns);
            if (_picture == null)
                return;
            // A device that was lost takes the texture with it.
            if (!_picture.IsCreated())
                _picture.Create();
            _tracer.Draw(_picture, View(), QualitySettings.activeColorSpace == ColorSpace.Linear);
        }

        void Update()
        {
            if (!Application.IsPlaying(gameObject) || _hasFailed && !_isStale)
                return;
            try
            {
                Advance(Time.deltaTime);
                _hasFailed = false;
            }
            catch (GlintException problem)
            {
                // Once, until a setting changes.
                (_hasFailed, _isStale) = (true, false);
                Debug.LogError(problem.Message, this);
            }
        }

        /// <summary>Refuses settings out of their ranges, and kernels that are missing.</summary>
        /// <exception cref="GlintException">The message says which, and the way out.</exception>
        public void Check()
        {
            NewGeometry();
            _receiver.Validate(Subject);
            _display.Validate(Subject);
            _detection.Validate(Subject);
            DeviceCheck.Require(_kernel, "Screen", "ScreenBeam", Subject);
            // It refuses a sea that is tilted, too.
            if (_sea != null && _sea.CurrentClutter() == null)
                throw new GlintException($"{Subject}: its sea '{_sea.name}' has no clutter: turn Clutter on, or leave "
                    + "Sea empty");
        }

        void Prepare()
        {
            // A sea may be destroyed while the screen runs.
            bool lostSea = _waves != null && _sea == null;
            if (_tracer != null && !_isStale && !lostSea)
            {
                if (_isChanged)
                    Check();
                _isChanged = false;
                return;
            }
            (_isStale, _isChanged) = (false, false);
            Release();
            Check();
            try
            {
                Make();
            }
            catch
            {
                Release();
                throw;
            }
        }

        void Make()
        {
            FiniteCheck.RefuseNotFinite(transform, Subject);
            if (_ownShip != null)
                FiniteCheck.RefuseNotFinite(_ownShip, Subject);
            _compass = Compass.Find(Subject);
            double height = transform.position.y - SeaLevel;
            if (height < 0)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{Subject}: its antenna is {-height:0.##} m below the mean level of the sea, which hides nearly everything: move it up, or the sea down"), this);
            _tracer = new ScreenTracer(_kernel, Subject, _radar, TableText);
            _headingTurns = Heading();
            // Up to the first pass of north below 0.
            _turns = _headingTurns - Math.Ceiling(_headingTurns);
            _madeOf = (_sea, _kernel, _seaKernel, _patternTable);
            MakeSea();
            (_scene, _targets) = (new FollowedScene(), new ScreenTargets(Subject, _tracer.Geometry));
            GatherTargets();
            MakePicture();
        }

        void MakePicture()
        {
            if (!ScreenTracer.CanDraw)
            {
                Debug.LogWarning($"{Subject}: {SystemInfo.graphicsDeviceName} does not draw into textures of the format "
                    + "R8G8B8A8_UNorm: Picture is empty, use ReadPicture", this);
                return;
            }
            if (_picture != null && _picture.width != _display.Side)
            {
                MadeObject.Free(_picture);
                _picture = null;
            }
            if (_picture == null)
                _picture = new RenderTexture(_display.Side, _display.Side, 0, GraphicsFormat.R8G8B8A8_UNorm)
                {
                    name = "Radar Screen", enableRandomWrite = true, hideFlags = HideFlags.DontSave
                };
            _picture.Create();
        }

        void MakeSea()
        {
            if (_sea == null)
                return;
            _tileMiddle = _sea.TileMiddle();
            _waves = new ScreenSea(_seaKernel, Subject, _tracer.Geometry, _sea.ShownWaves, _sea.Clutter);
        }

        void AddSea()
        {
            if (_waves == null || _tracer.Slice.Traced == 0)
                return;
            _waves.Update(_sea.ShownTime);
            _tracer.AddSea(_waves, (float3)(_sea.transform.InverseTransformPoint(transform.position) - _tileMiddle),
                NorthTurns() - Compass.TurnsOf(_sea.transform.forward));
        }

        void GatherTargets()
        {
            // Until everything is complete.
            _gatheredOf = default;
            try
            {
                _scene.Gather(_layers, Own);
            }
            catch (GlintException refusal)
            {
                throw new GlintException($"{Subject}: {refusal.Message}; or take its layer out of Layers", refusal);
            }
            _targets.SetScene(_scene.Scene, _scene.IsOwnShip);
            foreach (string warning in _scene.Warnings.Where(_warned.Add))
                Debug.LogWarning($"{Subject}: {warning}", this);
            _gatheredOf = (_layers, Own);
        }

        void FollowTargets()
        {
            if (_gatheredOf != (_layers.value, Own) || !_scene.Follow(out bool hasMoved))
                GatherTargets();
            else if (hasMoved)
                _targets.Move();
        }

        void AddTargets()
        {
            if (_tracer.Slice.Traced > 0)
                _tracer.AddTargets(_targets, (float3)transform.position, SeaLevel, NorthTurns(), _waves != null);
        }

        // Those in the spokes of the frame.
        int GatherPoints()
        {
            var reflectors = RadarReflector.Enabled;
            if (_points.Length < reflectors.Count)
                _points = new ScreenPoint[2 * reflectors.Count];
            var antenna = FromWorld(transform.position);
            int count = 0;
            for (int i = 0; i < reflectors.Count; i++)
            {
                var position = FromWorld(reflectors[i].transform.position);
                if (IsBeside(reflectors[i]) && _tracer.IsTraced(_tracer.Geometry.SpokeOf(position - antenna)))
                    _points[count++] = _tracer.Geometry.PointOf(position, antenna, reflectors[i].CrossSection);
            }
            return count;
        }

        void SetOtherRadars()
        {
            var others = InterferingRadar.Enabled;
            if (_others.Length < others.Count)
                _others = new OtherRadar[2 * others.Count];
            var antenna = FromWorld(transform.position);
            int count = 0;
            for (int i = 0; i < others.Count; i++)
                if (IsBeside(others[i]))
                    _others[count++] = others[i].Seen(FromWorld(others[i].transform.position) - antenna, antenna.y);
            _tracer.SetOtherRadars(_others, count);
        }

        // A prefab that is open for editing while the scene plays is no part of it.
        bool IsBeside(Component other) =>
            Application.IsPlaying(other.gameObject) == Application.IsPlaying(gameObject);

        // Position with north as +Z and the sea at 0.
        double3 FromWorld(Vector3 position)
        {
            double north = NorthTurns() * 2 * Math.PI, cosine = Math.Cos(north), sine = Math.Sin(north);
            return new double3(position.x * cosine - position.z * sine, position.y - SeaLevel,
                position.x * sine + position.z * cosine);
        }

        double SeaLevel => _sea == null ? 0 : _sea.transform.position.y;

        double Heading() => Compass.TurnsOf(Own.forward) - NorthTurns();

        double NorthTurns() => _compass == null ? 0 : _compass.NorthTurns;

        ScreenView View() => ScreenView.Of(_tracer.Geometry, _display, _receiver, new ScreenColours
        {
            Outside = Of(_outside), Background = Of(_background), Echo = Of(_echo), Trail = Of(_trail),
            Rings = Of(_rings), Heading = Of(_heading), Marker = Of(_marker)
        }, _headingTurns, _tracer.Front - 1, _tracer.TrailMiddle);

        static double3 Of(Color colour) => new double3(colour.r, colour.g, colour.b);

        ScreenTracer Ready() => _tracer
            ?? throw new GlintException($"{Subject} has no turn yet: let the scene play a frame, or call Advance");

        // Controls of receiver and display act at once; only other settings start the turn again.
        void OnValidate()
        {
            (_hasFailed, _isChanged) = (false, true);
            _isStale = _isStale || _tracer == null || !_tracer.Geometry.Radar.Equals(_radar)
                || _madeOf != (_sea, _kernel, _seaKernel, _patternTable) || _picture != null && _picture.width != _display.Side;
        }

        void OnDisable()
        {
            _hasFailed = false;
            Release();
            if (_picture != null)
                _picture.Release();
        }

        void OnDestroy()
        {
            if (_picture != null)
                MadeObject.Free(_picture);
        }

        void Release()
        {
            _waves?.Dispose();
            _targets?.Dispose();
            _tracer?.Dispose();
            (_waves, _targets, _tracer) = (null, null, null);
        }
    }
}
