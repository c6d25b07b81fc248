using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The cells of ray tubes over the part of the picture in which a scene may be seen.</summary>
    public sealed class AmplitudeGrid
    {
        /// <summary>Cells along the longer side.</summary>
        public const int Cells = 240;

        // Part of its size by which the outline of the scene is widened, against rounding.
        const double Margin = 1e-4;

        // Smallest part of the scene's size before the radar of a corner whose place in the picture is used.
        const double MinDepth = 1e-3;

        /// <summary>The grid of a picture that goes over a box.</summary>
        /// <param name="settings">Rays and region of the picture.</param>
        /// <param name="view">In the frame of the box.</param>
        /// <param name="boxMin">Lower corner of the box around the scene, metres.</param>
        /// <param name="boxMax">Upper corner.</param>
        public AmplitudeGrid(in RadarSettings settings, in RadarView view, double3 boxMin, double3 boxMax)
        {
            var region = settings.TracedRegion;
            double2 regionMin = new double2(region.Left, region.Bottom),
                regionMax = regionMin + new double2(region.Width, region.Height);
            Outline(settings, view, boxMin, boxMax, out var lower, out var upper);
            double2 margin = Margin * (upper - lower);
            Lower = math.max(regionMin, lower - margin);
            double2 size = math.max(0, math.min(regionMax, upper + margin) - Lower);
            if (!(size.x > 0 && size.y > 0))
                return;
            double cell = math.max(size.x, size.y) / Cells;
            Count = (int2)math.max(1, math.ceil(size / cell - Margin));
            Step = size / Count;
        }

        /// <summary>Lower left corner, in rays from the left and bottom edge of the picture.</summary>
        public double2 Lower { get; }

        /// <summary>Width and height of a cell, in rays of the picture; 0 without cells.</summary>
        public double2 Step { get; }

        /// <summary>Cells across and up; 0 where nothing can be seen.</summary>
        public int2 Count { get; }

        // The rectangle of the picture around a box; all of the picture if a part is beside or behind the radar.
        static void Outline(in RadarSettings settings, in RadarView view, double3 boxMin, double3 boxMax,
            out double2 lower, out double2 upper)
        {
            double2 rays = new double2(settings.RaysAcross, settings.RaysDown), half = view.HalfSize(settings);
            (lower, upper) = (double.PositiveInfinity, double.NegativeInfinity);
            for (int corner = 0; corner < 8; corner++)
            {
                double3 at = Box.CornerOf(boxMin, boxMax, corner) - view.Position;
                double depth = view.IsParallel ? 1 : math.dot(at, view.Forward);
                if (!view.IsParallel && depth < MinDepth * math.length(boxMax - boxMin))
                {
                    (lower, upper) = (0, rays);
                    return;
                }
                double2 place = new double2(math.dot(at, view.Right), math.dot(at, view.Up)) / depth;
                place = (place / half + 1) * rays / 2;
                (lower, upper) = (math.min(lower, place), math.max(upper, place));
            }
        }
    }
}
