namespace Glint.Editor
{
    /// <summary>A pose in chart coordinates: x and y from 0 at the left and the bottom to 1.</summary>
    readonly struct ChartPoint
    {
        public ChartPoint(PoseFigures pose, int row, (double, double) position,
            (double, double) lower, (double, double) upper)
        {
            Pose = pose;
            Row = row;
            (X, Y) = position;
            Lower = lower;
            Upper = upper;
        }

        public PoseFigures Pose { get; }

        /// <summary>Index of the pose in its run, from 0.</summary>
        public int Row { get; }

        public double X { get; }

        public double Y { get; }

        /// <summary>Ends of the band of the sampling error; the point itself if there is none.</summary>
        public (double X, double Y) Lower { get; }

        /// <inheritdoc cref="Lower"/>
        public (double X, double Y) Upper { get; }
    }
}
