using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The slices in which the tiles of a pose are traced. It owns every limit of a dispatch: what an operating
    /// system's watchdog allows (<see cref="DispatchPacer"/>), what buffers hold, and thread groups along an axis.
    /// It also says, before a pose is traced, what that takes of memory.
    /// </summary>
    sealed class DispatchPlan
    {
        /// <summary>
        /// Rays of a refine dispatch: a millisecond on a GPU, where a launch lasts as long as its longest ray;
        /// one to six seconds on a software device.
        /// </summary>
        public const int MaxRefinedRays = 1 << 18;

        /// <summary>Rays of a dispatch that records paths: some hundredths of a second on a software device.</summary>
        const int MaxPathRays = 1 << 16;

        // Rays of one slice: 96 MiB when all are kept.
        const int MaxKeptRays = 1 << 21;

        // Finding entry points pays when it fills the device: a GPU with fewer tiles spends on it what it saves.
        const int TilesToFillAGpu = 100000;

        readonly DispatchPacer _pacer;
        readonly RadarSettings _settings;
        readonly RayReadback _keep;
        readonly int _tiles, _tilesADispatch;
        readonly Stopwatch _watch = new Stopwatch();

        /// <param name="tiles">Tiles to trace.</param>
        /// <param name="usesEntryPoints">Whether the scene has few enough instances for entry points.</param>
        /// <param name="tilesADispatch">Tiles of a slice in tests; 0: as the pacer says.</param>
        public DispatchPlan(in RadarSettings settings, RayReadback readback, int tiles, bool usesEntryPoints,
            DispatchPacer pacer, int tilesADispatch)
        {
            _settings = settings;
            _keep = readback;
            _tiles = tiles;
            _pacer = pacer;
            _tilesADispatch = tilesADispatch;
            UsesEntryPoints = usesEntryPoints;
        }

        /// <summary>Whether a tile's rays begin at entry points found for the tile.</summary>
        public bool UsesEntryPoints { get; }

        /// <summary>First tile of the slice, and its number of tiles.</summary>
        public int First { get; private set; }

        /// <inheritdoc cref="First"/>
        public int Count { get; private set; }

        /// <summary>Part of the tiles that is traced with this slice, 0 to 1.</summary>
        public double Done => (double)(First + Count) / _tiles;

        /// <summary>Goes on to the next slice.</summary>
        /// <returns>False after the last one.</returns>
        public bool Next()
        {
            First += Count;
            int left = _tiles - First;
            if (left == 0)
                return false;
            int paced = _tilesADispatch > 0
                ? Math.Min(left, _tilesADispatch)
                : _pacer.NextTiles(left, _settings.MaxBounces);
            Count = (int)Math.Min(paced, MaxTiles(_keep));
            _watch.Restart();
            return true;
        }

        /// <summary>The slice's rays are traced: its time decides the size of the next one.</summary>
        public void Traced() => _pacer.Took(Count, _watch.Elapsed.TotalSeconds);

        /// <summary>Rays whose paths one dispatch records.</summary>
        public static int PathRays(in RadarSettings settings) =>
            (int)Math.Min(MaxPathRays, DeviceBuffer<HitData>.MaxCount / settings.MaxBounces);

        /// <summary>Whether finding entry points costs less than it saves.</summary>
        public static bool EntryPointsPay(long tiles, bool isSoftware) => isSoftware || tiles >= TilesToFillAGpu;

        /// <summary>Refuses what does not fit, before a scene is gathered or built for it.</summary>
        /// <exception cref="GlintException">
        /// The device cannot hold as many tiles, or this computer as many rays as are to be kept.
        /// </exception>
        public static void Check(in RadarSettings settings, RayReadback readback, string owner)
        {
            RayReadbackBuffer.Refuse(readback, settings, owner);
            long tiles = PictureTiles.CountIn(settings), max = DeviceBuffer<uint>.MaxCount;
            if (tiles > max)
                throw new GlintException($"{owner}: the list of the picture's {tiles} tiles of 64 rays takes "
                    + $"{Text.Mebibytes(tiles * 4.0)}, and {SystemInfo.graphicsDeviceName} holds "
                    + $"{Text.Mebibytes(max * 4.0)} in one buffer: trace a region or fewer rays");
        }

        /// <summary>
        /// What a pose takes, before it is traced: bytes of all buffers on the device, and bytes here.
        /// BVHs count with what they take at least;
        /// a slice as if it took all tiles of the picture, or as many as one may.
        /// Received rays, whose number is not known, are not in it.
        /// </summary>
        public static (double DeviceBytes, double HostBytes) Memory(in RadarPose pose,
            RayReadback readback, bool isSoftware)
        {
            var instances = pose.Scene.Instances;
            var meshes = instances.Select(instance => instance.Mesh).Distinct().ToArray();
            double trees = DeviceBvhs.MinBytes(meshes, isSoftware ? BvhLayout.Wide : BvhLayout.Binary);
            double positions =
                instances.Length * (Size<InstanceRecord>() + InstanceBvh.MinRowsPerBox(BvhLayout.Binary) * 16);
            long tiles = PictureTiles.CountIn(pose.Settings);
            bool usesEntryPoints = instances.Length <= DeviceScene.MaxInlineInstances
                && EntryPointsPay(tiles, isSoftware);
            double rays = readback == RayReadback.All ? pose.Settings.RaysEmitted * (double)Size<RayData>() : 0;
            return (trees + positions + tiles * (double)sizeof(uint) + SliceBytes(tiles, readback, usesEntryPoints),
                trees + BytesOf(meshes) + rays);
        }

        static double BytesOf(IEnumerable<TriangleMesh> meshes) => meshes.Sum(mesh =>
            mesh.Vertices.Length * (double)Size<float3>() + mesh.Indices.Length * (double)sizeof(int));

        static double SliceBytes(long tiles, RayReadback readback, bool usesEntryPoints)
        {
            tiles = Math.Min(tiles, MaxTiles(readback));
            double rays = (double)tiles * PictureTiles.Rays;
            double kept =
                readback == RayReadback.All ? rays
                    : readback == RayReadback.Received ? Math.Min(rays, MaxRefinedRays)
                    : 1;
            return Channel.Slots * Channel.WordsPerSlot * sizeof(uint)
                + rays * Size<ReceivedRay>() + kept * Size<RayData>()
                + (usesEntryPoints ? tiles * (double)DeviceScene.MaxInlineInstances * Size<uint4>() : 0);
        }

        // Tiles that the groups of one dispatch, the list of candidates, entry points and kept rays have room for.
        static long MaxTiles(RayReadback readback)
        {
            long tiles = Math.Min(TraceKernel.MaxTiles, DeviceBuffer<ReceivedRay>.MaxCount / PictureTiles.Rays);
            tiles = Math.Min(tiles, DeviceBuffer<uint4>.MaxCount / DeviceScene.MaxInlineInstances);
            return readback == RayReadback.All
                ? Math.Min(tiles, Math.Min(DeviceBuffer<RayData>.MaxCount, MaxKeptRays) / PictureTiles.Rays)
                : tiles;
        }

        static int Size<T>() where T : struct => Marshal.SizeOf<T>();
    }
}
