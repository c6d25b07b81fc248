using System;
using System.Linq;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>A sweep with rows known in advance, to be interrupted anywhere.</summary>
    static class SampleSweep
    {
        public static readonly DateTime Started = new DateTime(2025, 3, 4, 15, 6, 7, DateTimeKind.Utc);

        public static SweepIdentity Identity(string frequency = "10000000000 Hz", SweepShard? shard = null,
            int poses = 4)
        {
            var identity = new SweepIdentity { Shard = shard };
            identity.Add("angle_deg", string.Join(",", Enumerable.Range(0, poses)));
            identity.Add("target", null);
            identity.Add("frequency", frequency);
            return identity;
        }

        public static SweepRow Row(int pose)
        {
            // Bins of more rays than 32 bits hold.
            var histogram = pose % 3 == 0
                ? Enumerable.Range(pose, Signal.PhaseBins).Select(bin => (long)bin << 28).ToArray() : null;
            return pose % 3 == 2 ? SampleRun.Miss(pose) : SampleRun.Row(pose, 3 + pose / 7.0, -4, histogram);
        }

        /// <summary>Writes the first rows, and also finishes the sweep if these are all poses of the part.</summary>
        public static void Write(string path, SweepIdentity identity, int poses, int rows,
            bool finish = true, int first = 0)
        {
            using (var folder = ResultsFolder.Open(path))
            {
                folder.Begin(identity, Started);
                for (int i = 0; i < rows; i++)
                    folder.Append(Row(first + i));
                if (rows == poses && finish)
                    Finish(folder, identity);
            }
        }

        /// <summary>Resumes and completes the sweep.</summary>
        /// <returns>The rows found.</returns>
        public static int GoOn(string path, SweepIdentity identity, int poses)
        {
            using (var folder = ResultsFolder.Open(path))
            {
                folder.Begin(identity, Started);
                int done = folder.Resume(poses);
                for (int i = done; i < poses; i++)
                    folder.Append(Row(i));
                if (done < poses)
                    Finish(folder, identity);
                return done;
            }
        }

        public static void Finish(ResultsFolder folder, SweepIdentity identity)
        {
            var info = SampleRun.Info();
            info.Sweep = identity;
            folder.Finish(info);
        }
    }
}
