using System;
using Glint.Core;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>Collects what is wrong with the poses of a run or sweep, for its end.</summary>
    sealed class PoseWarnings
    {
        long _hit, _received;
        int _poses, _undersampled, _missedEchoes;

        /// <summary>Takes the next pose.</summary>
        public void Add(RadarResult result)
        {
            Add(result.RaysHit, result.RaysReceived, result.Undersampled);
            _missedEchoes += result.Echo?.IsMet == false ? 1 : 0;
        }

        /// <summary>Takes a pose of a run that is resumed or merged.</summary>
        public void Add(StoredRow row) => Add((long)row[ResultColumn.RaysHit], (long)row[ResultColumn.RaysReceived],
            row.IsUndersampled);

        void Add(long hit, long received, bool isUndersampled)
        {
            _poses++;
            _hit += hit;
            _received += received;
            _undersampled += isUndersampled ? 1 : 0;
        }

        /// <summary>Logs the warnings.</summary>
        /// <param name="name">Of the scene.</param>
        /// <param name="hasTolerance">Whether an error was asked for.</param>
        public void Log(string name, bool hasTolerance)
        {
            WarnOfSilence(name);
            if (hasTolerance)
                WarnOfTolerance(name);
            else if (_received > 0)
                WarnOfUndersampling(name);
            if (_missedEchoes > 0)
                Debug.LogWarning(FormattableString.Invariant(
                    $"{name}: the cross sections with clutter are less exact than {CrossSectionPose.PictureToleranceDb:g3} dB")
                    + (_poses == 1 ? "" : $" in {_missedEchoes} of the poses traced")
                    + ": the target has places that ray tubes do not resolve");
        }

        // No hit in any pose is a valid result, but more often a wrong aim.
        void WarnOfSilence(string name)
        {
            if (_hit == 0)
                Debug.LogWarning($"{name}: no ray hit anything: is the target in view, "
                    + "of the right size and on a traced layer? (mesh files: --aim, --distance, --fov, --unit)");
            else if (_received == 0)
                Debug.LogWarning($"{name}: rays hit and none was received: "
                    + "mirrors return only rays at normal incidence or in a corner; try other angles (mesh files: "
                    + "--grazing, --azimuth), more rays (--size) or a narrower view");
        }

        void WarnOfUndersampling(string name)
        {
            if (_undersampled == 0)
                return;
            string where = _poses == 1 ? "" : $" in {_undersampled} of {_poses} poses (column undersampled)";
            Debug.LogWarning($"{name}: the rays are too far apart, or too few return, for the amplitude to "
                + $"be trusted{where}: trace more rays ({Options.Size.Flag}, or a smaller {Options.Spacing.Flag}) or a "
                + $"narrower view ({Options.Fov.Flag}; in a scene the Camera's Field of View)");
        }

        void WarnOfTolerance(string name)
        {
            if (_undersampled > 0)
                Debug.LogWarning($"{name}: the tolerance is not met"
                    + (_poses == 1 ? "" : $" in {_undersampled} of {_poses} poses (column undersampled)")
                    + $": the error that was reached is in column sampling_error; ask for a larger {Options.Tolerance.Flag}");
        }
    }
}
