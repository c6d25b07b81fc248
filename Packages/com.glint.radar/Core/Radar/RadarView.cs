using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Where the radar stands and looks, and where it receives. Metres, Unity's axes.
    /// Rays leave <see cref="Position"/>; the receiver is a rectangle that takes rays travelling against its
    /// <see cref="ReceiverForward"/>.
    /// </summary>
    public struct RadarView
    {
        /// <summary>Where every ray starts.</summary>
        public double3 Position;

        /// <summary>Unit axes of the camera: x of the picture, y of the picture, view axis.</summary>
        public double3 Right, Up, Forward;

        /// <summary>
        /// Vertical field of view in degrees, above 0 and below 180; means nothing for parallel rays.
        /// </summary>
        public double VerticalFovDegrees;

        /// <summary>
        /// Height in metres of the aperture that parallel rays leave: a rectangle through <see cref="Position"/>,
        /// across <see cref="Forward"/>, as wide as the picture's aspect ratio makes it.
        /// 0: the rays leave <see cref="Position"/> in perspective.
        /// </summary>
        public double ApertureHeight;

        /// <summary>True for parallel rays.</summary>
        public bool IsParallel => ApertureHeight > 0;

        /// <summary>Middle of the receiver.</summary>
        public double3 ReceiverCentre;

        /// <summary>Unit axes of the receiver: along its width, along its height, the way it faces.</summary>
        public double3 ReceiverRight, ReceiverUp, ReceiverForward;

        /// <summary>Width and height of the receiver.</summary>
        public double2 ReceiverSize;

        /// <summary>
        /// Area of the wavefront that each of the parallel rays stands for, square metres; null in perspective.
        /// </summary>
        public double? RayArea(in RadarSettings settings) =>
            IsParallel ? math.pow(ApertureHeight / settings.RaysDown, 2) : (double?)null;

        /// <summary>
        /// Half the width and height of the picture: on the aperture of parallel rays, metres;
        /// in perspective at distance 1.
        /// </summary>
        public double2 HalfSize(in RadarSettings settings)
        {
            double height = IsParallel ? ApertureHeight / 2 : math.tan(math.radians(VerticalFovDegrees) / 2);
            return new double2(height * settings.Aspect, height);
        }

        /// <summary>Where the ray of a pixel (<see cref="RayData.Pixel"/>) leaves the radar.</summary>
        public double3 StartOf(in RadarSettings settings, uint pixel)
        {
            if (!IsParallel)
                return Position;
            double2 rays = new double2(settings.RaysAcross, settings.RaysDown),
                position = (double2)settings.PositionOf(pixel) + 0.5;
            double2 from = (2 * position / rays - 1) * HalfSize(settings);
            return Position + from.x * Right + from.y * Up;
        }

        /// <summary>Refuses a view that no ray can leave or return to.</summary>
        /// <param name="owner">Who holds the view, for the message.</param>
        /// <exception cref="GlintException">
        /// Field of view or receiver size out of range, or a position that is not finite.
        /// </exception>
        public void Validate(string owner)
        {
            if (!(ApertureHeight >= 0) || double.IsInfinity(ApertureHeight))
                throw new GlintException($"{owner}: aperture height {RadarSettings.Text(ApertureHeight)} m must be "
                    + "positive and finite, or 0 for a perspective view");
            if (!IsParallel && !(VerticalFovDegrees > 0 && VerticalFovDegrees < 180))
                throw new GlintException($"{owner}: field of view {RadarSettings.Text(VerticalFovDegrees)} deg must be "
                    + "above 0 and below 180");
            if (!(ReceiverSize.x > 0 && ReceiverSize.y > 0) || !math.all(math.isfinite(ReceiverSize)))
                throw new GlintException($"{owner}: receiver size {RadarSettings.Text(ReceiverSize.x)} x "
                    + $"{RadarSettings.Text(ReceiverSize.y)} m must be positive and finite");
            ValidatePosition(owner, "camera", Position);
            ValidatePosition(owner, "receiver", ReceiverCentre);
        }

        static void ValidatePosition(string owner, string what, double3 position)
        {
            if (!math.all(math.abs(position) <= TriangleMesh.LargestCoordinate))
                throw new GlintException($"{owner}: its {what} stands at ({RadarSettings.Text(position.x)}, "
                    + $"{RadarSettings.Text(position.y)}, {RadarSettings.Text(position.z)}) m, "
                    + $"and every coordinate must be within {RadarSettings.Text(TriangleMesh.LargestCoordinate)} m: "
                    + "bring the scene nearer to the world's origin");
        }
    }
}
