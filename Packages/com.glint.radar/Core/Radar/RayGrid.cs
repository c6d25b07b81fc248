using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The rays of a view as the kernel is given them: about the middle of the scene,
    /// and starting on a plane just before it, so that the distance to the radar costs a float32 no digits.
    /// Start and course (a direction of any length) are linear in the ray's place in the picture.
    /// </summary>
    public sealed class RayGrid
    {
        // Of the scene's size: so far before the scene the rays start at least.
        const double Clearance = 1e-3;

        /// <summary>The rays of a picture that go through a box.</summary>
        /// <param name="low">
        /// Lower corner of the box around the scene, metres; above <paramref name="high"/> when it is empty.
        /// </param>
        public RayGrid(in RadarSettings settings, in RadarView view, double3 low, double3 high)
        {
            bool isEmpty = !(low.x <= high.x);
            Middle = isEmpty ? 0 : (low + high) / 2;
            double3 halfSize = isEmpty ? 0 : (high - low) / 2;
            double size = 2 * math.length(halfSize);
            double toMiddle = math.dot(Middle - view.Position, view.Forward);
            StartDepth = math.max(0, toMiddle - math.dot(math.abs(view.Forward), halfSize) - Clearance * size);

            double2 step = 2 * view.HalfSize(settings) / new double2(settings.RaysAcross, settings.RaysDown);
            double3 right = step.x * view.Right, up = step.y * view.Up;
            // The ray nearest to the middle of the scene:
            // what is added for the others is no larger than the scene, where that matters.
            double3 seen = Middle - view.Position;
            double2 middle = new double2(math.dot(seen, view.Right), math.dot(seen, view.Up)) / step;
            if (!view.IsParallel)
                middle = toMiddle > 0 ? middle / toMiddle : 0;
            double2 half = new double2(settings.RaysAcross, settings.RaysDown) / 2;
            Reference = (int2)math.round(math.clamp(middle + half, 0, 2 * half));
            double2 place = Reference - half;

            double3 aside = place.x * right + place.y * up;
            Start = view.Position - Middle + StartDepth * view.Forward;
            Size = size + math.length(Start);
            Course = view.Forward;
            if (view.IsParallel)
            {
                Start += aside;
                (StartRight, StartUp) = (right, up);
            }
            else
            {
                Start += StartDepth * aside;
                (StartRight, StartUp) = (StartDepth * right, StartDepth * up);
                Course += aside;
                (CourseRight, CourseUp) = (right, up);
            }

            double3 away = math.max(math.abs(low - view.Position), math.abs(high - view.Position));
            LongestBeyond = isEmpty ? 1 : 1.01 * (math.length(away) - StartDepth + (settings.MaxBounces - 1) * size);
        }

        /// <summary>Middle of the scene's bounds: the origin of the kernel's coordinates.</summary>
        public double3 Middle { get; }

        /// <summary>
        /// How far rays go in the scene, or from a start within it: the diagonal of its bounds,
        /// and from the middle to a radar that stands near, metres.
        /// </summary>
        public double Size { get; }

        /// <summary>
        /// From the radar to the plane where rays start, along the view axis, metres; 0 when the radar is in the scene.
        /// </summary>
        public double StartDepth { get; }

        /// <summary>
        /// The place in the picture, in rays from its left and bottom edge, that others are counted from.
        /// </summary>
        public int2 Reference { get; }

        /// <summary>Start of the ray through <see cref="Reference"/>, from <see cref="Middle"/>, metres.</summary>
        public double3 Start { get; }

        /// <summary>How the start changes by one ray to the right, metres.</summary>
        public double3 StartRight { get; }

        /// <summary>How the start changes by one ray up, metres.</summary>
        public double3 StartUp { get; }

        /// <summary>
        /// Course of the ray through <see cref="Reference"/>: its direction, with 1 along the view axis.
        /// </summary>
        public double3 Course { get; }

        /// <summary>How the course changes by one ray to the right.</summary>
        public double3 CourseRight { get; }

        /// <summary>How the course changes by one ray up.</summary>
        public double3 CourseUp { get; }

        /// <summary>No path up to a last hit is longer than this and <see cref="StartDepth"/>, metres.</summary>
        public double LongestBeyond { get; }
    }
}
