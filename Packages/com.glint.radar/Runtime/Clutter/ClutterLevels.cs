using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The factors that scale seas to a published model. Computed once a sea, frequency and direction, from the mean
    /// echo of the sea at the time at which it is asked for first.
    /// </summary>
    public sealed class ClutterLevels
    {
        // Of the degrees of an azimuth: a hundredth changes the mean echo by less than a thousandth of a decibel.
        const int AzimuthDecimals = 2;

        readonly ClutterTracer _tracer;
        readonly ClutterModel _model;
        // By the sea, its settings and wind, frequency and azimuth.
        readonly Dictionary<(SeaSurface, SeaClutterSettings, double3, double, double), ClutterLevelTable> _tables =
            new Dictionary<(SeaSurface, SeaClutterSettings, double3, double, double), ClutterLevelTable>();

        /// <param name="tracer">Traces the mean echo.</param>
        /// <param name="model">The published model.</param>
        public ClutterLevels(ClutterTracer tracer, ClutterModel model) => (_tracer, _model) = (tracer, model);

        /// <summary>The factors of a sea.</summary>
        /// <param name="frequency">Hertz.</param>
        /// <param name="azimuthDegrees">As of <see cref="RadarAspect.At"/>.</param>
        /// <param name="progress">Receives the fraction done, 0 to 1; may be null.</param>
        /// <exception cref="GlintException">The model does not hold for the sea, or the sea cannot be traced.</exception>
        /// <exception cref="OperationCanceledException">It was cancelled.</exception>
        public ClutterLevelTable TableOf(EndlessSea sea, double frequency, double azimuthDegrees,
            IProgress<double> progress = null, CancellationToken cancel = default)
        {
            var clutter = sea.Clutter;
            // A radar that a transform moves has an azimuth that differs in its last digits from pose to pose.
            azimuthDegrees = Math.Round(azimuthDegrees, AzimuthDecimals);
            var key = (clutter.LongWaves, clutter.Settings, clutter.Wind, frequency, azimuthDegrees);
            if (_tables.TryGetValue(key, out var table))
                return table;
            ClutterConditions At(double grazing) => clutter.ConditionsAt(frequency, azimuthDegrees, grazing);
            var angles = ClutterLevelTable.AnglesOf(_model, At);
            var own = angles.Select((grazing, i) =>
            {
                progress?.Report((double)i / angles.Count);
                return _tracer.Trace(sea.PoseOf(azimuthDegrees, grazing, frequency), frequency, null, null, cancel)
                    .Single().Sigma0;
            }).ToArray();
            _tables.Add(key, table = new ClutterLevelTable(_model, angles, own, At));
            return table;
        }
    }
}
