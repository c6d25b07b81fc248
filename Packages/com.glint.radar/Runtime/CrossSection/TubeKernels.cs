using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>The kernels of Shaders/Tubes.compute and their inputs.</summary>
    sealed class TubeKernels : IDisposable
    {
        /// <summary>Maximum receivers of a trace: MAX_RECEIVERS in Shaders/TubeBindings.hlsl.</summary>
        public const int MaxReceivers = 16;

        /// <summary>Words of the output before the sums, and of each sum: TUBE_SUMS, TUBE_SUM_WORDS.</summary>
        public const int FirstSum = 8216, SumWords = 32;

        /// <summary>Poses of a dispatch at most: MAX_POSES.</summary>
        public const int MaxPoses = 128;

        /// <summary>Words of the sums of a part: PART_WORDS.</summary>
        public const int PartWords = 16;

        // No more than the threads of a group: GLINT_GROUP.
        const int MaxFrequenciesAGroup = 64;

        // 64 MB.
        const int MaxSideLinks = 1 << 22;

        /// <summary>Cells into which one is divided, their corners, and the new ones: BLOCK_, NEW_CORNERS.</summary>
        public const int BlockCells = 4, BlockCorners = 9, NewCorners = 5;

        /// <summary>Lists that a corner of a patch is in: VERTEX_LINKS.</summary>
        public const int VertexLinks = 4;

        /// <summary>Rows of a side of a triangle on the outline of its patch: SIDE_ROWS.</summary>
        public const int SideRows = 3;

        /// <summary>Elements of the links of a line on the grid, and rows of a silhouette: LINE_LINKS, SILHOUETTE_ROWS.</summary>
        public const int LineLinks = 2, SilhouetteRows = 4;

        /// <summary>Rows of a flat patch and of a piece of an outline: MIRROR_ROWS, OUTLINE_ROWS.</summary>
        public const int MirrorRows = 3, OutlineRows = 3;

        // Elements of links of the lines of a pose at most: 16 MB. Lines for each piece of a silhouette or of an outline: few cast a
        // shadow or are mirrored.
        const int MaxLineLinks = 1 << 20, LinksASilhouette = 8, LinksAnOutline = 8;

        // Of the kernel of shadows, a thread a piece, receiver and pose.
        const int ShadowThreads = 1 << 22;

        /// <summary>Rows of a tube in _TubeExtras at a finite range: TUBE_EXTRAS.</summary>
        public const int TubeExtras = 5;

        /// <summary>Words of the revealed cells of a pose: REVEALED_WORDS.</summary>
        public const int RevealedWords = 65536;

        /// <summary>Side of a block of base cells in which a triangle may be seen: COVER_SIDE.</summary>
        public const int CoverSide = 8;

        readonly ComputeShader _shader;
        readonly TubeRounds.RayKernels _rays;
        readonly TubeRounds _rounds;
        readonly DeviceBuffer<TubePose> _poses = new DeviceBuffer<TubePose>("poses");
        readonly DeviceBuffer<float4> _receivers = new DeviceBuffer<float4>("receivers");
        TubePose[] _slices;
        readonly DeviceBuffer<float4> _blocks = new DeviceBuffer<float4>("blocks of frequencies");
        readonly RevealedBits _revealed;
        readonly int _clearMarks, _mark, _outlines, _cover, _shadows, _images, _cells, _fringes, _points, _parts, _bands;
        bool _hasBands;

        /// <param name="shader">Shaders/Tubes.compute.</param>
        public TubeKernels(ComputeShader shader)
        {
            DeviceArithmetic.Check(shader);
            _shader = shader;
            _rays = new TubeRounds.RayKernels(shader);
            _rounds = new TubeRounds(shader, "TubeCorners", "TubeCells", "TubeBorders", _rays);
            _clearMarks = shader.FindKernel("ClearMarks");
            _mark = shader.FindKernel("MarkVertices");
            _outlines = shader.FindKernel("MarkOutlines");
            _cover = shader.FindKernel("MarkCover");
            _shadows = shader.FindKernel("TubeShadows");
            _images = shader.FindKernel("TubeImages");
            _revealed = new RevealedBits(shader);
            _cells = shader.FindKernel("TubeCells");
            _fringes = shader.FindKernel("TubeFringes");
            _points = shader.FindKernel("TubePoints");
            _parts = shader.FindKernel("TubeParts");
            _bands = shader.FindKernel("TubeBands");
        }

        /// <summary>Sets the scene.</summary>
        public void SetScene(DeviceScene scene, SurfaceBuffers surfaces)
        {
            foreach (int kernel in _rounds.Kernels.Append(_fringes).Append(_points))
            {
                _shader.SetBvhs(kernel, scene);
                _shader.SetBuffer(kernel, TubeIDs._Facets, surfaces.Patches.Facets.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._NormalFields, surfaces.Patches.NormalFields.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._InstanceFacets, surfaces.Patches.InstanceFacets.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Motions, surfaces.Motions.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Reflections, surfaces.Reflections.Buffer);
            }
        }

        /// <summary>Sets illumination and receivers of poses that differ in nothing else.</summary>
        public void SetPoses(IReadOnlyList<TubeJob> jobs)
        {
            var (pose, rays) = (jobs[0].Pose, jobs[0].Grid.Rays);
            _shader.SetVector(ShaderIDs._SceneCentreExtent, KernelCalls.ToVector(rays.SceneCentre, (float)rays.SceneExtent));
            _shader.SetInt(ShaderIDs._MaxBounces, pose.MaxBounces);
            _slices = jobs.Select(job => new TubePose(job.Pose, job.Grid, BlocksOf(job.Grid))).ToArray();
            _poses.Upload(_slices);
            _receivers.Upload(jobs.SelectMany(job => ReceiverRows(job.Pose, rays.SceneCentre)).ToArray());
            foreach (int kernel in _rounds.Kernels.Concat(new[] { _fringes, _points, _shadows, _images }))
                _shader.SetBuffer(kernel, TubeIDs._Receivers, _receivers.Buffer);
            foreach (int kernel in _rounds.Kernels.Concat(
                new[] { _fringes, _points, _mark, _outlines, _cover, _shadows, _images }))
                _shader.SetBuffer(kernel, TubeIDs._Poses, _poses.Buffer);
            _shader.SetInt(TubeIDs._PoseCount, jobs.Count);
            SeaKernel.SetFootprint(_shader, pose.Footprint, rays.SceneCentre);
            SetReceivers(_shader, pose);
            _rounds.FindsChanges = !pose.IsFar;
            _shader.SetInt(TubeIDs._SlotCount, TubeSums.SlotsOf(pose));
            _shader.SetInt(TubeIDs._SumCopies, TubeSums.CopiesOf(pose));
            _shader.SetInt(TubeIDs._IsMonostatic, pose.IsMonostatic ? 1 : 0);
            _shader.SetInt(TubeIDs._FadesShadows, pose.FadesShadows ? 1 : 0);
            _shader.SetInt(TubeIDs._OnlyBounce, pose.OnlyBounce);
            _shader.SetInt(TubeIDs._IsMoving, pose.IsMoving ? 1 : 0);
            _shader.SetInt(TubeIDs._ExtraRows, ExtraRowsOf(pose));
            SetFrequencies(pose);
        }

        void SetFrequencies(CrossSectionPose pose)
        {
            _shader.SetInt(TubeIDs._FrequencyCount, pose.Samples);
            _hasBands = TubeBands.IsBand(pose);
            int together = 1;
            while (together < pose.Samples && together < MaxFrequenciesAGroup)
                together *= 2;
            int groups = (pose.Samples + together - 1) / together;
            if (_hasBands)
            {
                var blocks = TubeBands.Of(pose);
                _blocks.Upload(blocks);
                _shader.SetBuffer(_bands, TubeIDs._Bands, _blocks.Buffer);
                groups = blocks.Length / TubeBands.Rows;
            }
            _shader.SetInt(TubeIDs._FrequenciesAGroup, together);
            _shader.SetInt(TubeIDs._FrequencyGroups, groups);
        }

        /// <summary>Rows of a tube in _TubeExtras: in the far field, where currents do not change along tubes, its rate.</summary>
        public static int ExtraRowsOf(CrossSectionPose pose) => pose.IsFar ? 1 : TubeExtras;

        /// <summary>Sets what the receivers of poses have in common.</summary>
        public static void SetReceivers(ComputeShader shader, CrossSectionPose pose)
        {
            shader.SetInt(TubeIDs._ReceiverCount, pose.Receivers.Length);
            shader.SetInt(TubeIDs._IsNear, pose.IsFar ? 0 : 1);
            shader.SetFloat(TubeIDs._Range, pose.IsFar ? 0 : (float)pose.Range);
        }

        /// <summary>The receivers, and behind them the radar: three rows of _Receivers each.</summary>
        /// <param name="centre">Origin of the kernels' coordinates.</param>
        public static IEnumerable<float4> ReceiverRows(CrossSectionPose pose, double3 centre)
        {
            double3 from = pose.PhaseCentre - centre;
            foreach (var receiver in pose.Receivers.Append(pose.Radar))
            {
                double3 at = pose.IsFar ? receiver.ToRadar : from + pose.Range * receiver.ToRadar;
                yield return TubePose.RowOf(at, math.length(at));
                yield return TubePose.RowOf(receiver.Up);
                yield return TubePose.RowOf(receiver.Right);
            }
        }

        /// <summary>Sets the units of the sums.</summary>
        public void SetUnits(TubeSums sums)
        {
            _shader.SetFloat(TubeIDs._WaveNumber, (float)sums.WaveNumber);
            _shader.SetFloat(TubeIDs._UnitsPerMetre, (float)sums.UnitsPerMetre);
            _shader.SetFloat(TubeIDs._UnitsPerSquareMetre, (float)sums.UnitsPerSquareMetre);
        }

        /// <summary>Sums S of all receivers and frequencies.</summary>
        public void SumAll()
        {
            _rounds.SumBy(_hasBands ? _bands : (int?)null);
            _shader.SetInt(TubeIDs._HasParts, 0);
        }

        /// <summary>Sums the parts of S at one receiver and frequency instead.</summary>
        /// <param name="firstWord">Of the parts, in the output.</param>
        public void SumParts(SceneParts parts, int receiver, int frequency, int firstWord)
        {
            _rounds.SumBy(_parts);
            _shader.SetInt(TubeIDs._HasParts, 1);
            _shader.SetInts(TubeIDs._Parts, receiver, frequency, firstWord, parts.FirstBounce);
        }

        /// <inheritdoc cref="TubeRounds.SetLists"/>
        /// <param name="tubeParts">The part of each tube; one element if they are not asked for.</param>
        /// <param name="tubeExtras"><see cref="ExtraRowsOf"/> rows of each tube.</param>
        public void SetLists(TubeLists lists, DeviceBuffer<uint> tubeParts, DeviceBuffer<float4> tubeExtras)
        {
            _rounds.SetLists(lists);
            foreach (int kernel in _rounds.Kernels.Concat(new[] { _rounds.Summing, _fringes, _points, _parts, _bands }))
                _shader.SetBuffer(kernel, TubeIDs._TubeExtras, tubeExtras.Buffer);
            foreach (int kernel in new[] { _fringes, _points, _parts, _bands })
            {
                _shader.SetBuffer(kernel, ShaderIDs._Sums, lists.Output.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Tubes, lists.Tubes.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._TubeParts, tubeParts.Buffer);
            }
            foreach (int kernel in _rounds.Kernels)
                _shader.SetBuffer(kernel, TubeIDs._TubeParts, tubeParts.Buffer);
            _shader.SetBuffer(_shadows, ShaderIDs._Sums, lists.Output.Buffer);
            _shader.SetBuffer(_images, ShaderIDs._Sums, lists.Output.Buffer);
            foreach (int kernel in new[] { _parts, _bands })
                _shader.SetBuffer(kernel, TubeIDs._WaveNumbers, lists.WaveNumbers.Buffer);
        }

        /// <summary>Words of the marks of a grid: lists of corners and sides a cell, the cover, counts of links.</summary>
        public static long MarkWordsOf(TubeGrid grid) =>
            2 * grid.Count + ((long)BlocksOf(grid).x * BlocksOf(grid).y + 31) / 32 + 3;

        /// <summary>Links of corners and sides in the lists of a grid's cells, at most.</summary>
        public static int LinksOf(TubeGrid grid, SurfaceBuffers surfaces) => 1 + VertexLinks * surfaces.VertexCount
            + (int)Math.Min(MaxSideLinks, 4.0 * surfaces.SideCount + 2 * surfaces.LengthOfSides / grid.Side);

        /// <summary>Of them, elements of shadows and images at most.</summary>
        public static int LineLinksOf(CrossSectionPose pose, SurfaceBuffers surfaces) => (int)Math.Min(MaxLineLinks,
            LineLinks * ((pose.IsMonostatic ? 0 : (long)LinksASilhouette * surfaces.Silhouettes.Count * pose.Receivers.Length)
                + (HasImages(pose) ? LinksAnOutline * surfaces.Mirrors.PieceCount : 0)));

        /// <summary>Whether second bounces count.</summary>
        public static bool HasImages(CrossSectionPose pose) => pose.MaxBounces > 1 && pose.OnlyBounce != 1;

        static int2 BlocksOf(TubeGrid grid) => (grid.Cells + CoverSide - 1) / CoverSide;

        /// <summary>
        /// Lists the corners and outlines of patches seen near each cell, and marks the cells in which any triangle is.
        /// </summary>
        /// <param name="markWords">Of the marks of a pose.</param>
        /// <param name="linkCapacity">Of a pose.</param>
        /// <param name="lineCapacity">Of these links, those of shadows and images.</param>
        public void Mark(int poses, int markWords, int linkCapacity, int lineCapacity, SurfaceBuffers surfaces,
            DeviceBuffer<uint> marks, DeviceBuffer<uint4> links)
        {
            _shader.SetInt(TubeIDs._TriangleCount, surfaces.TriangleCount);
            _shader.SetInt(TubeIDs._PlacedCount, surfaces.InstanceCount);
            _shader.SetInt(TubeIDs._MarkWords, markWords);
            _shader.SetInt(TubeIDs._VertexCount, surfaces.VertexCount);
            _shader.SetInt(TubeIDs._SideCount, surfaces.SideCount);
            _shader.SetInt(TubeIDs._LinkCapacity, linkCapacity);
            _shader.SetInt(TubeIDs._LineCapacity, lineCapacity);
            foreach (int kernel in new[] { _clearMarks, _mark, _outlines, _cover, _shadows, _images })
                _shader.SetBuffer(kernel, TubeIDs._WrittenMarks, marks.Buffer);
            _shader.SetBuffer(_mark, TubeIDs._Vertices, surfaces.Vertices.Buffer);
            _shader.SetBuffer(_cover, TubeIDs._Spheres, surfaces.Spheres.Buffer);
            _shader.SetBuffer(_cover, TubeIDs._Places, surfaces.Places.Buffer);
            _shader.SetBuffer(_cover, TubeIDs._InstanceFacets, surfaces.Patches.InstanceFacets.Buffer);
            foreach (int kernel in new[] { _mark, _outlines, _shadows, _images })
                _shader.SetBuffer(kernel, TubeIDs._WrittenLinks, links.Buffer);
            foreach (int kernel in new[] { _outlines, _cells, _rays.Outlines })
                _shader.SetBuffer(kernel, TubeIDs._Sides, surfaces.Sides.Buffer);
            foreach (int kernel in new[] { _rounds.Corners, _cells, _rays.Outlines, _rays.Centres, _points })
                _shader.SetBuffer(kernel, TubeIDs._Marks, marks.Buffer);
            foreach (int kernel in new[] { _rounds.Corners, _cells, _rays.Outlines, _rays.Centres })
                _shader.SetBuffer(kernel, TubeIDs._Links, links.Buffer);
            _shader.DispatchThreads(_clearMarks, (long)poses * markWords);
            _shader.DispatchThreads(_mark, (long)poses * surfaces.VertexCount);
            _shader.DispatchThreads(_outlines, (long)poses * surfaces.SideCount);
            _shader.DispatchThreads(_cover, (long)poses * surfaces.TriangleCount);
        }

        /// <summary>
        /// Lists the borders of what receivers apart from the radar see, in the cells that they run through. Counts its rays.
        /// </summary>
        /// <param name="poses">Times receivers.</param>
        public void MarkShadows(int poses, DeviceScene scene, SilhouetteBuffers silhouettes)
        {
            _shader.SetBvhs(_shadows, scene);
            _shader.SetBuffer(_shadows, TubeIDs._Silhouettes, silhouettes.Pieces.Buffer);
            int most = Math.Max(1, ShadowThreads / poses);
            for (int first = 0; first < silhouettes.Count; first += most)
            {
                int count = Math.Min(most, silhouettes.Count - first);
                _shader.SetInts(TubeIDs._SilhouetteRange, first, count);
                _shader.DispatchThreads(_shadows, (long)count * poses);
            }
        }

        /// <summary>
        /// Lists the outlines of patches that the radar sees in mirrors, in the cells that they run through. Counts its rays.
        /// </summary>
        public void MarkImages(int poses, DeviceScene scene, MirrorBuffers mirrors)
        {
            _shader.SetBvhs(_images, scene);
            _shader.SetBuffer(_images, TubeIDs._OutlinePieces, mirrors.Pieces.Buffer);
            _shader.SetBuffer(_images, TubeIDs._Mirrors, mirrors.Mirrors.Buffer);
            _shader.SetInt(TubeIDs._OutlinePieceCount, mirrors.PieceCount);
            _shader.SetInt(TubeIDs._MirrorCount, mirrors.MirrorCount);
            if (mirrors.MirrorCount > 0)
                _shader.DispatchThreads(_images, (long)poses * mirrors.PieceCount);
        }

        /// <summary>Makes room for what attempts reveal of poses.</summary>
        public void BindRevealed(int poses) =>
            _revealed.Bind(poses, RevealedWords, new[] { _cells, _rays.Centres }, _rays.Reveals);

        /// <summary>Nothing is revealed of any pose.</summary>
        public void ClearRevealed(int poses) => _revealed.Clear(poses);

        /// <inheritdoc cref="TubeRounds.Clear"/>
        public void Clear(int count) => _rounds.Clear(count);

        /// <summary>
        /// Traces base cells of each pose, in rounds the parts of those that are divided, and sums the tubes.
        /// </summary>
        /// <param name="slices">Of each pose, the first cell and their number: whole rows, or a part of one.</param>
        public void Trace(IReadOnlyList<TubeJob> jobs, (long First, int Count)[] slices)
        {
            _revealed.Take(Enumerable.Range(0, jobs.Count).Where(i => slices[i].Count > 0 && jobs[i].TakesRevealed()));
            var (cells, corners) = SetSlices(jobs, slices);
            var traced = jobs.Where((job, i) => slices[i].Count > 0).ToArray();
            _rounds.Trace(cells, corners, traced.Max(job => job.MaxLevel) + 1, traced.Max(job => job.MaxBisections));
        }

        // Returns the base cells of all poses, and their corners.
        (int Cells, int Corners) SetSlices(IReadOnlyList<TubeJob> jobs, (long First, int Count)[] slices)
        {
            for (int i = 0; i < slices.Length; i++)
                jobs[i].SetAccuracy(ref _slices[i]);
            var (cells, corners) = TubePose.SetSlices(_slices, slices);
            _poses.Upload(_slices);
            _shader.SetInts(TubeIDs._BaseCounts, cells, corners);
            return (cells, corners);
        }

        /// <summary>Corners of cells of a slice: whole rows, or a part of one.</summary>
        /// <param name="across">Cells of a row.</param>
        public static int CornersOf(int cells, int across) =>
            cells == 0 ? 0 : cells < across ? 2 * (cells + 1) : (across + 1) * (cells / across + 1);

        /// <summary>Sums the currents at points of a uniform grid in base cells.</summary>
        /// <param name="across">Points along a side of a base cell.</param>
        /// <param name="offset">Of the first point of a base cell, in spacings of points.</param>
        public void TracePoints(TubeJob job, int count, int across, double2 offset)
        {
            SetSlices(new[] { job }, new[] { (job.Next, count) });
            _shader.SetInt(TubeIDs._Round, 0);
            _shader.SetInt(TubeIDs._PointsAcross, across);
            _shader.SetVector(TubeIDs._FirstPoint, new Vector4((float)offset.x, (float)offset.y));
            _shader.DispatchThreads(_points, (long)count * across * across);
            _rounds.Sum();
        }

        /// <summary>Sums the fringe fields of pieces of edges.</summary>
        /// <param name="offset">Of the starts of shadow rays from their edges, metres.</param>
        /// <param name="poses">Times receivers.</param>
        public void TraceEdges(EdgeBuffers edges, int first, int count, int poses, double offset)
        {
            _shader.SetBuffer(_fringes, TubeIDs._EdgePieces, edges.Pieces.Buffer);
            _shader.SetInts(TubeIDs._EdgeRange, first, count, 0, 0);
            _shader.SetFloat(TubeIDs._EdgeOffset, (float)offset);
            _shader.DispatchThreads(_fringes, (long)count * poses);
            _rounds.Sum();
        }

        public void Dispose()
        {
            _rounds.Dispose();
            _poses.Dispose();
            _receivers.Dispose();
            _blocks.Dispose();
            _revealed.Dispose();
        }
    }
}
