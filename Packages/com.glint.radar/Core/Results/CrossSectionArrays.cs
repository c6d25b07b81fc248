using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>Writes rcs.npz: the rows of cross sections as arrays.</summary>
    static class CrossSectionArrays
    {
        /// <summary>Writes the arrays of <see cref="AddTo"/>.</summary>
        public static void Write(Stream output, WholeRun run)
        {
            using (var arrays = new NumpyArchive(output))
                AddTo(arrays, run.Info, run.Rows);
        }

        /// <summary>
        /// Adds azimuth and elevation of each pose, frequency, receiver (azimuth and elevation; those of the pose, as
        /// NaN, where the radar receives), S by pose, frequency, receiver, received and sent polarisation (V, H; NaN
        /// where it was not asked for), and error. With pulses S and error have an index more, of the pulse, after that
        /// of the pose, and there is the time of each. With a track there is the distance of each pose.
        /// </summary>
        public static void AddTo(IArrayFile arrays, RunInfo info, IReadOnlyList<StoredRow> rows)
        {
            var plan = CrossSectionPlan.Of(info.Sweep);
            int frequencies = plan.Frequencies.Count, receivers = plan.Receivers,
                rowsOfPose = plan.PulseCount * frequencies * receivers;
            var poses = Enumerable.Range(0, plan.Poses).Select(pose => plan[pose * rowsOfPose]).ToArray();
            var received = Enumerable.Range(0, receivers).Select(receiver => plan[receiver]);
            arrays.Add("azimuth", new[] { poses.Length }, poses.Select(pose => pose.AzimuthDegrees));
            arrays.Add("elevation", new[] { poses.Length }, poses.Select(pose => pose.ElevationDegrees));
            if (plan.Track != null)
                arrays.Add("distance", new[] { poses.Length }, poses.Select(pose => pose.Range.Value));
            arrays.Add("frequency", new[] { frequencies }, plan.Frequencies);
            arrays.Add("receiver", new[] { receivers, 2 }, received.SelectMany(planned => new[]
                { planned.ReceiverAzimuthDegrees ?? double.NaN, planned.ReceiverElevationDegrees ?? double.NaN }));
            int[] sizes = plan.Pulses == null
                ? new[] { poses.Length, frequencies, receivers }
                : new[] { poses.Length, plan.PulseCount, frequencies, receivers };
            if (plan.Pulses != null)
                arrays.Add("time", new[] { plan.PulseCount },
                    Enumerable.Range(0, plan.PulseCount).Select(plan.Pulses.TimeOf));
            arrays.Add("S", sizes.Append(2).Append(2).ToArray(), rows.SelectMany(Matrix));
            arrays.Add("error", sizes, rows.Select(row => row[CrossSectionColumn.Error].Value));
        }

        static IEnumerable<Complex> Matrix(StoredRow row) =>
            Polarisation.Matrix.Select(polarisation => CrossSectionColumn.Amplitude(row, polarisation)
                    ?? new Complex(double.NaN, double.NaN));
    }
}
