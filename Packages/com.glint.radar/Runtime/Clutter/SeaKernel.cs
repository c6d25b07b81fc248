using System;
using System.Diagnostics;
using System.Linq;
using Complex = System.Numerics.Complex;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>The kernel that sums the diffuse echo of seas, facet by facet, and its inputs.</summary>
    sealed class SeaKernel : IDisposable
    {
        const int TileFacets = 64;         // the pacer counts tiles

        // Of a shadow ray's start above its facet, as a fraction of the scene's size: several roundings of float32.
        const double RelativeOffset = 1e-6;

        // The time of waves is a whole number of these, and a rest of which float32 has microseconds.
        const double SecondsAnEpoch = 16;

        readonly string _owner;
        readonly ComputeShader _shader;
        readonly int _clear, _facets;
        readonly SeaBuffers _sea = new SeaBuffers();
        readonly DeviceBuffer<uint> _output = new DeviceBuffer<uint>("sums of a sea");
        readonly DeviceBuffer<float4> _receivers = new DeviceBuffer<float4>("receivers of a sea");
        readonly DispatchPacer _pacer = new DispatchPacer();

        DeviceScene _scene;

        /// <summary>Dispatches, round trips and bytes of all sums.</summary>
        public TraceStatistics Statistics { get; } = new TraceStatistics();

        /// <summary>Least number of groups of facets of a sea, for tests.</summary>
        public long MinGroups { get; set; } = SeaGroups.MinGroups;

        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        public SeaKernel(ComputeShader shader, string owner)
        {
            (_shader, _owner) = (shader, owner);
            _clear = shader.FindKernel("ClearTubes");
            _facets = shader.FindKernel("SeaFacets");
        }

        /// <summary>Sums the echo of all seas with clutter; see <see cref="ClutterTracer.Trace"/>.</summary>
        /// <param name="scene">Holds the pose's scene.</param>
        /// <param name="time">Since the moment of the scene, seconds: facets move with the waves from there.</param>
        /// <param name="levelOf">Factors of the power of a sea; null, or null of a sea: none.</param>
        public ClutterEcho[] Sum(DeviceScene scene, CrossSectionPose pose, double frequency, double time,
            ClutterGrid grid, Func<RadarSea, ClutterLevelTable> levelOf, IProgress<double> progress,
            CancellationToken cancel)
        {
            _scene = scene;
            var echoes = new ClutterEcho[grid.Count];
            for (int number = 0; number < pose.Scene.Seas.Count; number++)
            {
                var sea = pose.Scene.Seas[number];
                SetLevel(levelOf?.Invoke(sea));
                var part = Sum(pose, sea, Speckle.SeedOf(sea.Clutter.Seed, number), frequency, time, grid, progress, cancel);
                for (int cell = 0; cell < echoes.Length; cell++)
                    echoes[cell] += part[cell];
            }
            return echoes;
        }

        ClutterEcho[] Sum(CrossSectionPose pose, RadarSea sea, uint seed, double frequency, double time, ClutterGrid grid,
            IProgress<double> progress, CancellationToken cancel)
        {
            int[] sides = SeaGroups.SidesOf(pose, sea, grid, MinGroups);
            var groups = sea.Tiles.Select((tile, i) => (tile, side: sides[i])).GroupBy(it => it.side).ToArray();
            _sea.Set(pose.Scene, sea, groups.SelectMany(group => group.Select(it => it.tile)), _scene.Centre, frequency,
                time != 0, Statistics);
            var read = new uint[ClutterSums.WordsOf(grid.Count)];
            _output.Reserve(read.Length);
            Bind(pose, sea.Clutter, frequency, time, grid);
            _shader.SetInt(TubeIDs._ClearedWords, read.Length);
            _shader.DispatchThreads(_clear, read.Length);
            Statistics.Dispatches++;
            int cells = sea.Clutter.LongWaves.Settings.Cells, tile = 0;
            foreach (var group in groups)
            {
                int items = (int)SeaGroups.CountOf(cells, group.Key) + (group.Key > 1 ? _sea.BreakingCount : 0);
                _shader.SetInts(SeaIDs._SeaGroup, group.Key, cells / group.Key, cells, tile);
                Dispatch(items, group.Count(), (int)seed, read,
                    done => progress?.Report((tile + done * group.Count()) / sea.Tiles.Count), cancel);
                tile += group.Count();
            }
            return ClutterSums.Echoes(read, grid.Count, PhaseOf(pose, frequency), _owner);
        }

        // Adds the items of tiles to the sums, and reads the sums.
        void Dispatch(int items, int tileCount, int seed, uint[] read, Action<double> report, CancellationToken cancel)
        {
            long total = (long)items * tileCount;
            if (total > uint.MaxValue)
                throw new GlintException(FormattableString.Invariant($"{_owner}: {tileCount} tiles of the sea have ")
                    + FormattableString.Invariant($"{total:N0} facets, and the kernels count to {uint.MaxValue:N0}: ")
                    + "make the sea smaller, or its cells larger");
            Statistics.SeaFacets += total;
            for (long first = 0; first < total;)
            {
                cancel.ThrowIfCancellationRequested();
                int tiles = _pacer.NextTiles((int)Math.Min(int.MaxValue, (total - first + TileFacets - 1) / TileFacets),
                    1);
                int count = (int)Math.Min(total - first, (long)tiles * TileFacets);
                var watch = Stopwatch.StartNew();
                _shader.SetInts(SeaIDs._SeaRange, items, (int)first, count, seed);
                _shader.DispatchThreads(_facets, count);
                _output.ReadBack(read, read.Length);
                _pacer.Took(tiles, watch.Elapsed.TotalSeconds);
                Statistics.Dispatches++;
                Statistics.RoundTrips++;
                Statistics.BytesReadBack += sizeof(uint) * (long)read.Length;
                first += count;
                report((double)first / total);
            }
        }

        void Bind(CrossSectionPose pose, SeaClutter clutter, double frequency, double time, ClutterGrid grid)
        {
            _shader.SetBvhs(_facets, _scene);
            _shader.SetBuffer(_clear, ShaderIDs._Sums, _output.Buffer);
            _shader.SetBuffer(_facets, ShaderIDs._Sums, _output.Buffer);
            _shader.SetBuffer(_facets, SeaIDs._SeaFacets, _sea.Facets.Buffer);
            _shader.SetBuffer(_facets, SeaIDs._SeaBreaking, _sea.Breaking.Buffer);
            _shader.SetBuffer(_facets, SeaIDs._SeaTiles, _sea.Tiles.Buffer);
            _shader.SetBuffer(_facets, SeaIDs._SeaVelocities, _sea.Velocities.Buffer);
            _shader.SetBuffer(_facets, SeaIDs._FacetTable, _sea.Table.Buffer);
            TubeKernels.SetReceivers(_shader, pose);
            _receivers.Upload(TubeKernels.ReceiverRows(pose, _scene.Centre).ToArray());
            _shader.SetBuffer(_facets, TubeIDs._Receivers, _receivers.Buffer);
            double extent = math.distance(_scene.Min, _scene.Max);
            _shader.SetVector(ShaderIDs._SceneCentreExtent, KernelCalls.ToVector(_scene.Centre, (float)extent));
            _shader.SetFloat(TubeIDs._WaveNumber, (float)(2 * Math.PI / Signal.Wavelength(frequency)));
            _shader.SetVector(SeaIDs._SeaWind, KernelCalls.ToVector(clutter.Wind, (float)(RelativeOffset * extent)));
            SeaSigma.SetMirrorPoints(_shader, clutter.TableAt(frequency));
            // One speckle for all frequencies of a band: it is the sea's.
            double centre = pose.BandCentre ?? frequency, now = clutter.Time + time,
                times = now / clutter.CoherenceTimeAt(centre), whole = Math.Floor(times);
            double epoch = SecondsAnEpoch * Math.Floor(clutter.Time / SecondsAnEpoch),
                turns = 2 / Signal.Wavelength(frequency);
            float first = math.asfloat(math.asuint((float)turns) & 0xfffff000);
            _shader.SetVector(SeaIDs._SeaTime, new Vector4((float)epoch, (float)(now - epoch), (float)(times - whole),
                (float)SeaClutter.ApproachingExponent));
            _shader.SetInt(SeaIDs._SeaMoment, unchecked((int)(long)whole));
            _shader.SetVector(SeaIDs._SeaTurns, new Vector4(first, (float)(turns - first)));
            _shader.SetFloat(SeaIDs._SeaWaveNumber, (float)(2 * Math.PI / Signal.Wavelength(centre)));
            _shader.SetFloat(SeaIDs._SeaElapsed, (float)time);
            SetFootprint(_shader, pose.Footprint, _scene.Centre);
            SetCells(grid);
        }

        void SetLevel(ClutterLevelTable level)
        {
            _sea.Levels.Upload(level == null ? Array.Empty<float4>() : level.Values.ToArray());
            _shader.SetInt(SeaIDs._SeaLevelCount, level == null ? 0 : level.Values.Count);
            _shader.SetBuffer(_facets, SeaIDs._SeaLevels, _sea.Levels.Buffer);
        }

        /// <summary>Sets the picture outside of which nothing is lit: Shaders/Footprint.hlsl.</summary>
        /// <param name="centre">Origin of the kernels' coordinates.</param>
        public static void SetFootprint(ComputeShader shader, RadarFootprint footprint, double3 centre)
        {
            if (footprint == null)
            {
                shader.SetVector(SeaIDs._FootprintPosition, Vector4.zero);
                return;
            }
            var view = footprint.View;
            shader.SetVector(SeaIDs._FootprintPosition, KernelCalls.ToVector(view.Position - centre, 1));
            shader.SetVector(SeaIDs._FootprintRight, KernelCalls.ToVector(view.Right, (float)footprint.HalfSize.x));
            shader.SetVector(SeaIDs._FootprintUp, KernelCalls.ToVector(view.Up, (float)footprint.HalfSize.y));
            shader.SetVector(SeaIDs._FootprintForward,
                KernelCalls.ToVector(view.Forward, view.IsParallel ? 1 : 0));
        }

        void SetCells(ClutterGrid grid)
        {
            double3 from = _scene.Centre - grid.Corner;
            _shader.SetVector(SeaIDs._SeaCellX, KernelCalls.ToVector(grid.X, (float)math.dot(grid.X, from)));
            _shader.SetVector(SeaIDs._SeaCellY, KernelCalls.ToVector(grid.Y, (float)math.dot(grid.Y, from)));
            _shader.SetInts(SeaIDs._SeaCells, grid.Cells.x, grid.Cells.y, ClutterSums.CopiesOf(grid.Count), 0);
        }

        // From the scene's centre to the phase centre.
        Complex PhaseOf(CrossSectionPose pose, double frequency) => Complex.FromPolarCoordinates(1,
            4 * Math.PI / Signal.Wavelength(frequency) * pose.NearerBy(_scene.Centre));

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _sea.Dispose();
            _output.Dispose();
            _receivers.Dispose();
        }
    }
}
