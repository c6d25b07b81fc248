using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The slices in which the tiles of a pose are traced. It owns every limit of a dispatch: the operating system's
    /// watchdog (<see cref="DispatchPacer"/>), buffer sizes, and thread groups along an axis. It also estimates the
    /// memory of a pose before its trace.
    /// </summary>
    public sealed class DispatchPlan
    {
        /// <summary>
        /// Maximum rays of a refine dispatch: a millisecond on a GPU, where a launch lasts as long as its longest ray;
        /// one to six seconds on a software device.
        /// </summary>
        public const int MaxRefinedRays = 1 << 18;

        /// <summary>
        /// Maximum rays of a dispatch that records paths: some hundredths of a second on a software device.
        /// </summary>
        const int MaxPathRays = 1 << 16;

        // Maximum rays of one slice if all are read back: 96 MiB.
        const int MaxKeptRays = 1 << 21;

        // Minimum tiles on a GPU for entry points: with fewer, finding them costs what they save.
        const int TilesToFillAGpu = 100000;

        readonly DispatchPacer _pacer;
        readonly RadarSettings _settings;
        readonly RayReadback _keep;
        readonly int _tiles, _tilesPerCell, _tilesADispatch;

        /// <param name="cells">Of the tiles to trace.</param>
        /// <param name="usesEntryPoints">Whether the scene has few enough instances for entry points.</param>
        /// <param name="tilesADispatch">Tiles of a slice in tests; 0: those of the pacer.</param>
        internal DispatchPlan(in RadarSettings settings, RayReadback readback, TileCells cells, bool usesEntryPoints,
            DispatchPacer pacer, int tilesADispatch)
        {
            _settings = settings;
            _keep = readback;
            _tiles = cells.TileCount;
            _tilesPerCell = cells.Size.x * cells.Size.y;
            _pacer = pacer;
            _tilesADispatch = tilesADispatch;
            UsesEntryPoints = usesEntryPoints;
        }

        /// <summary>Whether rays start at the entry points of their cell.</summary>
        public bool UsesEntryPoints { get; }

        /// <summary>First tile of the slice, and its number of tiles.</summary>
        public int First { get; private set; }

        /// <inheritdoc cref="First"/>
        public int Count { get; private set; }

        /// <summary>Number of cells that hold the tiles of the slice.</summary>
        public int Cells => (First + Count - 1) / _tilesPerCell - First / _tilesPerCell + 1;

        /// <summary>Whether the slice has all tiles.</summary>
        public bool IsWhole => Count == _tiles;

        /// <summary>Fraction of the tiles up to the end of this slice, 0 to 1.</summary>
        public double Done => (double)(First + Count) / _tiles;

        /// <summary>Moves to the next slice.</summary>
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
            return true;
        }

        /// <summary>Records that the slice is traced; its time decides the size of the next one.</summary>
        public void Traced(double seconds) => _pacer.Took(Count, seconds);

        /// <summary>Number of rays whose paths one dispatch records.</summary>
        public static int PathRays(in RadarSettings settings) =>
            (int)Math.Min(MaxPathRays, DeviceBuffer<HitData>.MaxCount / settings.MaxBounces);

        /// <summary>Whether finding entry points costs less than it saves.</summary>
        public static bool EntryPointsPay(long tiles, bool isSoftware) => isSoftware || tiles >= TilesToFillAGpu;

        /// <summary>Refuses a pose that does not fit, before its scene is gathered or built.</summary>
        /// <exception cref="GlintException">This computer cannot hold the rays read back.</exception>
        public static void Check(in RadarSettings settings, RayReadback readback, string owner) =>
            RayReadbackBuffer.Refuse(readback, settings, owner);

        /// <summary>
        /// Estimated bytes of a pose: of all buffers on the device, and on this computer. BVHs have their minimum size,
        /// and a slice its maximum. Received rays, whose number is unknown, are not included.
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
            double bytesPerCell = sizeof(uint) + (usesEntryPoints ? DeviceScene.MaxInlineInstances * Size<uint4>() : 0);
            double cells = Math.Min(tiles, TileCells.Max) * bytesPerCell;
            tiles = Math.Min(tiles, MaxTiles(readback));
            return (trees + positions + cells + SliceOutput.MinBytes
                + SlicePass.Bytes(pose.Settings, tiles * PictureTiles.Rays, readback),
                trees + BytesOf(meshes) + rays);
        }

        static double BytesOf(IEnumerable<TriangleMesh> meshes) => meshes.Sum(mesh =>
            mesh.Vertices.Length * (double)Size<float3>() + mesh.Indices.Length * (double)sizeof(int));

        // Maximum tiles of a slice, by the groups of one dispatch, the list of candidates and the rays read back.
        static long MaxTiles(RayReadback readback)
        {
            long tiles = Math.Min(TraceKernel.MaxTiles, CandidateList.MaxRays / PictureTiles.Rays);
            return readback == RayReadback.All
                ? Math.Min(tiles, Math.Min(DeviceBuffer<RayData>.MaxCount, MaxKeptRays) / PictureTiles.Rays)
                : tiles;
        }

        static int Size<T>() where T : struct => Marshal.SizeOf<T>();
    }
}
