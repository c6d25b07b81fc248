using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The rays of a view in the kernel's coordinates: relative to the scene's centre, starting on a plane just before
    /// the scene, so that the distance to the radar costs float32 no digits. Origin and direction (not normalised) are
    /// linear in the ray's position in the picture.
    /// </summary>
    public sealed class RayGrid
    {
        // Minimum distance from the rays' origins to the scene, as a fraction of its size.
        const double Clearance = 1e-3;

        /// <summary>The rays of a picture that go through a box.</summary>
        /// <param name="boxMin">
        /// Lower corner of the box around the scene, metres; above <paramref name="boxMax"/> when it is empty.
        /// </param>
        public RayGrid(in RadarSettings settings, in RadarView view, double3 boxMin, double3 boxMax)
        {
            bool isEmpty = !(boxMin.x <= boxMax.x);
            SceneCentre = isEmpty ? 0 : (boxMin + boxMax) / 2;
            double3 halfSize = isEmpty ? 0 : (boxMax - boxMin) / 2;
            double size = 2 * math.length(halfSize);
            double toCentre = math.dot(SceneCentre - view.Position, view.Forward);
            OriginDepth = math.max(0, toCentre - math.dot(math.abs(view.Forward), halfSize) - Clearance * size);

            double2 step = 2 * view.HalfSize(settings) / new double2(settings.RaysAcross, settings.RaysDown);
            double3 right = step.x * view.Right, up = step.y * view.Up;
            // The ray nearest to the scene's centre: the differences to the other rays are then no larger than the
            // scene.
            double3 seen = SceneCentre - view.Position;
            double2 centrePixel = new double2(math.dot(seen, view.Right), math.dot(seen, view.Up)) / step;
            if (!view.IsParallel)
                centrePixel = toCentre > 0 ? centrePixel / toCentre : 0;
            double2 half = new double2(settings.RaysAcross, settings.RaysDown) / 2;
            ReferencePixel = (int2)math.round(math.clamp(centrePixel + half, 0, 2 * half));
            double2 fromCentre = ReferencePixel - half;

            double3 aside = fromCentre.x * right + fromCentre.y * up;
            Origin = view.Position - SceneCentre + OriginDepth * view.Forward;
            SceneExtent = size + math.length(Origin);
            Direction = view.Forward;
            if (view.IsParallel)
            {
                Origin += aside;
                (OriginDx, OriginDy) = (right, up);
            }
            else
            {
                Origin += OriginDepth * aside;
                (OriginDx, OriginDy) = (OriginDepth * right, OriginDepth * up);
                Direction += aside;
                (DirectionDx, DirectionDy) = (right, up);
            }

            double3 away = math.max(math.abs(boxMin - view.Position), math.abs(boxMax - view.Position));
            MaxRelativeLength =
                isEmpty ? 1 : 1.01 * (math.length(away) - OriginDepth + (settings.MaxBounces - 1) * size);
        }

        /// <summary>Centre of the scene's bounds: the origin of the kernel's coordinates.</summary>
        public double3 SceneCentre { get; }

        /// <summary>
        /// Bound of segment lengths, metres: the diagonal of the scene's bounds plus the distance from its centre to
        /// <see cref="Origin"/>.
        /// </summary>
        public double SceneExtent { get; }

        /// <summary>
        /// Distance from the radar to the plane where rays start, along the view axis, metres; 0 if the radar is in the
        /// scene.
        /// </summary>
        public double OriginDepth { get; }

        /// <summary>
        /// The position in the picture, in rays from its left and bottom edge, to which others are relative.
        /// </summary>
        public int2 ReferencePixel { get; }

        /// <summary>
        /// Origin of the ray through <see cref="ReferencePixel"/>, relative to <see cref="SceneCentre"/>, metres.
        /// </summary>
        public double3 Origin { get; }

        /// <summary>Change of the origin by one ray to the right, metres.</summary>
        public double3 OriginDx { get; }

        /// <summary>Change of the origin by one ray up, metres.</summary>
        public double3 OriginDy { get; }

        /// <summary>
        /// Direction of the ray through <see cref="ReferencePixel"/>, scaled to 1 along the view axis.
        /// </summary>
        public double3 Direction { get; }

        /// <summary>Change of the direction by one ray to the right.</summary>
        public double3 DirectionDx { get; }

        /// <summary>Change of the direction by one ray up.</summary>
        public double3 DirectionDy { get; }

        /// <summary>Maximum path length up to the last hit, less <see cref="OriginDepth"/>, metres.</summary>
        public double MaxRelativeLength { get; }
    }
}
