using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Computes the receiver amplitude of a pose to a tolerance: the integral over the picture of the phasors of the
    /// rays that reach the receiver, by ray tubes that are clipped at the edges of facets and receiver.
    /// </summary>
    public sealed class AmplitudeTracer : IDisposable
    {
        /// <summary>
        /// Normalised amplitude below which the tolerance is relative to this one, so that nulls take no endless work:
        /// that of a tenth of a ray of the published experiment.
        /// </summary>
        public const double Floor = 0.1;

        // Elements of the lists, and points, for each pose, and at least: slices whose lists become full are traced again in
        // parts. They take 50 MB a pose, with the parts of cells.
        const int ElementsAPose = 1 << 16, MinElements = 1 << 18, PointsAPose = 1 << 17, MinPoints = 1 << 20;

        // Poses that are traced together: one for each of these mebibytes of the GPU's memory, up to a number at which
        // dispatches are long enough.
        const int MebibytesAPose = 512, MaxPoses = 64;

        readonly string _owner;
        readonly AmplitudeKernels _kernels;
        readonly DeviceScene _scene;
        readonly PatchBuffers _patches = new PatchBuffers();
        readonly TubeLists _lists = new TubeLists();
        readonly DeviceBuffer<uint> _points = new DeviceBuffer<uint>("words of points");
        readonly DeviceBuffer<BorderRay> _borderRays = new DeviceBuffer<BorderRay>("rays of border cells");
        readonly DispatchPacer _pacer = new DispatchPacer();

        /// <param name="shader">Shaders/Amplitude.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">The shader is missing or another one.</exception>
        public AmplitudeTracer(ComputeShader shader, string owner = nameof(AmplitudeTracer))
        {
            Check(shader, owner);
            _owner = owner;
            _kernels = new AmplitudeKernels(shader);
            _scene = new DeviceScene(BvhLayout.Binary, owner, long.MaxValue);
        }

        /// <summary>Refuses a device that cannot trace, and a shader that is missing or another one.</summary>
        /// <exception cref="GlintException">The message says why, and the way out.</exception>
        public static void Check(ComputeShader shader, string owner)
        {
            DeviceCheck.RequireDevice();
            if (shader == null || !shader.HasKernel("AmplitudePoints"))
                throw new GlintException($"{owner}: a tolerance needs the kernels of ray tubes: assign "
                    + "Packages/com.glint.radar/Shaders/Amplitude.compute to Tube Kernel");
            DeviceCheck.RequireSupported(shader, shader.FindKernel("AmplitudePoints"));
        }

        /// <summary>
        /// Poses that are traced together at most: several on a GPU, which a single one does not fill.
        /// </summary>
        public int PosesTogether { get; internal set; } = SoftwareDevice.IsInUse ? 1
            : math.clamp(SystemInfo.graphicsMemorySize / MebibytesAPose, 1, MaxPoses);

        /// <summary>Rows of base cells of a dispatch, for tests; 0: by the times of earlier dispatches.</summary>
        internal int RowsADispatch { get; set; }

        /// <summary>Tubes, cells of a round and border cells of a dispatch, for tests; 0: by the poses.</summary>
        internal int ListCapacity { get; set; }

        /// <summary>Traces one pose to the tolerance of its settings.</summary>
        /// <param name="statistics">Figures of the gathering, to which those of the trace are added.</param>
        /// <inheritdoc cref="Trace(IReadOnlyList{RadarPose}, IProgress{double}, CancellationToken, IReadOnlyList{TraceStatistics})"/>
        public RadarResult Trace(in RadarPose pose, IProgress<double> progress = null,
            CancellationToken cancel = default, TraceStatistics statistics = null) =>
            Trace(new[] { pose }, progress, cancel, statistics == null ? null : new[] { statistics })[0];

        /// <summary>
        /// Traces poses to the tolerance of their settings, those in a row that differ in places and views alone together.
        /// The results are those of single poses, bit for bit.
        /// </summary>
        /// <param name="progress">Receives the fraction done, 0 to 1, of each attempt.</param>
        /// <param name="cancel">Cancels while BVHs are built, or after the current slice.</param>
        /// <param name="statistics">Figures of the gathering of each pose, to which those of the trace are added.</param>
        /// <returns>
        /// Results whose rays are those traced. <see cref="RadarResult.SamplingError"/> is the standard error of the
        /// integration, and <see cref="RadarResult.Undersampled"/> is true if the tolerance was not met.
        /// </returns>
        /// <exception cref="GlintException">A setting is out of its range, or the memory does not suffice.</exception>
        /// <exception cref="OperationCanceledException">The poses were cancelled.</exception>
        public RadarResult[] Trace(IReadOnlyList<RadarPose> poses, IProgress<double> progress = null,
            CancellationToken cancel = default, IReadOnlyList<TraceStatistics> statistics = null)
        {
            foreach (var pose in poses)
            {
                pose.Settings.Validate(_owner);
                pose.View.Validate(_owner);
            }
            statistics ??= poses.Select(pose => new TraceStatistics()).ToArray();
            var results = new List<RadarResult>();
            while (results.Count < poses.Count)
            {
                int first = results.Count;
                var alike = poses.Skip(first).Take(PosesTogether).TakeWhile(pose => AreAlike(poses[first], pose)).ToArray();
                results.AddRange(TraceTogether(alike, statistics.Skip(first).Take(alike.Length).ToArray(), progress, cancel));
            }
            return results.ToArray();
        }

        // Whether poses differ in nothing but the places of instances, the view and the picture.
        static bool AreAlike(in RadarPose a, in RadarPose b)
        {
            var (instances, others) = (a.Scene.Instances, b.Scene.Instances);
            return a.Settings.MaxBounces == b.Settings.MaxBounces && a.Settings.FrequencyHz == b.Settings.FrequencyHz
                && instances.Length == others.Length && Enumerable.Range(0, instances.Length).All(i =>
                    instances[i].Mesh == others[i].Mesh && instances[i].Ranges.SequenceEqual(others[i].Ranges));
        }

        IEnumerable<RadarResult> TraceTogether(RadarPose[] poses, TraceStatistics[] statistics, IProgress<double> progress,
            CancellationToken cancel)
        {
            var watch = Stopwatch.StartNew();
            _scene.Set(Array.ConvertAll(poses, pose => pose.Scene), statistics[0],
                (mesh, layout) => MeshBvh.Build(mesh, layout, cancel));
            var jobs = poses.Zip(_scene.Placed, (pose, placed) => new AmplitudeJob(pose, placed.Min, placed.Max)).ToArray();
            if (jobs.Any(job => !job.IsDone))
            {
                Bind(jobs);
                TraceJobs(jobs, progress, cancel);
            }
            for (int i = 0; i < jobs.Length; i++)
            {
                statistics[i].Triangles = poses[i].Scene.TriangleCount;
                var timings = statistics[i].Timings;
                timings.TraceMs = watch.Elapsed.TotalMilliseconds / jobs.Length;
                statistics[i].Timings = timings;
            }
            return jobs.Zip(statistics, (job, figures) => job.ToResult(figures));
        }

        void Bind(AmplitudeJob[] jobs)
        {
            _scene.RequireOnePage(_owner, "ray tubes take", ", or leave the tolerance out");
            var pose = jobs[0].Pose;
            // Facets of one plane are one mirror.
            _patches.Set(pose.Scene, 0);
            var waveNumber = TubeLists.WaveNumber(pose.Settings.FrequencyHz);
            int capacity = ListCapacity > 0 ? ListCapacity : Math.Max(MinElements, jobs.Length * ElementsAPose),
                words = AmplitudeKernels.PointWords(pose.Settings.MaxBounces),
                points = (int)Math.Min(Math.Max(MinPoints, jobs.Length * PointsAPose),
                    DeviceBuffer<uint>.MaxCount / words);
            _kernels.SetScenes(_scene, _patches);
            _kernels.SetPoses(jobs, _scene, waveNumber.x);
            _lists.Reserve(AmplitudeSums.OutputSize(jobs.Length), capacity, capacity, new[] { waveNumber });
            _points.Reserve((long)points * words);
            _kernels.Rounds.SetLists(_lists);
            _borderRays.Reserve((long)AmplitudeKernels.BorderRays * capacity);
            _kernels.SetPoints(_points, points, _borderRays);
            _kernels.BindRevealed(jobs);
        }

        // Traces rows of all poses, slice by slice, until each pose meets its tolerance or has made its last attempt.
        void TraceJobs(AmplitudeJob[] jobs, IProgress<double> progress, CancellationToken cancel)
        {
            var read = new uint[AmplitudeSums.OutputSize(jobs.Length)];
            int max = int.MaxValue;
            while (jobs.Any(job => !job.IsDone))
            {
                cancel.ThrowIfCancellationRequested();
                int left = Math.Min(max, jobs.Sum(job => job.RowsLeft));
                int count = RowsADispatch > 0 ? Math.Min(left, RowsADispatch)
                    : _pacer.NextTiles(left, jobs[0].Pose.Settings.MaxBounces);
                var rows = RowsOf(jobs, count);
                var watch = Stopwatch.StartNew();
                _kernels.Rounds.Clear(read.Length);
                _kernels.Trace(jobs, rows);
                _lists.Output.ReadBack(read, read.Length);
                _pacer.Took(count, watch.Elapsed.TotalSeconds);
                // A list was full: the slice is traced again in parts.
                bool hasOverflown = TubeSums.HasOverflown(read);
                if (hasOverflown && count == 1)
                    throw new GlintException($"{_owner}: one row of cells has too many parts at this tolerance: "
                        + "ask for a larger one, or trace a part of the picture");
                for (int i = 0; i < jobs.Length; i++)
                    if (rows[i] > 0 && hasOverflown)
                        jobs[i].AddRevealed(read, i, jobs.Length);
                    else if (rows[i] > 0)
                        jobs[i].Took(rows[i], read, i, jobs.Length, _owner);
                max = hasOverflown ? count / 2 : max;
                progress?.Report(jobs.Average(job => job.Fraction));
            }
        }

        // The next rows of each pose.
        static int[] RowsOf(AmplitudeJob[] jobs, int count)
        {
            var rows = new int[jobs.Length];
            for (int i = 0; i < jobs.Length; i++)
            {
                rows[i] = Math.Min(count, jobs[i].RowsLeft);
                count -= rows[i];
            }
            return rows;
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _kernels.Dispose();
            _scene.Dispose();
            _patches.Dispose();
            _lists.Dispose();
            _points.Dispose();
            _borderRays.Dispose();
        }
    }
}
