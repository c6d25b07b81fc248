using System;
using System.Linq;
using UnityEngine;

namespace Glint
{
    /// <summary>The kernels of Shaders/Amplitude.compute and their inputs.</summary>
    sealed class AmplitudeKernels : IDisposable
    {
        /// <summary>Words of the parts of a base cell: REVEALED_PARTS in Shaders/AmplitudePath.hlsl.</summary>
        public const int PartWords = 32;

        const int PointLandings = 2;       // POINT_LANDINGS in Shaders/AmplitudePath.hlsl, of two words each

        static readonly int s_amplitudePoses = Shader.PropertyToID("_AmplitudePoses");
        static readonly int s_pointWords = Shader.PropertyToID("_PointWords");
        static readonly int s_pointCapacity = Shader.PropertyToID("_PointCapacity");
        static readonly int s_points = Shader.PropertyToID("_Points");
        static readonly int s_borderRays = Shader.PropertyToID("_BorderRays");

        readonly ComputeShader _shader;
        readonly int _cells;
        readonly DeviceBuffer<TubePose> _poses = new DeviceBuffer<TubePose>("poses");
        readonly DeviceBuffer<AmplitudePose> _amplitudePoses = new DeviceBuffer<AmplitudePose>("poses");
        readonly RevealedBits _revealed;
        TubePose[] _slices;
        AmplitudePose[] _pictures;

        /// <param name="shader">Shaders/Amplitude.compute.</param>
        public AmplitudeKernels(ComputeShader shader)
        {
            DeviceArithmetic.Check(shader);
            _shader = shader;
            _cells = shader.FindKernel("AmplitudeCells");
            _revealed = new RevealedBits(shader);
            Rounds = new TubeRounds(shader, "AmplitudePoints", "AmplitudeCells", "AmplitudeBorders", null, "AmplitudeRays");
        }

        /// <summary>The kernels that divide cells.</summary>
        public TubeRounds Rounds { get; }

        /// <summary>Rays of a border cell: BORDER_RAYS in Shaders/TubeBindings.hlsl.</summary>
        public const int BorderRays = 4;

        /// <summary>Words of a point.</summary>
        public static int PointWords(int maxBounces) => PointLandings + 2 * maxBounces;

        /// <summary>Sets the scenes of the poses.</summary>
        public void SetScenes(DeviceScene scenes, PatchBuffers patches)
        {
            foreach (int kernel in Rounds.Kernels)
            {
                _shader.SetBvhs(kernel, scenes);
                _shader.SetBuffer(kernel, TubeIDs._Facets, patches.Facets.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._InstanceFacets, patches.InstanceFacets.Buffer);
            }
        }

        /// <summary>Sets radars, receivers and pictures of poses that are alike.</summary>
        public void SetPoses(AmplitudeJob[] jobs, DeviceScene scenes, float waveNumber)
        {
            _slices = Array.ConvertAll(jobs, job => new TubePose(job.Rays, job.Grid.Count));
            _pictures = Array.ConvertAll(jobs, job => new AmplitudePose(job.Pose.View, job.Rays, job.Grid));
            uint instances = 0, rows = 0;
            for (int i = 0; i < jobs.Length; i++)
            {
                (_pictures[i].FirstInstance, _pictures[i].FirstRow) = (instances, rows);
                instances += (uint)scenes.Placed[i].Records.Length;
                rows += (uint)scenes.Placed[i].BvhRows.Length;
            }
            _poses.Upload(_slices);
            _amplitudePoses.Upload(_pictures);
            foreach (int kernel in Rounds.Kernels)
            {
                _shader.SetBuffer(kernel, TubeIDs._Poses, _poses.Buffer);
                _shader.SetBuffer(kernel, s_amplitudePoses, _amplitudePoses.Buffer);
            }
            int maxBounces = jobs[0].Pose.Settings.MaxBounces;
            _shader.SetInt(ShaderIDs._MaxBounces, maxBounces);
            _shader.SetInt(s_pointWords, PointWords(maxBounces));
            _shader.SetFloat(TubeIDs._WaveNumber, waveNumber);
            _shader.SetFloat(TubeIDs._UnitsPerMetre, (float)AmplitudeSums.UnitsPerCell);
            _shader.SetFloat(TubeIDs._UnitsPerSquareMetre, (float)AmplitudeSums.UnitsPerSquare);
            _shader.SetInt(TubeIDs._PoseCount, jobs.Length);
            // One receiver, one frequency.
            _shader.SetInt(TubeIDs._ReceiverCount, 1);
            _shader.SetInt(TubeIDs._SlotCount, 1);
            _shader.SetInt(TubeIDs._SumCopies, 1);
            _shader.SetInt(TubeIDs._FrequencyCount, 1);
            _shader.SetInt(TubeIDs._FrequenciesAGroup, 1);
            _shader.SetInt(TubeIDs._FrequencyGroups, 1);
        }

        /// <summary>Sets the list of points, and the rays of border cells.</summary>
        public void SetPoints(DeviceBuffer<uint> points, int capacity, DeviceBuffer<BorderRay> borderRays)
        {
            foreach (int kernel in Rounds.Kernels)
            {
                _shader.SetBuffer(kernel, s_points, points.Buffer);
                _shader.SetBuffer(kernel, s_borderRays, borderRays.Buffer);
            }
            _shader.SetInt(s_pointCapacity, capacity);
        }

        /// <summary>Makes room for the parts of cells in which attempts of each pose find something: nothing yet.</summary>
        public void BindRevealed(AmplitudeJob[] jobs)
        {
            int words = jobs.Max(job => PartWords * job.Grid.Count.x * job.Grid.Count.y);
            _revealed.Bind(jobs.Length, words, new[] { _cells }, Rounds.Corners);
            _revealed.Clear(jobs.Length);
        }

        /// <summary>Traces rows of base cells of each pose.</summary>
        /// <param name="rows">Of each pose.</param>
        public void Trace(AmplitudeJob[] jobs, int[] rows)
        {
            _revealed.Take(Enumerable.Range(0, jobs.Length).Where(i => rows[i] > 0 && jobs[i].TakesRevealed()));
            for (int i = 0; i < jobs.Length; i++)
                jobs[i].SetAccuracy(ref _slices[i], ref _pictures[i]);
            var (cells, corners) = TubePose.SetSlices(_slices, jobs.Select((job, i) =>
                ((long)job.NextRow * job.Grid.Count.x, rows[i] * job.Grid.Count.x)).ToArray());
            _poses.Upload(_slices);
            _amplitudePoses.Upload(_pictures);
            _shader.SetInts(TubeIDs._BaseCounts, cells, corners);
            var traced = jobs.Where((job, i) => rows[i] > 0).ToArray();
            Rounds.Trace(cells, corners, traced.Max(job => Math.Max(job.MaxLevel, job.EmptyLevel)) + 1,
                traced.Max(job => job.MaxBisections));
        }

        public void Dispose()
        {
            Rounds.Dispose();
            _poses.Dispose();
            _amplitudePoses.Dispose();
            _revealed.Dispose();
        }
    }
}
