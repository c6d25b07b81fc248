using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Glint
{
    /// <summary>
    /// A radar screen on the device: echoes, receiver and picture of the spokes of a frame. It waits for nothing and
    /// allocates nothing a frame, and knows no GameObjects.
    /// </summary>
    /// <remarks>
    /// A frame calls <see cref="Begin"/>, then adds echoes (<see cref="AddSea"/>, <see cref="AddTargets"/>,
    /// <see cref="AddPoints"/>, <see cref="AddRain"/>, any kernel that adds to <see cref="Echo"/> in the spokes of the
    /// slice), then <see cref="Finish"/> and <see cref="Draw"/>.
    /// </remarks>
    sealed class ScreenTracer : IDisposable
    {
        const int Group = 64, PictureGroup = 8;

        readonly ComputeShader _shader;
        readonly int _clear, _points, _pointsOverSea, _targets, _targetsOverSea, _sea, _rain, _beam, _level, _video,
            _trails, _picture;
        readonly ScreenSweep _sweep;
        readonly int[] _size = new int[4], _slice = new int[4];
        readonly Vector4[] _colours = new Vector4[7];
        readonly DeviceBuffer<ScreenPoint> _pointBuffer = new DeviceBuffer<ScreenPoint>("points of a radar screen");
        readonly DeviceBuffer<float> _beamWeights = new DeviceBuffer<float>("weights of a beam"),
            _pulseWeights = new DeviceBuffer<float>("weights of a pulse"),
            _elevationField = new DeviceBuffer<float>("fields of a pattern");
        readonly DeviceBuffer<float4> _foreignPulses = new DeviceBuffer<float4>("pulses of other radars");
        readonly ScreenInterference _interference;
        readonly DeviceBuffer<float2> _signals = new DeviceBuffer<float2>("signals of a radar screen");

        ScreenSlice _current;
        float4[] _pulses = Array.Empty<float4>();
        int _foreignRadars;
        // Position of the antenna when trails were written; not a number: there are none.
        double2 _trailPosition = double.NaN;

        /// <param name="shader">Shaders/Screen.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <param name="table">As of <see cref="ScreenGeometry"/>.</param>
        /// <exception cref="GlintException">
        /// The device runs no kernels, a setting is out of its range, or the device holds no turn of this size.
        /// </exception>
        public ScreenTracer(ComputeShader shader, string owner, in ScreenRadar radar, string table = null)
        {
            Geometry = new ScreenGeometry(radar, owner, table);
            _interference = new ScreenInterference(Geometry);
            DeviceCheck.Require(shader, "Screen", "ScreenBeam", owner);
            _shader = shader;
            _clear = shader.FindKernel("ScreenClear");
            _points = shader.FindKernel("ScreenPoints");
            _pointsOverSea = shader.FindKernel("ScreenPointsOverSea");
            _targets = shader.FindKernel("ScreenTargets");
            _targetsOverSea = shader.FindKernel("ScreenTargetsOverSea");
            DeviceCheck.RequireSupported(shader, _targets, _targetsOverSea);
            _sea = shader.FindKernel("ScreenSea");
            _rain = shader.FindKernel("ScreenRain");
            _beam = shader.FindKernel("ScreenBeam");
            _level = shader.FindKernel("ScreenLevel");
            _video = shader.FindKernel("ScreenVideo");
            _trails = shader.FindKernel("ScreenTrails");
            _picture = shader.FindKernel("ScreenPicture");
            _sweep = new ScreenSweep(Geometry);
            long cells = (long)radar.Spokes * radar.Cells;
            try
            {
                Echo.Reserve(2 * cells);
                // Spokes that were not finished yet are dark.
                Levels.Upload(new float[cells]);
                Video.Upload(new float2[cells]);
                Trails.Upload(new float[TrailMap.Side * TrailMap.Side]);
                _signals.Reserve((long)_sweep.MaxSpokes * radar.Cells);
                _beamWeights.Upload(Geometry.Beam);
                _pulseWeights.Upload(Geometry.Pulse);
                _elevationField.Upload(Geometry.Elevation);
                _foreignPulses.Reserve(1);
            }
            catch
            {
                Dispose();
                throw;
            }
            (_size[0], _size[1], _size[2], _size[3]) = (radar.Spokes, radar.Cells, Geometry.HalfBeam, radar.Seed);
        }

        /// <summary>Spokes, cells, beam, pulse and levels.</summary>
        public ScreenGeometry Geometry { get; }

        /// <summary>
        /// Complex field of each spoke and cell of a turn: _Echo in Shaders/ScreenEchoes.hlsl, which has the layout.
        /// </summary>
        public DeviceBuffer<int> Echo { get; } = new DeviceBuffer<int>("echoes of a radar screen");

        /// <summary>Level of each spoke and cell of a turn, dB over noise.</summary>
        public DeviceBuffer<float> Levels { get; } = new DeviceBuffer<float>("levels of a radar screen");

        /// <summary>
        /// Video of each spoke and cell of a turn when the spoke was finished, 0 to 1: with persistence, and without.
        /// </summary>
        public DeviceBuffer<float2> Video { get; } = new DeviceBuffer<float2>("video of a radar screen");

        /// <summary>Trails, 0 to 1: <see cref="TrailMap"/>.</summary>
        public DeviceBuffer<float> Trails { get; } = new DeviceBuffer<float>("trails of a radar screen");

        /// <summary>Pixel of the antenna in the map of trails.</summary>
        public double2 TrailMiddle { get; private set; }

        /// <summary>The spokes of the frame.</summary>
        public ScreenSlice Slice => _current;

        /// <summary>The spoke that the antenna passes next, counted from the first turn.</summary>
        public long Front => _sweep.Finished;

        /// <summary>Whether the frame traces a spoke of a turn.</summary>
        public bool IsTraced(int spoke) => Geometry.InTurn(spoke - _current.FirstTraced) < _current.Traced;

        /// <summary>Moves the antenna and clears the spokes that it comes to.</summary>
        /// <param name="turns">True bearing of the antenna in turns from north, counted on.</param>
        public void Begin(double turns)
        {
            _current = _sweep.Advance(turns);
            if (_current.Traced == 0)
                return;
            SetTraced(_shader);
            _shader.SetVector(ScreenIDs._ScreenEcho, new Vector4((float)Geometry.CellSize,
                (float)Geometry.AmplitudeAtOne,
                (float)Math.Min(float.MaxValue, Geometry.Radar.UnambiguousRange / Geometry.CellSize),
                (float)Geometry.RainAmplitude));
            _shader.SetFloat(ScreenIDs._RainLoss, (float)Geometry.RainLoss);
            _shader.SetBuffer(_clear, ScreenIDs._Echo, Echo.Buffer);
            Dispatch(_clear, 2 * Geometry.Radar.Cells, _current.Traced);
        }

        /// <summary>Sets what a kernel that adds echoes reads: size, and the spokes to trace.</summary>
        public void SetTraced(ComputeShader shader)
        {
            shader.SetInts(ScreenIDs._ScreenSize, _size);
            SetSlice(shader, _current.FirstTraced, _current.Traced);
        }

        /// <summary>Adds the echo of a sea, which was updated.</summary>
        /// <inheritdoc cref="ScreenSea.Set"/>
        public void AddSea(ScreenSea sea, double3 radar, double northTurns)
        {
            if (_current.Traced == 0)
                return;
            sea.Set(_shader, _sea, radar, northTurns);
            _shader.SetBuffer(_sea, ScreenIDs._ElevationField, _elevationField.Buffer);
            sea.Field.SetMarch(_shader, _pointsOverSea, radar);
            sea.Field.SetMarch(_shader, _targetsOverSea, radar);
            _shader.SetBuffer(_sea, ScreenIDs._Echo, Echo.Buffer);
            Dispatch(_sea, Geometry.Radar.Cells * sea.FacetsOfACell, _current.Traced);
        }

        /// <summary>Adds the echoes of points.</summary>
        /// <param name="count">Of the points that are used.</param>
        /// <param name="isOverSea">Whether waves may hide them; after <see cref="AddSea"/>.</param>
        public void AddPoints(ScreenPoint[] points, int count, bool isOverSea = false)
        {
            if (_current.Traced == 0 || count == 0)
                return;
            _pointBuffer.Reserve(points.Length);
            _pointBuffer.Write(points, 0, 0, count);
            int kernel = isOverSea ? _pointsOverSea : _points;
            _shader.SetBuffer(kernel, ScreenIDs._ScreenPoints, _pointBuffer.Buffer);
            _shader.SetBuffer(kernel, ScreenIDs._Echo, Echo.Buffer);
            _shader.SetInt(ScreenIDs._ScreenPointCount, count);
            Dispatch(kernel, count, 1);
        }

        /// <summary>Adds the echoes of meshes.</summary>
        /// <param name="isOverSea">Whether waves may hide them; after <see cref="AddSea"/>.</param>
        /// <inheritdoc cref="ScreenTargets.Set"/>
        public void AddTargets(ScreenTargets targets, double3 antenna, double seaLevel, double northTurns,
            bool isOverSea = false)
        {
            if (_current.Traced == 0 || targets.Count == 0)
                return;
            int kernel = isOverSea ? _targetsOverSea : _targets;
            targets.Set(_shader, kernel, antenna, seaLevel, northTurns);
            _shader.SetBuffer(kernel, ScreenIDs._ElevationField, _elevationField.Buffer);
            _shader.SetBuffer(kernel, ScreenIDs._Echo, Echo.Buffer);
            _shader.DispatchThreads(kernel, targets.Count);
        }

        /// <summary>Adds the echo of rain, if there is any.</summary>
        public void AddRain()
        {
            if (_current.Traced == 0 || Geometry.Radar.RainRate == 0)
                return;
            _shader.SetBuffer(_rain, ScreenIDs._Echo, Echo.Buffer);
            Dispatch(_rain, Geometry.Radar.Cells, _current.Traced);
        }

        /// <summary>Sets the other radars whose pulses the frame and later ones receive.</summary>
        /// <param name="count">Of the radars that are used.</param>
        public void SetOtherRadars(OtherRadar[] radars, int count)
        {
            _foreignRadars = count;
            if (_pulses.Length < count * _sweep.MaxSpokes)
            {
                _pulses = new float4[count * _sweep.MaxSpokes];
                _foreignPulses.Reserve(_pulses.Length);
            }
            for (int spoke = 0; spoke < _current.Finished; spoke++)
                for (int i = 0; i < count; i++)
                    _pulses[spoke * count + i] = _interference.PulsesOf(_current.FirstFinished + spoke, radars[i]);
            if (count * _current.Finished > 0)
                _foreignPulses.Write(_pulses, 0, 0, count * _current.Finished);
        }

        /// <summary>From the echoes to video and trails of the spokes that the antenna has passed.</summary>
        /// <param name="position">
        /// Of the antenna where true trails keep their place, metres to the east and to the north.
        /// </param>
        /// <param name="headingTurns">True heading of the own ship, from which the blind sector counts.</param>
        public void Finish(in ScreenReceiver receiver, double2 position = default, double headingTurns = 0)
        {
            if (receiver.TrailMotion == TrailMotion.Relative)
                position = 0;
            TrailMiddle = TrailMap.PixelOf(position, Geometry.Radar.RangeScale);
            if (_current.Finished == 0)
                return;
            SetSlice(_shader, _current.FirstFinished, _current.Finished);
            SetReceiver(receiver);
            _shader.SetBuffer(_beam, ScreenIDs._Echoes, Echo.Buffer);
            _shader.SetBuffer(_beam, ScreenIDs._BeamWeights, _beamWeights.Buffer);
            _shader.SetBuffer(_beam, ScreenIDs._Signals, _signals.Buffer);
            _shader.SetBuffer(_beam, ScreenIDs._ForeignPulses, _foreignPulses.Buffer);
            _shader.SetInt(ScreenIDs._ForeignRadars, _foreignRadars);
            double blind = headingTurns + Geometry.Radar.BlindFrom / 360;
            _shader.SetVector(ScreenIDs._BlindSector, new Vector4((float)(blind - Math.Floor(blind)),
                (float)(Geometry.Radar.BlindWidth / 360), 0, 0));
            Dispatch(_beam, Geometry.Radar.Cells, _current.Finished);
            _shader.SetBuffer(_level, ScreenIDs._PulseWeights, _pulseWeights.Buffer);
            _shader.SetBuffer(_level, ScreenIDs._Signals, _signals.Buffer);
            _shader.SetBuffer(_level, ScreenIDs._Levels, Levels.Buffer);
            Dispatch(_level, Geometry.Radar.Cells, _current.Finished);
            _shader.SetBuffer(_video, ScreenIDs._Levels, Levels.Buffer);
            _shader.SetBuffer(_video, ScreenIDs._Video, Video.Buffer);
            Dispatch(_video, Geometry.Radar.Cells, _current.Finished);
            WriteTrails(receiver, position);
        }

        /// <summary>Of the spokes that the last frame finished, those before the turn begins again.</summary>
        public int FinishedBeforeNorth => Math.Min(_current.Finished,
            Geometry.Radar.Spokes - Geometry.InTurn(_current.FirstFinished));

        /// <summary>Reads the video of the spokes that the last frame finished. It waits for the device.</summary>
        public float2[] ReadFrame()
        {
            int cells = Geometry.Radar.Cells, first = Geometry.InTurn(_current.FirstFinished), whole = FinishedBeforeNorth;
            var video = new float2[_current.Finished * cells];
            if (whole > 0)
                Video.Buffer.GetData(video, 0, first * cells, whole * cells);
            if (whole < _current.Finished)
                Video.Buffer.GetData(video, whole * cells, 0, (_current.Finished - whole) * cells);
            return video;
        }

        /// <summary>Whether the device draws into textures.</summary>
        public static bool CanDraw =>
            SystemInfo.IsFormatSupported(GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormatUsage.LoadStore);

        /// <summary>Draws the turn into a square texture with random write.</summary>
        /// <param name="isLinear">Whether the project's colours are linear.</param>
        public void Draw(Texture picture, in ScreenView view, bool isLinear)
        {
            _shader.SetInts(ScreenIDs._ScreenSize, _size);
            _shader.SetVector(ScreenIDs._PictureView,
                new Vector4(view.Side, (float)view.Up, (float)view.RingSpacing, (float)view.Marker));
            _shader.SetVector(ScreenIDs._PictureFade,
                new Vector4((float)view.FadeASpoke, view.Front, isLinear ? 1 : 0, 0));
            _shader.SetVector(ScreenIDs._PictureTrail, new Vector4((float)view.TrailMiddle.x, (float)view.TrailMiddle.y,
                (float)view.TrailUp.x, (float)view.TrailUp.y));
            _shader.SetVector(ScreenIDs._PictureHeading, (float4)view.HeadingLine);
            _shader.SetVector(ScreenIDs._PictureBearing, (float4)view.BearingLine);
            var colours = view.Colours;
            (_colours[0], _colours[1]) = (colours.Outside.ToVector(), colours.Background.ToVector());
            (_colours[2], _colours[3]) = (colours.Echo.ToVector(), colours.Trail.ToVector());
            (_colours[4], _colours[5]) = (colours.Rings.ToVector(), colours.Heading.ToVector());
            _colours[6] = colours.Marker.ToVector();
            _shader.SetVectorArray(ScreenIDs._PictureColours, _colours);
            _shader.SetBuffer(_picture, ScreenIDs._ShownVideo, Video.Buffer);
            _shader.SetBuffer(_picture, ScreenIDs._ShownTrails, Trails.Buffer);
            _shader.SetTexture(_picture, ScreenIDs._Picture, picture);
            DispatchSquare(_picture, view.Side);
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            Echo.Dispose();
            Levels.Dispose();
            Video.Dispose();
            Trails.Dispose();
            _pointBuffer.Dispose();
            _beamWeights.Dispose();
            _pulseWeights.Dispose();
            _elevationField.Dispose();
            _foreignPulses.Dispose();
            _signals.Dispose();
        }

        void WriteTrails(in ScreenReceiver receiver, double2 position)
        {
            if (receiver.TrailTurns == 0)
            {
                _trailPosition = double.NaN;
                return;
            }
            // Not after a jump, and not those from before trails were off.
            bool isKept = math.distance(position, _trailPosition) * TrailMap.Radius
                < TrailMap.MaxStep * Geometry.Radar.RangeScale;
            _trailPosition = position;
            double kept = isKept ? Math.Exp(-receiver.FadeATurn.y * _current.Finished / Geometry.Radar.Spokes) : 0;
            _shader.SetVector(ScreenIDs._TrailFrame,
                new Vector4((float)TrailMiddle.x, (float)TrailMiddle.y, (float)kept, 0));
            _shader.SetBuffer(_trails, ScreenIDs._ShownVideo, Video.Buffer);
            _shader.SetBuffer(_trails, ScreenIDs._Trails, Trails.Buffer);
            DispatchSquare(_trails, TrailMap.Side);
        }

        void SetSlice(ComputeShader shader, long first, int count)
        {
            int inTurn = Geometry.InTurn(first);
            (_slice[0], _slice[1], _slice[2]) = (inTurn, count, (int)((first - inTurn) / Geometry.Radar.Spokes));
            shader.SetInts(ScreenIDs._ScreenSlice, _slice);
        }

        void SetReceiver(in ScreenReceiver receiver)
        {
            _shader.SetVector(ScreenIDs._Receiver, new Vector4((float)receiver.GainDb,
                (float)(1 / receiver.DynamicRangeDb), (float)(receiver.SensitivityTimeRange / Geometry.CellSize),
                (float)Math.Sqrt(Geometry.NoiseGain)));
            _shader.SetVector(ScreenIDs._ReceiverFilters, new Vector4((float)receiver.RainFilter,
                (float)receiver.ClutterFilter, (float)receiver.KeptATurn, 0));
            _shader.SetInt(ScreenIDs._PulseCells, Geometry.Pulse.Length);
        }

        void DispatchSquare(int kernel, int side)
        {
            int groups = (side + PictureGroup - 1) / PictureGroup;
            _shader.Dispatch(kernel, groups, groups, 1);
        }

        void Dispatch(int kernel, int across, int rows) => _shader.Dispatch(kernel, (across + Group - 1) / Group, rows, 1);
    }
}
