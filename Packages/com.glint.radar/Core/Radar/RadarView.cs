using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Poses of the radar and its receiver. Metres, Unity's axes. Rays start at <see cref="Position"/>; the receiver is
    /// a rectangle that receives rays travelling against <see cref="ReceiverForward"/>.
    /// </summary>
    public struct RadarView
    {
        /// <summary>Start of every ray; centre of the aperture of parallel rays.</summary>
        public double3 Position;

        /// <summary>Unit axes of the camera: x of the picture, y of the picture, view axis.</summary>
        public double3 Right, Up, Forward;

        /// <summary>
        /// Vertical field of view in degrees, above 0 and below 180; ignored for parallel rays.
        /// </summary>
        public double VerticalFovDegrees;

        /// <summary>
        /// Height in metres of the aperture of parallel rays: a rectangle through <see cref="Position"/>, perpendicular
        /// to <see cref="Forward"/>, with the picture's aspect ratio. 0: perspective.
        /// </summary>
        public double ApertureHeight;

        /// <summary>True for parallel rays.</summary>
        public bool IsParallel => ApertureHeight > 0;

        /// <summary>Centre of the receiver.</summary>
        public double3 ReceiverCentre;

        /// <summary>Unit axes of the receiver: along its width, along its height, its normal.</summary>
        public double3 ReceiverRight, ReceiverUp, ReceiverForward;

        /// <summary>Width and height of the receiver.</summary>
        public double2 ReceiverSize;

        /// <summary>
        /// Area of wavefront that each of the parallel rays represents, square metres; null in perspective.
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

        /// <summary>Start of the ray of a pixel (<see cref="RayData.Pixel"/>).</summary>
        public double3 StartOf(in RadarSettings settings, uint pixel)
        {
            if (!IsParallel)
                return Position;
            double2 rays = new double2(settings.RaysAcross, settings.RaysDown),
                position = (double2)settings.PositionOf(pixel) + 0.5;
            double2 from = (2 * position / rays - 1) * HalfSize(settings);
            return Position + from.x * Right + from.y * Up;
        }

        /// <summary>Refuses values out of range.</summary>
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
                throw new GlintException($"{owner}: its {what} is at ({RadarSettings.Text(position.x)}, "
                    + $"{RadarSettings.Text(position.y)}, {RadarSettings.Text(position.z)}) m, "
                    + $"and every coordinate must be within {RadarSettings.Text(TriangleMesh.LargestCoordinate)} m: "
                    + "bring the scene nearer to the world's origin");
        }
    }
}
