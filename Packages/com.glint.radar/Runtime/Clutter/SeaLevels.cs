using System;
using System.Collections.Generic;
using System.Threading;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>The factors that bring the seas of poses to the published levels that they ask for.</summary>
    sealed class SeaLevels : IDisposable
    {
        readonly ComputeShader _shader;
        readonly string _owner;
        readonly Dictionary<ClutterLevel, ClutterLevels> _levels = new Dictionary<ClutterLevel, ClutterLevels>();
        ClutterTracer _tracer;

        public SeaLevels(ComputeShader shader, string owner) => (_shader, _owner) = (shader, owner);

        /// <summary>The factors of a sea of a pose; null for none. Traced once a direction.</summary>
        /// <exception cref="GlintException">
        /// The model does not hold for the sea, or not at the grazing angle of a plane wave.
        /// </exception>
        public ClutterLevelTable Of(CrossSectionPose pose, RadarSea sea, double frequency, CancellationToken cancel)
        {
            var level = sea.Clutter.Settings.Level;
            if (level == ClutterLevel.Physics)
                return null;
            _tracer ??= new ClutterTracer(_shader, _owner);
            if (!_levels.TryGetValue(level, out var levels))
                _levels.Add(level, levels = new ClutterLevels(_tracer, ClutterModel.Of(level)));
            if (pose.IsFar)
                sea.Clutter.RequireLevel(pose.Radar, frequency);
            return levels.TableOf(new EndlessSea(pose.Scene, sea), frequency, pose.Radar.AzimuthDegrees, null, cancel);
        }

        public void Dispose() => _tracer?.Dispose();
    }
}
