using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Threading;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A sweep pose by pose: turns the target about the world's vertical through its own position, traces, and writes the row.
    /// Disposing puts the target's rotation back. Unity's play mode takes one step a frame, the commands take them in a row.
    /// </summary>
    public sealed class SweepRun : IDisposable
    {
        readonly RadarController _radar;
        readonly Transform _target;
        readonly bool _turns;
        readonly Quaternion _initialRotation, _initialLocalRotation;
        readonly IReadOnlyList<double> _angles;
        readonly string _scene;
        readonly ResultsFolder _folder;
        readonly DateTime _startedUtc = DateTime.UtcNow;
        readonly Stopwatch _watch = Stopwatch.StartNew();

        /// <param name="radar">Traces the poses.</param>
        /// <param name="target">What is turned; null to trace the scene as it stands.</param>
        /// <param name="angles">Degrees, positive as Unity's rotation about Y, from the target's rotation now.</param>
        /// <param name="scene">Path of the scene or mesh file, for results.json.</param>
        /// <param name="folder">Takes the rows; null to write nothing.</param>
        public SweepRun(RadarController radar, Transform target, IReadOnlyList<double> angles, string scene, ResultsFolder folder)
        {
            _radar = radar;
            _target = target;
            _turns = target != null;
            _angles = angles;
            _scene = scene;
            _folder = folder;
            if (!_turns)
                return;
            (_initialRotation, _initialLocalRotation) = (target.rotation, target.localRotation);
            radar.ExpectMotion(target);
        }

        /// <summary>Poses in all.</summary>
        public int Count => _angles.Count;

        /// <summary>Poses traced so far.</summary>
        public int Done { get; private set; }

        /// <summary>True when every pose is traced.</summary>
        public bool IsComplete => Done == Count;

        /// <summary>Traces the next pose and writes its row; after the last one results.json.</summary>
        /// <param name="progress">Told how much of the pose is done, 0 to 1; may be null.</param>
        /// <param name="cancel">Ends the pose.</param>
        /// <exception cref="GlintException">The pose cannot be traced or its row not be written; the rows before are kept.</exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled; the rows before are kept, and the next step traces it again.</exception>
        public SweepRow Step(IProgress<double> progress = null, CancellationToken cancel = default)
        {
            double angle = _angles[Done];
            if (_turns && _target == null)
                throw new GlintException($"the target of the sweep was destroyed before {angle.ToString(CultureInfo.InvariantCulture)} deg: it must stay until the last angle");
            if (_turns)
                _target.rotation = Quaternion.AngleAxis((float)angle, Vector3.up) * _initialRotation;
            var row = new SweepRow(angle, _radar.Trace(KeptRays.None, progress, cancel));
            _folder?.Append(row);
            Done++;
            if (IsComplete)
                WriteJson();
            return row;
        }

        /// <summary>Closes results.csv and puts the target's rotation back.</summary>
        public void Dispose()
        {
            _folder?.Dispose();
            if (_target != null)
                _target.localRotation = _initialLocalRotation;
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
