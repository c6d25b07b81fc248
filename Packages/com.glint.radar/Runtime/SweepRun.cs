using System;
using System.Diagnostics;
using System.Threading;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A sweep pose by pose: turns the target about the world's vertical through its own position, shows the sea's snapshot, traces, and writes the row.
    /// Disposing puts rotation and snapshot back. Unity's play mode takes one step a frame, the commands take them in a row.
    /// </summary>
    public sealed class SweepRun : IDisposable
    {
        readonly RadarController _radar;
        readonly Transform _target;
        readonly Sea _sea;
        readonly Quaternion _initialRotation, _initialLocalRotation;
        readonly int _initialSnapshot;
        readonly SweepPlan _plan;
        readonly string _scene;
        readonly ResultsFolder _folder;
        readonly DateTime _startedUtc = DateTime.UtcNow;
        readonly Stopwatch _watch = Stopwatch.StartNew();

        /// <param name="radar">Traces the poses.</param>
        /// <param name="plan">The poses.</param>
        /// <param name="target">What is turned, from its rotation now; may be null when the plan turns nothing.</param>
        /// <param name="sea">Whose snapshots are shown; may be null when the plan has none.</param>
        /// <param name="scene">Path of the scene or mesh file, for results.json.</param>
        /// <param name="folder">Takes the rows; null to write nothing.</param>
        /// <exception cref="GlintException">The sea has no such snapshot.</exception>
        public SweepRun(RadarController radar, SweepPlan plan, Transform target, Sea sea, string scene, ResultsFolder folder)
        {
            _radar = radar;
            _plan = plan;
            _target = plan.Turns ? target : null;
            _sea = plan.HasSnapshots ? sea : null;
            _scene = scene;
            _folder = folder;
            if (plan.HasSnapshots)
            {
                _initialSnapshot = sea.Snapshot;
                for (int i = 0; i < plan.Count; i++)
                    sea.CheckSnapshot(plan[i].Snapshot.Value);
            }
            if (!plan.Turns)
                return;
            (_initialRotation, _initialLocalRotation) = (target.rotation, target.localRotation);
            radar.ExpectMotion(target);
        }

        /// <summary>Poses in all.</summary>
        public int Count => _plan.Count;

        /// <summary>Poses traced so far.</summary>
        public int Done { get; private set; }

        /// <summary>True when every pose is traced.</summary>
        public bool IsComplete => Done == Count;

        /// <summary>Traces the next pose and writes its row; after the last one results.json.</summary>
        /// <param name="progress">Told how much of the pose is done, 0 to 1; may be null.</param>
        /// <param name="cancel">Ends the pose.</param>
        /// <param name="keep">Which rays the row's result carries.</param>
        /// <exception cref="GlintException">The pose cannot be traced or its row not be written; the rows before are kept.</exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled; the rows before are kept, and the next step traces it again.</exception>
        public SweepRow Step(IProgress<double> progress = null, CancellationToken cancel = default, KeptRays keep = KeptRays.None)
        {
            var pose = _plan[Done];
            Show(pose);
            var row = new SweepRow(pose, _radar.Trace(keep, progress, cancel));
            _folder?.Append(row);
            Done++;
            if (IsComplete)
                WriteJson();
            return row;
        }

        /// <summary>Closes results.csv and puts the target's rotation and the sea's snapshot back.</summary>
        public void Dispose()
        {
            _folder?.Dispose();
            if (_target != null)
                _target.localRotation = _initialLocalRotation;
            if (_sea != null)
                _sea.Snapshot = _initialSnapshot;
        }

        void Show(SweepPose pose)
        {
            if (_plan.Turns && _target == null)
                throw new GlintException($"the target of the sweep was destroyed before {pose}: it must stay until the last pose");
            if (_plan.HasSnapshots && _sea == null)
                throw new GlintException($"the Sea of the sweep was destroyed before {pose}: it must stay until the last pose");
            if (_plan.Turns)
                _target.rotation = Quaternion.AngleAxis((float)pose.AngleDegrees.Value, Vector3.up) * _initialRotation;
            if (_plan.HasSnapshots)
                _sea.Snapshot = pose.Snapshot.Value;
        }

        void WriteJson()
        {
            if (_folder == null)
                return;
            var info = RunDescription.Of(_radar, _scene, _target);
            info.StartedUtc = _startedUtc;
            info.ElapsedMs = _watch.Elapsed.TotalMilliseconds;
            _folder.Finish(info);
        }
    }
}
