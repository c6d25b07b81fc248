using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>
    /// Draws the paths of the radar's rays in Scene and Game view: the segments red, green, blue and yellow in this
    /// order, and the receiver white. The paths are those of the last pose. They are traced only when a camera shows
    /// them, and not if the scene has changed since the pose.
    /// </summary>
    [AddComponentMenu("Glint/Ray Paths")]
    [HelpPage("editor.md")]
    [RequireComponent(typeof(RadarController))]
    [ExecuteAlways]
    [DisallowMultipleComponent]
    public sealed class RayPaths : MonoBehaviour
    {
        /// <summary>Maximum number of rays traced; of more, this number is evenly chosen.</summary>
        public const int MaxRays = 100000;

        [SerializeField, Tooltip("Only rays that reach the receiver. Otherwise rays of the whole picture.")]
        bool _receivedOnly = true;

        [SerializeField, Min(1), Tooltip("Every n-th of these rays.")]
        int _every = 1;

        [SerializeField, Range(1, RadarSettings.BounceLimit), Tooltip("Minimum number of bounces of a drawn ray.")]
        int _fewestBounces = 1;

        [SerializeField, Range(1, RadarSettings.BounceLimit), Tooltip("Maximum number of bounces of a drawn ray.")]
        int _mostBounces = RadarSettings.BounceLimit;

        [SerializeField, Tooltip("Only rays that hit this object or one of its children. Empty: all rays.")]
        Transform _meeting;

        [SerializeField, Tooltip("A cross at each point of reflection.")]
        bool _hitPoints;

        RadarController _radar;
        RayPath[] _paths = Array.Empty<RayPath>();
        uint[] _received; // null: unknown
        RadarPose _pose;
        Mesh _lines;
        Material _material;
        double3 _centre;
        (bool, int, Transform) _tracedFor;
        bool _isTraced, _isBuilt, _isSeen;

        /// <summary>Only received rays; otherwise rays from the whole picture.</summary>
        public bool ReceivedOnly { get => _receivedOnly; set => _receivedOnly = value; }

        /// <summary>Every n-th of these rays, from 1.</summary>
        public int Every { get => _every; set => _every = value; }

        /// <summary>Minimum number of bounces of the rays drawn.</summary>
        public int MinBounces { get => _fewestBounces; set => (_fewestBounces, _isBuilt) = (value, false); }

        /// <summary>Maximum number of bounces of the rays drawn.</summary>
        public int MaxBounces { get => _mostBounces; set => (_mostBounces, _isBuilt) = (value, false); }

        /// <summary>Only rays that hit this object or one below it; null: all rays.</summary>
        public Transform Meeting { get => _meeting; set => _meeting = value; }

        /// <summary>Draws a cross at each point of reflection.</summary>
        public bool HitPoints { get => _hitPoints; set => (_hitPoints, _isBuilt) = (value, false); }

        /// <summary>Rays drawn.</summary>
        public int Count { get; private set; }

        /// <summary>Rays not traced because there are more than <see cref="MaxRays"/>.</summary>
        public int LeftOut { get; private set; }

        /// <summary>
        /// Whether the scene or the radar has changed since the pose, or the radar was released: no rays are drawn
        /// until the next pose.
        /// </summary>
        public bool IsOutdated { get; private set; }

        /// <summary>
        /// The lines drawn, two vertices each, relative to a point near their centre; null before the first pose.
        /// Updates them if necessary.
        /// </summary>
        /// <exception cref="GlintException">The radar or a mesh cannot be traced any more.</exception>
        public Mesh Lines()
        {
            if (!_isTraced || _tracedFor != TracingFilters)
                Trace();
            if (!_isBuilt)
                Build();
            return _lines;
        }

        void OnEnable()
        {
            _radar = GetComponent<RadarController>();
            _radar.Paths = this;
            Camera.onPreCull += Draw;
            RenderPipelineManager.beginCameraRendering += Draw;
            (_isTraced, _isSeen, _received) = (false, false, null);
        }

        void OnDisable()
        {
            _radar.Paths = null;
            Camera.onPreCull -= Draw;
            RenderPipelineManager.beginCameraRendering -= Draw;
            MadeObject.Free(_lines);
            MadeObject.Free(_material);
            (_lines, _material, _paths) = (null, null, Array.Empty<RayPath>());
        }

        void OnValidate() => _isBuilt = false;

        /// <summary>Whether the next pose is shown at once, for which the scene must be as it was traced.</summary>
        internal bool NeedsScene => _isSeen;

        /// <summary>
        /// A pose was traced. Prepares its lines immediately if the last pose was shown: the next pose of a sweep, or
        /// its end, changes the scene.
        /// </summary>
        internal void Follow()
        {
            (_isTraced, _received) = (false, null);
            if (_isSeen)
                Prepare();
            _isSeen = false;
        }

        void Draw(ScriptableRenderContext context, Camera camera) => Draw(camera);

        void Draw(Camera camera)
        {
            if (camera.cameraType != CameraType.Game && camera.cameraType != CameraType.SceneView)
                return;
            // A prefab that is open shows its own scene.
            if (camera.cameraType == CameraType.SceneView && camera.scene.IsValid() && camera.scene != gameObject.scene)
                return;
            _isSeen = true;
            if (Prepare() == null)
                return;
            double3 position = _pose.Scene.Origin + _centre;
            var box = _lines.bounds;
            Graphics.RenderMesh(new RenderParams(Lit())
            {
                camera = camera, layer = gameObject.layer,
                worldBounds = new Bounds((Vector3)(float3)position + box.center, box.size)
            }, _lines, 0, Matrix4x4.Translate((float3)position));
        }

        // The lines; null if there are none or the radar cannot be traced. That is reported once; the next pose, or a
        // changed setting, tries again.
        Mesh Prepare()
        {
            try
            {
                return Lines();
            }
            catch (GlintException problem)
            {
                Build(); // of no paths
                Debug.LogWarning($"Ray Paths of '{name}': {problem.Message}", this);
                return null;
            }
        }

        // Filters that select the rays traced; the other filters select among these.
        (bool, int, Transform) TracingFilters => (_receivedOnly, _every, _meeting);

        // Nothing to show before the first pose.
        void Trace()
        {
            (_isTraced, _isBuilt, _tracedFor) = (true, false, TracingFilters);
            (_paths, LeftOut, IsOutdated) = (Array.Empty<RayPath>(), 0, false);
            if (_radar.Result == null)
                return;
            _pose = _radar.Gather();
            IsOutdated = !_radar.IsAsTraced(_pose) || _receivedOnly && !FindReceived();
            if (IsOutdated)
                return;
            var pixels = Chosen(_receivedOnly ? _received : null);
            if (pixels.Length > 0)
                _paths = Array.FindAll(_radar.TracePaths(pixels), IsMeant);
        }

        // False if a released radar has lost them. Ray tubes count other rays than those of pixels.
        bool FindReceived()
        {
            if (_received == null)
            {
                var pixels = _radar.ReceivedPixels();
                if (_pose.Settings.ToleranceDb > 0 || pixels.Length == _radar.Result.RaysReceived)
                    _received = pixels;
            }
            return _received != null;
        }

        // Every n-th ray, evenly reduced to the maximum. Pixels: null for the whole picture.
        uint[] Chosen(uint[] pixels)
        {
            long all = (pixels?.Length ?? _pose.Settings.RayCount) / math.max(1, _every),
                count = math.min(all, MaxRays);
            LeftOut = (int)math.min(int.MaxValue, all - count);
            var chosen = new uint[count];
            for (long i = 0; i < count; i++)
            {
                long index = i * all / count * math.max(1, _every);
                chosen[i] = pixels?[index] ?? (uint)index;
            }
            return chosen;
        }

        void Build()
        {
            _isBuilt = true;
            // Without a scene the first pose could not be gathered.
            if (_radar.Result == null || _pose.Scene == null)
                return;
            if (_lines == null)
                _lines = new Mesh
                {
                    name = "Ray Paths", hideFlags = HideFlags.HideAndDontSave, indexFormat = IndexFormat.UInt32
                };
            var shown = Array.FindAll(_paths, IsShown);
            Count = shown.Length;
            _centre = new PathLines(_pose.View, shown, _hitPoints).WriteTo(_lines);
        }

        bool IsMeant(RayPath path) =>
            (path.IsReceived || !_receivedOnly) && (_meeting == null
                || path.Meets(number => number != MeshRange.NoObject && _radar.ObjectAt(number).IsChildOf(_meeting)));

        bool IsShown(RayPath path) => path.Bounces >= _fewestBounces && path.Bounces <= _mostBounces;

        // Unity's own material for coloured lines, for every render pipeline except HDRP.
        Material Lit()
        {
            if (_material == null)
                _material =
                    new Material(Shader.Find("Hidden/Internal-Colored")) { hideFlags = HideFlags.HideAndDontSave };
            return _material;
        }
    }
}
