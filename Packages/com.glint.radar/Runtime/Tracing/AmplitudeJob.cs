using System;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>A pose whose amplitude is traced, beside others, in attempts with finer borders and more cells.</summary>
    sealed class AmplitudeJob
    {
        // A border is found to 2^-level of a base cell: at first, and at most, where float32 has no more places.
        const int FirstBisectLevel = 10, MaxBisectLevel = 14;

        // Maximum relative error of a cell that is not divided, times 2^level.
        const double CellErrorOfLevel0 = 0.2;

        // Cells of which nothing is received are divided up to this level where something may be hidden in them, in the
        // first attempt; in each later one that needs it to the next level.
        const int FirstEmptyLevel = 4;

        // Attempts to find everything, after which the tolerance is not met.
        const int MaxAttempts = 8;

        readonly AmplitudeSums _sums = new AmplitudeSums();
        readonly double _scale;            // rays of the picture a base cell
        int _attempt = 1, _bisectLevel = FirstBisectLevel;
        bool _takesRevealed = true;

        /// <param name="boxMin">Lower corner of the box around the scene, metres.</param>
        /// <param name="boxMax">Upper corner.</param>
        public AmplitudeJob(in RadarPose pose, double3 boxMin, double3 boxMax)
        {
            Pose = pose;
            Rays = new RayGrid(pose.Settings, pose.View, boxMin, boxMax);
            Grid = new AmplitudeGrid(pose.Settings, pose.View, boxMin, boxMax);
            _scale = Grid.Step.x * Grid.Step.y;
            IsDone = IsMet = math.any(Grid.Count == 0);
        }

        public RadarPose Pose { get; }

        public RayGrid Rays { get; }

        public AmplitudeGrid Grid { get; }

        /// <summary>Whether no attempt follows.</summary>
        public bool IsDone { get; private set; }

        /// <summary>Whether the tolerance is met.</summary>
        public bool IsMet { get; private set; }

        /// <summary>First row of base cells of the next slice.</summary>
        public int NextRow { get; private set; }

        /// <summary>Rows of the attempt that are not traced yet.</summary>
        public int RowsLeft => IsDone ? 0 : Grid.Count.y - NextRow;

        /// <summary>Done of the attempt, 0 to 1.</summary>
        public double Fraction => IsDone ? 1 : (double)NextRow / Grid.Count.y;

        // Error that a cell may have, of its phasor times area.
        double CellError => CellErrorOfLevel0 * Math.Pow(2, -_bisectLevel);

        /// <summary>Divisions of a base cell at most, by its error, and of one of which nothing is received.</summary>
        public int MaxLevel => (int)Math.Ceiling(-0.5 * Math.Log(CellError, 2));

        /// <inheritdoc cref="MaxLevel"/>
        public int EmptyLevel { get; private set; } = FirstEmptyLevel;

        /// <summary>Of the sides of a base cell towards a border.</summary>
        public int MaxBisections => _bisectLevel + 1;

        /// <summary>Tells the kernels how finely cells are divided and borders found.</summary>
        public void SetAccuracy(ref TubePose tubes, ref AmplitudePose pose)
        {
            tubes.CellError = (float)CellError;
            (tubes.MaxLevel, tubes.MaxBisections) = ((uint)MaxLevel, (uint)MaxBisections);
            pose.EmptyLevel = (uint)EmptyLevel;
        }

        /// <summary>
        /// Takes what the attempts before have revealed: true once an attempt, although a slice may be traced again.
        /// </summary>
        public bool TakesRevealed()
        {
            bool takes = _takesRevealed;
            _takesRevealed = false;
            return takes;
        }

        /// <inheritdoc cref="AmplitudeSums.AddRevealed"/>
        public void AddRevealed(uint[] output, int number, int poses) => _sums.AddRevealed(output, number, poses);

        /// <summary>Adds a slice, and plans the next attempt if it ends one that does not meet the tolerance.</summary>
        /// <inheritdoc cref="AmplitudeSums.Add"/>
        public void Took(int rows, uint[] output, int number, int poses, string owner)
        {
            _sums.Add(output, number, poses, owner);
            NextRow += rows;
            if (RowsLeft == 0)
                EndAttempt();
        }

        void EndAttempt()
        {
            double normalised = _scale * RadarResult.NormalRays / Pose.Settings.RayCount;
            double allowed = Math.Pow(10, Pose.Settings.ToleranceDb / 20) - 1;
            double toExcess = CrossSectionAccuracy.Confidence * normalised
                / (allowed * Math.Max(AmplitudeTracer.Floor, normalised * _sums.Sum.Magnitude));
            IsMet = toExcess * _sums.Error <= 1;
            IsDone = IsMet || _attempt == MaxAttempts;
            if (IsDone)
                return;
            double excess = toExcess * _sums.KnownError;
            if (excess > 1)
            {
                _bisectLevel = Math.Min(MaxBisectLevel,
                    _bisectLevel + Math.Max(1, (int)Math.Ceiling(Math.Log(excess, 2))));
                EmptyLevel++;
            }
            _sums.Clear();
            (_attempt, NextRow, _takesRevealed) = (_attempt + 1, 0, true);
        }

        /// <summary>The amplitude and its error.</summary>
        public RadarResult ToResult(TraceStatistics statistics)
        {
            double turns = (Rays.OriginDepth + AmplitudePose.ReceiverDepth(Pose.View, Rays)) / Pose.Settings.Wavelength;
            double error = _scale * _sums.Error * RadarResult.NormalRays / Pose.Settings.RayCount;
            return new RadarResult(_sums.ToSums(Pose, Rays.OriginDepth, _scale, turns),
                new SamplingReport(error, null, !IsMet), null, statistics);
        }
    }
}
