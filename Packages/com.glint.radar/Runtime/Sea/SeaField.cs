using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A sea as a height field on the device, made from its waves at any time: height and vertical acceleration of the
    /// linear waves, without choppiness. It is the sum of cascades, tiles of different size.
    /// Kernels march through it with Shaders/SeaMarch.hlsl.
    /// </summary>
    sealed class SeaField : IDisposable
    {
        /// <summary>Points along a side of each tile: SEA_SIDE in Shaders/SeaField.hlsl.</summary>
        public const int Side = 256;

        /// <summary>Levels of the bounds of a tile: SEA_LEVELS.</summary>
        public const int Levels = 9;

        /// <summary>Bounds of all levels of a tile: SEA_BOUNDS.</summary>
        public const int BoundsOfATile = 87381;

        /// <summary>Maximum number of cascades: SEA_CASCADES.</summary>
        public const int MaxCascades = 2;

        /// <summary>Dispatches of an update.</summary>
        public const int DispatchesOfAnUpdate = 4;

        /// <summary>
        /// Seconds that the device's clock counts. Waves are uploaded again when it starts anew: the phases of waves
        /// lose 2^-33 turns a second.
        /// </summary>
        public const double ClockSeconds = 16384;

        /// <summary>Cells along the side of a group of SeaBounds: SEA_BLOCK in Shaders/SeaBounds.hlsl.</summary>
        public const int Block = 16;

        readonly SeaSurface[] _cascades;
        readonly ComputeShader _shader;
        readonly int _rows, _columns, _bounds, _upperBounds;
        readonly DeviceBuffer<SeaWave> _waves = new DeviceBuffer<SeaWave>("waves of a sea");
        readonly Vector4[] _tiles = new Vector4[MaxCascades];
        readonly int _topLevel;

        double _clockStart = double.NaN;

        /// <param name="shader">Shaders/SeaField.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <param name="cascades">A sea, or a sea and its <see cref="SeaSurface.Finer"/> tile.</param>
        /// <exception cref="GlintException">
        /// The device runs no kernels, there are too many cascades, or the grid of one is too fine.
        /// </exception>
        public SeaField(ComputeShader shader, string owner, params SeaSurface[] cascades)
        {
            DeviceCheck.Require(shader, nameof(SeaField), "SeaRows", owner);
            if (cascades.Length < 1 || cascades.Length > MaxCascades)
                throw new GlintException($"{owner}: the sea field has {cascades.Length} cascades: "
                    + "give it a sea, or a sea and its finer tile");
            foreach (var cascade in cascades)
                if (cascade.Settings.GridSize > Side)
                    throw new GlintException($"{owner}: grid size {cascade.Settings.GridSize} of the sea must be at "
                        + $"most {Side} in a sea field: use a smaller grid, and a finer tile for the shorter waves");
            (_shader, _cascades) = (shader, cascades);
            _rows = shader.FindKernel("SeaRows");
            _columns = shader.FindKernel("SeaColumns");
            _bounds = shader.FindKernel("SeaBounds");
            _upperBounds = shader.FindKernel("SeaUpperBounds");
            double finest = cascades.Min(cascade => cascade.Settings.TileSize);
            int above = 0;
            for (int i = 0; i < cascades.Length; i++)
            {
                double size = cascades[i].Settings.TileSize, levels = Math.Round(Math.Log(size / finest, 2));
                _tiles[i] = new Vector4((float)size, (float)(Side / size), (float)levels, 0);
                above = Math.Max(above, (int)levels);
            }
            _topLevel = above + Levels - 1;
        }

        /// <summary>Points of the tiles, cascade by cascade, rows along x from the tile's corner.</summary>
        public DeviceBuffer<SeaPoint> Points { get; } = new DeviceBuffer<SeaPoint>("points of a sea");

        /// <summary>Minimum and maximum height of cells, cascade by cascade, level by level from the finest.</summary>
        public DeviceBuffer<float2> Bounds { get; } = new DeviceBuffer<float2>("bounds of a sea");

        /// <summary>Dispatches so far.</summary>
        public long Dispatches { get; private set; }

        /// <summary>Uploads of the waves so far.</summary>
        public long Uploads { get; private set; }

        /// <summary>Computes the field at a time. It waits for nothing, and allocates only when it uploads.</summary>
        /// <exception cref="GlintException">The time is not finite, or too far from 0.</exception>
        public void Update(double timeSeconds)
        {
            SeaSurface.CheckTime(timeSeconds);
            double start = Math.Floor(timeSeconds / ClockSeconds) * ClockSeconds, clock = timeSeconds - start,
                seconds = Math.Floor(clock);
            if (start != _clockStart)
                Upload(start);
            _shader.SetInt(SeaFieldIDs._SeaSeconds, (int)seconds);
            _shader.SetFloat(SeaFieldIDs._SeaFraction, (float)(clock - seconds));
            _shader.SetBuffer(_rows, SeaFieldIDs._SeaWaves, _waves.Buffer);
            _shader.SetBuffer(_rows, SeaFieldIDs._WrittenSeaPoints, Points.Buffer);
            _shader.SetBuffer(_columns, SeaFieldIDs._WrittenSeaPoints, Points.Buffer);
            _shader.SetBuffer(_bounds, SeaFieldIDs._SeaPoints, Points.Buffer);
            _shader.SetBuffer(_bounds, SeaFieldIDs._WrittenSeaBounds, Bounds.Buffer);
            _shader.SetBuffer(_upperBounds, SeaFieldIDs._WrittenSeaBounds, Bounds.Buffer);
            Dispatch(_rows, Side);
            Dispatch(_columns, Side);
            Dispatch(_bounds, Side / Block * (Side / Block));
            Dispatch(_upperBounds, 1);
        }

        /// <summary>Sets what a kernel with Shaders/SeaMarch.hlsl reads; after <see cref="Update"/>.</summary>
        /// <param name="radar">Position in the sea's frame, metres: y above the mean level.</param>
        /// <param name="earthRadius">Effective radius in metres; infinity: the sea is flat.</param>
        public void SetMarch(ComputeShader shader, int kernel, double3 radar,
            double earthRadius = ClutterGeometry.EarthRadius)
        {
            shader.SetVectorArray(SeaFieldIDs._SeaCascades, _tiles);
            shader.SetInt(SeaFieldIDs._SeaCascadeCount, _cascades.Length);
            shader.SetBuffer(kernel, SeaFieldIDs._SeaPoints, Points.Buffer);
            shader.SetBuffer(kernel, SeaFieldIDs._SeaBounds, Bounds.Buffer);
            shader.SetVector(SeaFieldIDs._SeaRadar, radar.ToVector((float)(1 / (2 * earthRadius))));
            shader.SetInt(SeaFieldIDs._SeaTopLevel, _topLevel);
        }

        void Dispatch(int kernel, int groups)
        {
            _shader.Dispatch(kernel, groups, _cascades.Length, 1);
            Dispatches++;
        }

        void Upload(double start)
        {
            const int rows = Side / 2;
            var waves = new SeaWave[_cascades.Length * rows * Side];
            for (int i = 0; i < _cascades.Length; i++)
                foreach (var mode in _cascades[i].ModesAt(start))
                    waves[(i * rows + mode.Row) * Side + (mode.Column & (Side - 1))] = new SeaWave
                    {
                        Amplitude = new float2((float)mode.Real, (float)mode.Imaginary),
                        Frequency = (float)mode.Frequency, Turns = TurnsOf(mode.Frequency)
                    };
            _waves.Upload(waves);
            Points.Reserve((long)_cascades.Length * Side * Side);
            Bounds.Reserve((long)_cascades.Length * BoundsOfATile);
            _clockStart = start;
            Uploads++;
        }

        // Fraction of the frequency in 2^-32 turns a second.
        static uint TurnsOf(double frequency) =>
            (uint)(ulong)Math.Round((frequency - Math.Floor(frequency)) * 4294967296.0);

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _waves.Dispose();
            Points.Dispose();
            Bounds.Dispose();
            _clockStart = double.NaN;
        }
    }
}
