using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>The kernels of Shaders/Amplitude.compute and their inputs.</summary>
    sealed class AmplitudeKernels : IDisposable
    {
        /// <summary>Words of the parts of a base cell: REVEALED_PARTS in Shaders/AmplitudePath.hlsl.</summary>
        public const int RevealedWords = 32;

        const int PointLandings = 2;       // POINT_LANDINGS in Shaders/AmplitudePath.hlsl, of two words each

        static readonly int s_cellError = Shader.PropertyToID("_CellError");
        static readonly int s_maxLevel = Shader.PropertyToID("_MaxLevel");
        static readonly int s_maxBisections = Shader.PropertyToID("_MaxBisections");
        static readonly int s_grid = Shader.PropertyToID("_Grid");
        static readonly int s_pictureStart = Shader.PropertyToID("_PictureStart");
        static readonly int s_pictureStep = Shader.PropertyToID("_PictureStep");
        static readonly int s_aside = Shader.PropertyToID("_Aside");
        static readonly int s_receiverDepth = Shader.PropertyToID("_ReceiverDepth");
        static readonly int s_emptyLevel = Shader.PropertyToID("_EmptyLevel");
        static readonly int s_pointWords = Shader.PropertyToID("_PointWords");
        static readonly int s_pointCapacity = Shader.PropertyToID("_PointCapacity");
        static readonly int s_revealed = Shader.PropertyToID("_Revealed");
        static readonly int s_revealedByNow = Shader.PropertyToID("_RevealedByNow");
        static readonly int s_revealedWords = Shader.PropertyToID("_RevealedWords");
        static readonly int s_points = Shader.PropertyToID("_Points");

        readonly ComputeShader _shader;
        readonly int _corners, _cells, _borders;

        /// <param name="shader">Shaders/Amplitude.compute.</param>
        public AmplitudeKernels(ComputeShader shader)
        {
            _shader = shader;
            _corners = shader.FindKernel("AmplitudePoints");
            _cells = shader.FindKernel("AmplitudeCells");
            _borders = shader.FindKernel("AmplitudeBorders");
            Rounds = new TubeRounds(shader, "AmplitudeCells", "AmplitudeBorders");
        }

        /// <summary>The kernels that divide cells.</summary>
        public TubeRounds Rounds { get; }

        /// <summary>Words of a point.</summary>
        public static int PointWords(int maxBounces) => PointLandings + 2 * maxBounces;

        /// <summary>Sets the scene.</summary>
        public void SetScene(DeviceScene scene, SurfaceBuffers surfaces)
        {
            foreach (int kernel in TracingKernels())
            {
                _shader.SetBvhs(kernel, scene);
                _shader.SetBuffer(kernel, TubeIDs._Facets, surfaces.Facets.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._InstanceFacets, surfaces.InstanceFacets.Buffer);
            }
        }

        /// <summary>Sets radar, receiver and picture.</summary>
        public void SetPose(in RadarPose pose, RayGrid rays, AmplitudeGrid grid, float waveNumber)
        {
            var (settings, view) = (pose.Settings, pose.View);
            _shader.SetRays(rays);
            _shader.SetReceiver(view, rays);
            _shader.SetVector(ShaderIDs._SceneCentreExtent, KernelCalls.ToVector(rays.SceneCentre, (float)rays.SceneExtent));
            _shader.SetInt(ShaderIDs._MaxBounces, settings.MaxBounces);
            double2 start = grid.Lower - rays.ReferencePixel;
            _shader.SetVector(s_pictureStart, new Vector4((float)start.x, (float)start.y, 0, 0));
            _shader.SetVector(s_pictureStep, new Vector4((float)grid.Step.x, (float)grid.Step.y, 0, 0));
            _shader.SetVector(s_aside, KernelCalls.ToVector(rays.Direction - view.Forward, view.IsParallel ? 1 : 0));
            _shader.SetFloat(s_receiverDepth, (float)ReceiverDepth(view, rays));
            _shader.SetInt(s_pointWords, PointWords(settings.MaxBounces));
            _shader.SetFloat(TubeIDs._WaveNumber, waveNumber);
            // One receiver, one frequency.
            _shader.SetInt(TubeIDs._ReceiverCount, 1);
            _shader.SetInt(TubeIDs._PoseCount, 1);
            _shader.SetInt(TubeIDs._SlotCount, 1);
            _shader.SetInt(TubeIDs._SumCopies, 1);
            _shader.SetInt(TubeIDs._FrequencyCount, 1);
            _shader.SetInt(TubeIDs._FrequenciesAGroup, 1);
            _shader.SetInt(TubeIDs._FrequencyGroups, 1);
        }

        /// <summary>Distance from the receiver's plane to the scene's centre, metres.</summary>
        public static double ReceiverDepth(in RadarView view, RayGrid rays) =>
            math.dot(rays.SceneCentre - view.ReceiverCentre, view.ReceiverForward);

        /// <summary>Sets the units of the sums, per area of a base cell and per its square.</summary>
        public void SetUnits(double unitsPerCell, double unitsPerSquare)
        {
            _shader.SetFloat(TubeIDs._UnitsPerMetre, (float)unitsPerCell);
            _shader.SetFloat(TubeIDs._UnitsPerSquareMetre, (float)unitsPerSquare);
        }

        /// <summary>Sets how finely cells are divided and borders found.</summary>
        /// <param name="cellError">Error that a cell may have, of its phasor times area.</param>
        /// <param name="maxLevel">Divisions of a base cell at most.</param>
        /// <param name="maxBisections">Of the sides of a base cell towards a border.</param>
        public void SetAccuracy(double cellError, int maxLevel, int maxBisections)
        {
            _shader.SetFloat(s_cellError, (float)cellError);
            _shader.SetInt(s_maxLevel, maxLevel);
            _shader.SetInt(s_maxBisections, maxBisections);
        }

        /// <summary>Sets the list of points.</summary>
        public void SetPoints(DeviceBuffer<uint> output, DeviceBuffer<uint> points, int capacity)
        {
            _shader.SetBuffer(_corners, ShaderIDs._Sums, output.Buffer);
            foreach (int kernel in TracingKernels())
                _shader.SetBuffer(kernel, s_points, points.Buffer);
            _shader.SetInt(s_pointCapacity, capacity);
        }

        /// <summary>Sets the parts of cells in which earlier attempts have found more, and those of this one.</summary>
        public void SetRevealed(DeviceBuffer<uint> revealed, DeviceBuffer<uint> revealedByNow, int count)
        {
            _shader.SetBuffer(_cells, s_revealed, revealed.Buffer);
            _shader.SetBuffer(_borders, s_revealedByNow, revealedByNow.Buffer);
            _shader.SetInt(s_revealedWords, count);
        }

        /// <summary>Traces rows of base cells.</summary>
        public void Trace(AmplitudeGrid grid, int firstRow, int rows, int rounds, int bisections, int emptyLevel)
        {
            int across = grid.Count.x, first = firstRow * across, count = rows * across;
            _shader.SetInt(s_emptyLevel, emptyLevel);
            _shader.SetInts(s_grid, across, first, count, 0);
            _shader.DispatchThreads(_corners, (across + 1) * (rows + 1));
            Rounds.Trace(count, 0, rounds, bisections);
        }

        public void Dispose() => Rounds.Dispose();

        int[] TracingKernels()
        {
            var kernels = new int[Rounds.Kernels.Length + 1];
            Rounds.Kernels.CopyTo(kernels, 0);
            kernels[kernels.Length - 1] = _corners;
            return kernels;
        }
    }
}
