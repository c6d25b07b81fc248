using System;
using System.Linq;
using Unity.Mathematics;
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
        readonly int _cells, _clearRevealed, _takeRevealed;
        readonly DeviceBuffer<TubePose> _poses = new DeviceBuffer<TubePose>("poses");
        readonly DeviceBuffer<AmplitudePose> _amplitudePoses = new DeviceBuffer<AmplitudePose>("poses");
        readonly DeviceBuffer<uint> _beginning = new DeviceBuffer<uint>("poses that begin");
        TubePose[] _slices;
        AmplitudePose[] _pictures;
        int _revealedWords;

        /// <param name="shader">Shaders/Amplitude.compute.</param>
        public AmplitudeKernels(ComputeShader shader)
        {
            _shader = shader;
            _cells = shader.FindKernel("AmplitudeCells");
            _clearRevealed = shader.FindKernel("ClearRevealed");
            _takeRevealed = shader.FindKernel("TakeRevealed");
            Rounds = new TubeRounds(shader, "AmplitudePoints", "AmplitudeCells", "AmplitudeBorders", null, "AmplitudeRays");
        }

        /// <summary>The kernels that divide cells.</summary>
        public TubeRounds Rounds { get; }

        /// <summary>Words of the parts of a pose's cells.</summary>
        public static int RevealedWordsOf(AmplitudeJob job) => PartWords * job.Grid.Count.x * job.Grid.Count.y;

        /// <summary>Rays of a border cell: BORDER_RAYS in Shaders/TubeBindings.hlsl.</summary>
        public const int BorderRays = 4;

        /// <summary>Words of a point.</summary>
        public static int PointWords(int maxBounces) => PointLandings + 2 * maxBounces;

        /// <summary>Sets the scenes of the poses.</summary>
        public void SetScenes(DeviceScene scenes, SurfaceBuffers surfaces)
        {
            foreach (int kernel in Rounds.Kernels)
            {
                _shader.SetBvhs(kernel, scenes);
                _shader.SetBuffer(kernel, TubeIDs._Facets, surfaces.Facets.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._InstanceFacets, surfaces.InstanceFacets.Buffer);
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

        /// <summary>
        /// Sets the parts of cells in which earlier attempts of each pose have found more, and those with this one: none yet.
        /// </summary>
        public void SetRevealed(DeviceBuffer<uint> revealed, DeviceBuffer<uint> byNow, int wordsOfPose)
        {
            _revealedWords = wordsOfPose;
            long words = (long)wordsOfPose * _slices.Length;
            _shader.SetInt(TubeIDs._RevealedWords, _revealedWords);
            _shader.SetBuffer(_takeRevealed, TubeIDs._WrittenRevealed, revealed.Buffer);
            _shader.SetBuffer(_takeRevealed, TubeIDs._RevealedByNow, byNow.Buffer);
            _shader.SetBuffer(_cells, TubeIDs._Revealed, revealed.Buffer);
            _shader.SetBuffer(Rounds.Corners, TubeIDs._RevealedByNow, byNow.Buffer);
            foreach (var bits in new[] { revealed, byNow })
            {
                _shader.SetBuffer(_clearRevealed, TubeIDs._RevealedByNow, bits.Buffer);
                _shader.DispatchThreads(_clearRevealed, words);
            }
        }

        /// <summary>Traces rows of base cells of each pose.</summary>
        /// <param name="rows">Of each pose.</param>
        public void Trace(AmplitudeJob[] jobs, int[] rows)
        {
            TakeRevealed(jobs, rows);
            var (cells, corners) = SetSlices(jobs, rows);
            var traced = jobs.Where((job, i) => rows[i] > 0).ToArray();
            Rounds.Trace(cells, corners, traced.Max(job => Math.Max(job.MaxLevel, job.EmptyLevel)) + 1,
                traced.Max(job => job.MaxBisections));
        }

        // A slice that is traced again must not meet what it has revealed itself.
        void TakeRevealed(AmplitudeJob[] jobs, int[] rows)
        {
            var beginning = Enumerable.Range(0, jobs.Length).Where(i => rows[i] > 0 && jobs[i].TakesRevealed())
                .Select(i => (uint)i).ToArray();
            if (beginning.Length == 0)
                return;
            _beginning.Upload(beginning);
            _shader.SetBuffer(_takeRevealed, TubeIDs._Beginning, _beginning.Buffer);
            _shader.SetInt(TubeIDs._BeginningCount, beginning.Length);
            _shader.DispatchThreads(_takeRevealed, (long)_revealedWords * beginning.Length);
        }

        (int Cells, int Corners) SetSlices(AmplitudeJob[] jobs, int[] rows)
        {
            int cells = 0, corners = 0;
            for (int i = 0; i < jobs.Length; i++)
            {
                int across = Math.Max(1, jobs[i].Grid.Count.x), count = rows[i] * across;
                _slices[i].Slice = new uint4((uint)(jobs[i].NextRow * across), (uint)count, (uint)across, (uint)cells);
                _slices[i].FirstCorner = (uint)corners;
                jobs[i].SetAccuracy(ref _slices[i], ref _pictures[i]);
                cells += count;
                corners += TubeKernels.CornersOf(count, across);
            }
            _poses.Upload(_slices);
            _amplitudePoses.Upload(_pictures);
            _shader.SetInts(TubeIDs._BaseCounts, cells, corners);
            return (cells, corners);
        }

        public void Dispose()
        {
            Rounds.Dispose();
            _poses.Dispose();
            _amplitudePoses.Dispose();
            _beginning.Dispose();
        }
    }
}
