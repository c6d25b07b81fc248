using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A sea of any extent, made of copies of one periodic tile. The tile is a stored snapshot or, without snapshots,
    /// made from the wave settings.
    /// All tiles are instances of one mesh, so that a thousand tiles take little more memory than one.
    /// They are children of this object, made when it is enabled, in edit mode too, and never saved.
    /// </summary>
    [AddComponentMenu("Glint/Sea")]
    [HelpPage("sea.md")]
    [ExecuteAlways]
    [SelectionBase] // a click on a tile selects the sea
    [DisallowMultipleComponent]
    public sealed class Sea : MonoBehaviour
    {
        [SerializeField,
            Tooltip("Stored snapshots of a sea, in order; one of them is shown. Empty: the tile is made from Waves.")]
        List<SeaSnapshot> _snapshots = new List<SeaSnapshot>();

        [SerializeField, Min(1), Tooltip("Number of the snapshot that is shown, from 1.")]
        int _snapshot = 1;

        [SerializeField, Tooltip("Settings of the tile if there are no snapshots.")]
        SeaSettings _waves = SeaSettings.Default;

        [SerializeField, Tooltip("Time of the sea in seconds if there are no snapshots.")]
        double _timeSeconds;

        [SerializeField, Tooltip("Diffuse echo of the sea, and the reflection of its water. Off: the tiles are "
            + "perfect mirrors.")]
        SeaClutterSettings _clutter = SeaClutterSettings.Off;

        [SerializeField, Tooltip("Minimum extent along this object's X and Z in metres; it is covered by whole tiles.")]
        Vector2 _extent = new Vector2(64, 128);

        [SerializeField, Tooltip("Centre of the sea, the radar or the ship: the tiles follow it in steps of whole "
            + "tiles, so that the waves do not move. Empty: this object.")]
        Transform _centre;

        [SerializeField, Tooltip("Motion in play mode: none, one snapshot after the other, or moving waves (without "
            + "snapshots).")]
        SeaMotion _motion;

        [SerializeField, Min(0.01f), Tooltip("Duration of each snapshot, in seconds.")]
        float _secondsPerSnapshot = 1;

        [SerializeField, Tooltip("Appearance of the sea; the radar ignores it.")]
        Material _material;

        [SerializeField, Tooltip("Draws the tiles in Scene and Game view. They are traced either way; "
            + "a large sea takes long to draw.")]
        bool _drawInScene = true;

        // Largest tilt in rad and largest error of a scale with clutter: roundings of float32 are far below.
        const double MaxTilt = 1e-4;

        // Added before rounding down: positions are whole or half tiles.
        const double QuarterTile = 0.25;

        readonly SeaTiles _tiles = new SeaTiles();
        SeaSurface _surface;
        SeaClutter _echo;
        Mesh _made;
        (SeaSurface, double) _filled; // what the mesh shows
        Material _instanced;
        Vector3 _localCentre;
        int _layer; // of the tiles
        bool _isStale, _isRefused; // an error is reported once

        /// <summary>Stored moments, in order. Call <see cref="Rebuild"/> after a change.</summary>
        public List<SeaSnapshot> Snapshots => _snapshots;

        /// <summary>The snapshot shown, from 1; setting it shows it immediately.</summary>
        /// <exception cref="GlintException">The snapshot does not exist.</exception>
        public int Snapshot
        {
            get => _snapshot;
            set
            {
                CheckSnapshot(value);
                _snapshot = value;
                Show();
            }
        }

        /// <summary>Settings of the tile if there are no snapshots; setting them shows it immediately.</summary>
        /// <exception cref="GlintException">A setting is out of its range.</exception>
        public SeaSettings Waves
        {
            get => _waves;
            set
            {
                value.Validate(Subject);
                (_waves, _surface) = (value, null);
                Show();
            }
        }

        /// <summary>Time of the sea in seconds if there are no snapshots; setting it shows it immediately.</summary>
        public double TimeSeconds
        {
            get => _timeSeconds;
            set
            {
                _timeSeconds = value;
                Show();
            }
        }

        /// <summary>
        /// Settings of the diffuse echo. While it is on, tiles reflect as sea water unless a <see cref="RadarSurface"/>
        /// gives them another material.
        /// </summary>
        /// <exception cref="GlintException">A setting is out of its range.</exception>
        public SeaClutterSettings Clutter
        {
            get => _clutter;
            set
            {
                value.Validate(Subject);
                _clutter = value;
            }
        }

        /// <summary>
        /// Minimum extent along X and Z, metres. Call <see cref="Rebuild"/> after a change.
        /// </summary>
        public Vector2 Extent { get => _extent; set => _extent = value; }

        /// <summary>Centre of the extent; null: this object. Call <see cref="Rebuild"/> after a change.</summary>
        public Transform Centre { get => _centre; set => _centre = value; }

        /// <summary>Motion while the scene plays.</summary>
        public SeaMotion Motion { get => _motion; set => _motion = value; }

        /// <summary>
        /// Time of each snapshot with the motion <see cref="SeaMotion.Snapshots"/>, seconds.
        /// </summary>
        /// <exception cref="GlintException">It is not above 0.</exception>
        public float SecondsPerSnapshot
        {
            get => _secondsPerSnapshot;
            set => _secondsPerSnapshot = value > 0 ? value : throw new GlintException(
                FormattableString.Invariant($"{Subject}: {value} seconds a snapshot: must be above 0"));
        }

        /// <summary>
        /// Material of the tiles; if none is assigned, that of new objects in the current render pipeline, or null.
        /// Call <see cref="Rebuild"/> after a change.
        /// </summary>
        public Material Material
        {
            get => _material != null ? _material : PipelineMaterial.Default;
            set => _material = value;
        }

        /// <summary>
        /// Draws the tiles in Scene and Game view; they are traced either way. Call <see cref="Rebuild"/> after a
        /// change.
        /// </summary>
        public bool DrawInScene { get => _drawInScene; set => _drawInScene = value; }

        /// <summary>Message about a sea without material.</summary>
        public string HasNoMaterial => $"{Subject} has no material: Unity draws it magenta or not at all, "
            + "though it is traced: assign one to its field Material";

        /// <summary>The snapshot shown; null if there is none of that number.</summary>
        public SeaSnapshot CurrentSnapshot =>
            _snapshot >= 1 && _snapshot <= _snapshots.Count ? _snapshots[_snapshot - 1] : null;

        /// <summary>Number of visible tiles.</summary>
        public int TileCount => _tiles.Shown;

        string Subject => $"Sea of '{name}'";

        /// <summary>
        /// Updates the tiles to the current settings. A prefab asset has none: they would lie in the open scene.
        /// </summary>
        /// <exception cref="GlintException">A setting is out of its range, or a snapshot is missing.</exception>
        public void Rebuild()
        {
            if (!gameObject.scene.IsValid())
                return;
            _isStale = false;
            // before anything is refused: an error is reported once, until the centre, the layer or a setting changes
            (_localCentre, _layer) = (LocalCentre(), gameObject.layer);
            Check();
            if (!isActiveAndEnabled)
            {
                _tiles.Hide(transform);
                return;
            }
            var tile = Tile(out double size);
            _tiles.Rebuild(transform, tile, Instanced(), size, _extent, _localCentre, Subject);
            _tiles.Draw(_drawInScene);
            _isRefused = false;
        }

        /// <summary>Refuses invalid settings.</summary>
        /// <exception cref="GlintException">
        /// A setting of the waves is out of its range, a snapshot is missing, or the motion does not fit.
        /// </exception>
        public void Check()
        {
            if (_motion == SeaMotion.Waves && _snapshots.Count > 0)
                throw new GlintException($"{Subject}: its motion is Waves and it has snapshots, which do not move: "
                    + "choose Snapshots or Still, or remove the snapshots");
            if (_snapshots.Count > 0)
                CheckSnapshot(_snapshot);
            else
                _waves.Validate(Subject);
            if (_clutter.IsOn)
                _clutter.Validate(Subject);
        }

        /// <summary>
        /// The diffuse echo of what is shown; the same object until something changes. Null if clutter is off.
        /// </summary>
        /// <exception cref="GlintException">
        /// A setting is out of its range, a snapshot is missing, or the sea is tilted or scaled.
        /// </exception>
        public SeaClutter CurrentClutter()
        {
            if (!_clutter.IsOn)
                return null;
            Check();
            var shown = CurrentSnapshot;
            var waves = ShownWaves;
            double time = ShownTime;
            try
            {
                double3 wind = WindInWorld(waves.WindDirectionDegrees);
                if (_echo == null || !_echo.LongWaves.Settings.Equals(waves) || !_echo.Settings.Equals(_clutter)
                    || !_echo.Wind.Equals(wind))
                    _echo = new SeaClutter(shown == null && _surface != null ? _surface : new SeaSurface(waves), time,
                        wind, _clutter);
                else if (_echo.Time != time)
                    _echo = _echo.At(time);
                return _echo;
            }
            catch (GlintException refusal)
            {
                throw new GlintException($"{Subject}: {refusal.Message}", refusal);
            }
        }

        /// <summary>
        /// Position of a tile in this object's coordinates, in tiles: whole numbers, also for an even number of tiles,
        /// which are centred on half ones.
        /// </summary>
        internal int2 NumberOf(Transform tile)
        {
            double size = ShownWaves.TileSize;
            return new int2((int)Math.Floor(tile.localPosition.x / size + QuarterTile),
                (int)Math.Floor(tile.localPosition.z / size + QuarterTile));
        }

        /// <summary>Time of the tile that is shown, seconds.</summary>
        internal double ShownTime => CurrentSnapshot == null ? _timeSeconds : CurrentSnapshot.TimeSeconds;

        /// <summary>The middle of a tile in this object's coordinates; tiles follow it in their size.</summary>
        internal Vector3 TileMiddle()
        {
            var tile = GetComponentInChildren<SeaTile>();
            return tile == null ? Vector3.zero : tile.transform.localPosition;
        }

        /// <summary>Refuses a number without snapshot.</summary>
        /// <exception cref="GlintException">The snapshot does not exist.</exception>
        public void CheckSnapshot(int number)
        {
            if (_snapshots.Count == 0)
                throw new GlintException($"{Subject} has no snapshots: "
                    + "put prefabs that glint sea wrote into its list Snapshots");
            if (number < 1 || number > _snapshots.Count)
                throw new GlintException($"{Subject} has no snapshot {number}: it has 1 to {_snapshots.Count}");
            if (_snapshots[number - 1] == null || _snapshots[number - 1].Tile == null)
                throw new GlintException($"{Subject}: entry {number} of its list Snapshots is empty or has no tile: "
                    + "put a prefab there that glint sea wrote");
        }

        /// <summary>Settings of the tile that is shown.</summary>
        internal SeaSettings ShownWaves => CurrentSnapshot == null ? _waves : CurrentSnapshot.Settings;

        // Echoes are those of a mean surface that is horizontal, and of waves in metres.
        double3 WindInWorld(double degrees)
        {
            Vector3 up = transform.rotation * Vector3.up, scale = transform.lossyScale;
            double tilt = math.length(new double2(up.x, up.z));
            if (!(up.y > 0 && tilt < MaxTilt && (scale - Vector3.one).magnitude < MaxTilt))
                throw new GlintException("its clutter needs a horizontal sea in metres: rotate it, and what is above "
                    + "it in the hierarchy, about Y alone, give all a scale of 1, or turn clutter off");
            double angle = math.radians(degrees);
            Vector3 wind = transform.rotation * new Vector3((float)Math.Sin(angle), 0, (float)Math.Cos(angle));
            return math.normalize(new double3(wind.x, 0, wind.z));
        }

        Mesh Tile(out double size)
        {
            if (_snapshots.Count > 0)
            {
                size = _snapshots[_snapshot - 1].Settings.TileSize;
                return _snapshots[_snapshot - 1].Tile;
            }
            _surface ??= new SeaSurface(_waves);
            if (_made == null)
                (_made, _filled) = (new Mesh { name = "Sea", hideFlags = HideFlags.DontSave }, default);
            if (_filled != (_surface, _timeSeconds))
            {
                var tile = _surface.Mesh(_timeSeconds);
                MeshMaker.Fill(_made, tile.Vertices, tile.Indices);
                _filled = (_surface, _timeSeconds);
            }
            size = _waves.TileSize;
            return _made;
        }

        // The editor draws many tiles in one call by GPU instancing: by a copy of a material without it. Not in a player,
        // which lacks the shader's variant where no stored material has it.
        Material Instanced()
        {
            var material = Material;
            if (material == null || material.enableInstancing || !Application.isEditor)
                return material;
            if (_instanced == null)
                _instanced = new Material(material);
            _instanced.shader = material.shader;
            _instanced.CopyPropertiesFromMaterial(material);
            (_instanced.enableInstancing, _instanced.hideFlags) = (true, HideFlags.DontSave);
            return _instanced;
        }

        Vector3 LocalCentre() => _centre == null ? Vector3.zero : transform.InverseTransformPoint(_centre.position);

        void Show()
        {
            if (isActiveAndEnabled)
                Rebuild();
        }

        // In the editor, when the component is added or reset. The built-in pipeline's material is among the default
        // references of this script.
        void Reset()
        {
            if (PipelineMaterial.Default != null)
                (_material, _isStale) = (PipelineMaterial.Default, true);
        }

        void OnEnable() => Attempt();

        // Objects cannot be created during OnValidate.
        void OnValidate() => (_isStale, _surface) = (true, null);

        void Update()
        {
            if (Application.IsPlaying(gameObject))
                Move();
            if (_isStale || LocalCentre() != _localCentre || gameObject.layer != _layer)
                Attempt();
        }

        void Move()
        {
            if (_motion == SeaMotion.Waves)
                (_timeSeconds, _isStale) = (_timeSeconds + Time.deltaTime, _isStale || !_isRefused);
            if (_motion != SeaMotion.Snapshots || _snapshots.Count == 0)
                return;
            int shown = 1 + (int)(Time.time / _secondsPerSnapshot) % _snapshots.Count;
            if (shown != _snapshot)
                (_snapshot, _isStale) = (shown, true);
        }

        // A sea that cannot be shown reports why and hides its tiles.
        void Attempt()
        {
            try
            {
                Rebuild();
            }
            catch (GlintException problem)
            {
                _isRefused = true;
                _tiles.Hide(transform);
                Debug.LogError(problem.Message, this);
            }
        }

        void OnDisable()
        {
            _tiles.Hide(transform);
        }

        void OnDestroy()
        {
            MadeObject.Free(_made);
            MadeObject.Free(_instanced);
        }
    }

    /// <summary>Motion of a <see cref="Sea"/> while the scene plays.</summary>
    public enum SeaMotion
    {
        /// <summary>No motion.</summary>
        Still,

        /// <summary>Shows one snapshot after the other, repeatedly.</summary>
        Snapshots,

        /// <summary>Travelling waves: the tile is recomputed each frame.</summary>
        Waves
    }
}
