using System;
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
        public const int FirstSum = 16, SumWords = 32;

        /// <summary>Words of the sums of a part: PART_WORDS.</summary>
        public const int PartWords = 16;

        const int Group = 64;              // GLINT_GROUP

        /// <summary>Cells into which one is divided, and their corners: BLOCK_CELLS, BLOCK_CORNERS.</summary>
        public const int BlockCells = 4, BlockCorners = 9;

        /// <summary>Lists that a corner of a patch is in: VERTEX_LINKS.</summary>
        public const int VertexLinks = 4;

        /// <summary>Side of a block of base cells in which a triangle may be seen: COVER_SIDE.</summary>
        public const int CoverSide = 8;

        readonly ComputeShader _shader;
        readonly TubeRounds _rounds;
        readonly int _clearMarks, _mark, _cover, _corners, _cells, _fringes, _points, _parts;

        /// <param name="shader">Shaders/Tubes.compute.</param>
        public TubeKernels(ComputeShader shader)
        {
            _shader = shader;
            _rounds = new TubeRounds(shader, "TubeCells", "TubeBorders", "TubeCorners");
            _clearMarks = shader.FindKernel("ClearMarks");
            _mark = shader.FindKernel("MarkVertices");
            _cover = shader.FindKernel("MarkCover");
            _corners = shader.FindKernel("TubeCorners");
            _cells = shader.FindKernel("TubeCells");
            _fringes = shader.FindKernel("TubeFringes");
            _points = shader.FindKernel("TubePoints");
            _parts = shader.FindKernel("TubeParts");
        }

        /// <summary>Sets the scene.</summary>
        public void SetScene(DeviceScene scene, SurfaceBuffers surfaces)
        {
            foreach (int kernel in _rounds.Tracing.Append(_fringes).Append(_points))
            {
                _shader.SetBvhs(kernel, scene);
                _shader.SetBuffer(kernel, TubeIDs._Facets, surfaces.Facets.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._NormalFields, surfaces.NormalFields.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._InstanceFacets, surfaces.InstanceFacets.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Motions, surfaces.Motions.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Reflections, surfaces.Reflections.Buffer);
            }
        }

        /// <summary>Sets illumination and receivers.</summary>
        public void SetPose(CrossSectionPose pose, TubeGrid grid)
        {
            var rays = grid.Rays;
            _shader.SetRays(rays);
            _shader.SetVector(ShaderIDs._SceneCentreExtent, KernelCalls.ToVector(rays.SceneCentre, (float)rays.SceneExtent));
            _shader.SetInt(ShaderIDs._MaxBounces, pose.MaxBounces);

            _shader.SetVector(TubeIDs._SentV, KernelCalls.ToVector(pose.Radar.Up));
            _shader.SetVector(TubeIDs._SentH, KernelCalls.ToVector(pose.Radar.Right));
            SetReceivers(_shader, pose, rays.SceneCentre);
            _shader.SetFloat(TubeIDs._RadarPhase, (float)grid.RadarPhaseOf(pose));
            _shader.SetInt(TubeIDs._ReceiverCount, pose.Receivers.Length);
            _shader.SetInt(TubeIDs._SlotCount, TubeSums.SlotsOf(pose));
            _shader.SetInt(TubeIDs._SumCopies, TubeSums.CopiesOf(pose));
            bool isMonostatic =
                pose.Receivers.Length == 1 && pose.Receivers[0].ToRadar.Equals(pose.Radar.ToRadar);
            _shader.SetInt(TubeIDs._IsMonostatic, isMonostatic ? 1 : 0);
            _shader.SetInt(TubeIDs._FadesShadows, pose.FadesShadows ? 1 : 0);
            _shader.SetInt(TubeIDs._OnlyBounce, pose.OnlyBounce);
            _shader.SetInt(TubeIDs._IsMoving, pose.IsMoving ? 1 : 0);
            _shader.SetInt(TubeIDs._FrequencyCount, pose.Samples);
            int together = 1;
            while (together < pose.Samples && together < Group)
                together *= 2;
            _shader.SetInt(TubeIDs._FrequenciesAGroup, together);
            _shader.SetInt(TubeIDs._FrequencyGroups, (pose.Samples + together - 1) / together);
        }

        /// <summary>Sets the receivers, and behind them the radar.</summary>
        /// <param name="centre">Origin of the kernels' coordinates.</param>
        public static void SetReceivers(ComputeShader shader, CrossSectionPose pose, double3 centre)
        {
            double3 from = pose.PhaseCentre - centre;
            shader.SetVectorArray(TubeIDs._Receivers, Padded(pose, receiver =>
            {
                double3 at = pose.IsFar ? receiver.ToRadar : from + pose.Range * receiver.ToRadar;
                return KernelCalls.ToVector(at, (float)math.length(at));
            }));
            shader.SetVectorArray(TubeIDs._ReceiversV, Padded(pose, receiver => KernelCalls.ToVector(receiver.Up)));
            shader.SetVectorArray(TubeIDs._ReceiversH, Padded(pose, receiver => KernelCalls.ToVector(receiver.Right)));
            shader.SetInt(TubeIDs._IsNear, pose.IsFar ? 0 : 1);
            shader.SetFloat(TubeIDs._Range, pose.IsFar ? 0 : (float)pose.Range);
        }

        /// <summary>Sets the units of the sums.</summary>
        public void SetUnits(TubeSums sums)
        {
            _shader.SetFloat(TubeIDs._WaveNumber, (float)sums.WaveNumber);
            _shader.SetFloat(TubeIDs._UnitsPerMetre, (float)sums.UnitsPerMetre);
            _shader.SetFloat(TubeIDs._UnitsPerSquareMetre, (float)sums.UnitsPerSquareMetre);
        }

        /// <inheritdoc cref="TubeRounds.SetAccuracy"/>
        public void SetAccuracy(double cellError, int maxLevel, int maxBisections) =>
            _rounds.SetAccuracy(cellError, maxLevel, maxBisections);

        /// <summary>Sums S of all receivers and frequencies.</summary>
        public void SumAll()
        {
            _rounds.SumBy(null);
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
        public void SetLists(DeviceBuffer<uint> output, DeviceBuffer<Tube> tubes, DeviceBuffer<uint> tubeParts,
            DeviceBuffer<float4> tubeRates, DeviceBuffer<TubeCell> cells, DeviceBuffer<TubeCell> borders,
            DeviceBuffer<TubeCorner> corners, DeviceBuffer<float4> waveNumbers, int cellCapacity)
        {
            foreach (int kernel in new[] { _corners, _cells })
                _shader.SetBuffer(kernel, TubeIDs._Corners, corners.Buffer);
            _rounds.SetLists(output, tubes, cells, borders, waveNumbers, cellCapacity);
            foreach (int kernel in _rounds.Tracing.Concat(new[] { _rounds.Summing, _fringes, _points, _parts }))
                _shader.SetBuffer(kernel, TubeIDs._TubeRates, tubeRates.Buffer);
            foreach (int kernel in new[] { _fringes, _points, _parts })
            {
                _shader.SetBuffer(kernel, ShaderIDs._Sums, output.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Tubes, tubes.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._TubeParts, tubeParts.Buffer);
            }
            foreach (int kernel in _rounds.Tracing)
                _shader.SetBuffer(kernel, TubeIDs._TubeParts, tubeParts.Buffer);
            _shader.SetBuffer(_parts, TubeIDs._WaveNumbers, waveNumbers.Buffer);
        }

        /// <summary>Words of the marks of a grid: a list of corners a cell, and the cover.</summary>
        public static int MarkWordsOf(TubeGrid grid) =>
            (int)grid.Count + (BlocksOf(grid).x * BlocksOf(grid).y + 31) / 32 + 1;

        static int2 BlocksOf(TubeGrid grid) => (grid.Cells + CoverSide - 1) / CoverSide;

        /// <summary>
        /// Lists the corners of patches seen near each cell, and marks the cells in which any triangle is.
        /// </summary>
        public void Mark(TubeGrid grid, SurfaceBuffers surfaces, DeviceBuffer<uint> marks, DeviceBuffer<uint4> links)
        {
            var toCell = grid.ToCell();
            _shader.SetVector(TubeIDs._GridX, KernelCalls.ToVector(toCell[0].Vector, (float)toCell[0].Constant));
            _shader.SetVector(TubeIDs._GridY, KernelCalls.ToVector(toCell[1].Vector, (float)toCell[1].Constant));
            _shader.SetVector(TubeIDs._GridDepth, KernelCalls.ToVector(toCell[2].Vector, (float)toCell[2].Constant));
            int words = MarkWordsOf(grid);
            var blocks = BlocksOf(grid);
            _shader.SetInts(TubeIDs._Blocks, blocks.x, blocks.y, 0, 0);
            _shader.SetInt(TubeIDs._SphereCount, surfaces.SphereCount);
            _shader.SetInt(TubeIDs._MarkWords, words);
            _shader.SetInt(TubeIDs._VertexCount, surfaces.VertexCount);
            _shader.SetInts(TubeIDs._Grid, grid.Cells.x, 0, 0, 0);
            foreach (int kernel in new[] { _clearMarks, _mark, _cover })
                _shader.SetBuffer(kernel, TubeIDs._WrittenMarks, marks.Buffer);
            _shader.SetBuffer(_mark, TubeIDs._Vertices, surfaces.Vertices.Buffer);
            _shader.SetBuffer(_cover, TubeIDs._Spheres, surfaces.Spheres.Buffer);
            _shader.SetBuffer(_mark, TubeIDs._WrittenLinks, links.Buffer);
            foreach (int kernel in new[] { _corners, _cells, _points })
                _shader.SetBuffer(kernel, TubeIDs._Marks, marks.Buffer);
            foreach (int kernel in new[] { _corners, _cells })
                _shader.SetBuffer(kernel, TubeIDs._Links, links.Buffer);
            _shader.DispatchThreads(_clearMarks, words);
            _shader.DispatchThreads(_mark, surfaces.VertexCount);
            _shader.DispatchThreads(_cover, surfaces.SphereCount);
        }

        /// <inheritdoc cref="TubeRounds.Clear"/>
        public void Clear(int count) => _rounds.Clear(count);

        /// <inheritdoc cref="TubeRounds.Trace"/>
        public void Trace(TubeGrid grid, long first, int count, int rounds, int bisections) =>
            _rounds.Trace(grid.Cells.x, first, count, rounds, bisections);

        /// <summary>Sums the currents at points of a uniform grid in base cells.</summary>
        /// <param name="across">Points along a side of a base cell.</param>
        /// <param name="offset">Of the first point of a base cell, in spacings of points.</param>
        public void TracePoints(TubeGrid grid, long first, int count, int across, double2 offset)
        {
            _shader.SetInts(TubeIDs._Grid, grid.Cells.x, (int)first, count, Math.Min(count, grid.Cells.x));
            _shader.SetInt(TubeIDs._PointsAcross, across);
            _shader.SetVector(TubeIDs._FirstPoint, new Vector4((float)offset.x, (float)offset.y));
            _shader.DispatchThreads(_points, (long)count * across * across);
            _rounds.Sum();
        }

        /// <summary>Sums the fringe fields of pieces of edges.</summary>
        /// <param name="offset">Of the starts of shadow rays from their edges, metres.</param>
        public void TraceEdges(EdgeBuffers edges, int first, int count, int receivers, double offset)
        {
            _shader.SetBuffer(_fringes, TubeIDs._EdgePieces, edges.Pieces.Buffer);
            _shader.SetInts(TubeIDs._EdgeRange, first, count, 0, 0);
            _shader.SetFloat(TubeIDs._EdgeOffset, (float)offset);
            _shader.DispatchThreads(_fringes, (long)count * receivers);
            _rounds.Sum();
        }

        public void Dispose() => _rounds.Dispose();

        // The receivers, and the radar behind MaxReceivers of them.
        static Vector4[] Padded(CrossSectionPose pose, Func<RadarAspect, Vector4> value) =>
            pose.Receivers.Select(value).Concat(Enumerable.Repeat(Vector4.zero, MaxReceivers - pose.Receivers.Length))
                .Append(value(pose.Radar)).ToArray();
    }
}
