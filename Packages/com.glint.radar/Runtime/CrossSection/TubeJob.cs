using System;
using System.Collections.Generic;
using Glint.Core;

namespace Glint
{
    /// <summary>A pose that is traced, beside others, in attempts with ever smaller errors of cells.</summary>
    sealed class TubeJob
    {
        readonly SliceForecast _slices = new SliceForecast();
        readonly List<(double CellError, double CrossCellError)> _attempts = new List<(double, double)>();
        long _raysBefore;
        bool _hasRevealed;                 // taken in the attempt

        public TubeJob(CrossSectionPose pose, TubeGrid grid)
        {
            (Pose, Grid) = (pose, grid);
            Edges = new TubeSums(pose, grid);
        }

        public CrossSectionPose Pose { get; }

        public TubeGrid Grid { get; }

        /// <summary>The edges: the same for every attempt.</summary>
        public TubeSums Edges { get; }

        /// <summary>Of the attempt.</summary>
        public TubeSums Sums { get; private set; }

        /// <summary>
        /// Error that a cell may have, as a fraction of what a conducting plate of a base cell returns: in VV and HH.
        /// </summary>
        public double CellError { get; private set; }

        /// <summary>The same in HV and VH, at most that of VV and HH.</summary>
        public double CrossCellError { get; private set; }

        // A division makes a cell's share a quarter; a bisection halves the error of its border. Where curved surfaces
        // focus, a base cell returns up to 64 times what a plate does.
        public int MaxLevel => (int)Math.Ceiling(0.5 * Math.Log(1.2 / CrossCellError, 2)) + 3;

        public int MaxBisections => (int)Math.Ceiling(Math.Log(1 / CrossCellError, 2)) + 8;

        /// <summary>First cell of the next slice.</summary>
        public long Next { get; private set; }

        /// <summary>Cells of the attempt that are not traced yet.</summary>
        public long Left => Grid.Count - Next;

        /// <summary>Done of the attempt, 0 to 1.</summary>
        public double Fraction => 1 - (double)Left / Grid.Count;

        /// <summary>Of the last attempt.</summary>
        public CrossSectionResult Result { get; private set; }

        /// <summary>Whether no attempt follows.</summary>
        public bool IsDone { get; set; }

        /// <summary>Begins an attempt.</summary>
        public void Begin(double cellError, double crossCellError)
        {
            (CellError, CrossCellError) = (cellError, Math.Min(cellError, crossCellError));
            Sums = new TubeSums(Pose, Grid);
            Next = 0;
            _hasRevealed = false;
            _slices.Begin(Math.Sqrt(CellError * CrossCellError));
        }

        /// <summary>
        /// Takes what the attempts before have revealed: true once an attempt, although a slice may be traced again.
        /// </summary>
        public bool TakesRevealed() => !_hasRevealed && (_hasRevealed = true);

        /// <summary>Tells the kernels how finely cells are divided and borders found.</summary>
        public void SetAccuracy(ref TubePose pose)
        {
            pose.CellError = (float)(CellError * 2 * Grid.Side * Grid.Side);
            pose.CrossWeight = (float)(CellError / CrossCellError);
            (pose.MaxLevel, pose.MaxBisections) = ((uint)MaxLevel, (uint)MaxBisections);
        }

        /// <summary>Cells of the next slice; takes their rays from those left.</summary>
        /// <param name="atLeast">Cells, however many rays they take.</param>
        /// <param name="max">Cells.</param>
        public int SliceOf(long atLeast, long max, ref double raysLeft)
        {
            long count = _slices.CellsFrom(Next, Math.Min(Left, max), ref raysLeft);
            return RowsOf(Math.Max(Math.Min(Left, atLeast), count));
        }

        // Of a number of cells those that make whole rows, or a part of the row begun.
        int RowsOf(long count)
        {
            int across = Grid.Cells.x, left = across - (int)(Next % across);
            return (int)(left < across || count < across ? Math.Min(count, left) : count / across * across);
        }

        /// <summary>Cells of a slice that have no more than a number of corners.</summary>
        public long CellsWithin(long corners)
        {
            long across = Grid.Cells.x + 1;
            return corners < 2 * across ? corners / 2 - 1 : (corners / across - 1) * Grid.Cells.x;
        }

        /// <summary>Ends a slice.</summary>
        public void Took(int count, long[] rays)
        {
            _slices.Took(Next, count, rays);
            Next += count;
        }

        /// <summary>
        /// Ends the pose with the result of the attempt before, which did not meet the tolerance; false if there is none.
        /// </summary>
        public bool GiveUp()
        {
            if (Result == null)
                return false;
            Result.Rays += Sums.Rays;
            Next = Grid.Count;
            IsDone = true;
            return true;
        }

        /// <summary>Ends the attempt.</summary>
        public CrossSectionResult End()
        {
            Sums.Add(Edges);
            Result = Sums.ToResult();
            _attempts.Add((CellError, CrossCellError));
            Result.Attempts = _attempts.ToArray();
            _raysBefore += Result.Rays;
            Result.Rays = _raysBefore + Edges.Rays;
            return Result;
        }
    }
}
