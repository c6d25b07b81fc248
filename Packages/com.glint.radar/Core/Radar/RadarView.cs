using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Where the radar stands and looks, and where it receives. Metres, Unity's axes.
    /// Rays leave <see cref="Position"/>; the receiver is a rectangle that takes rays travelling against its <see cref="ReceiverForward"/>.
    /// </summary>
    public struct RadarView
    {
        /// <summary>Where every ray starts.</summary>
        public double3 Position;

        /// <summary>Unit axes of the camera: x of the picture, y of the picture, view axis.</summary>
        public double3 Right, Up, Forward;

        /// <summary>Vertical field of view in degrees, above 0 and below 180.</summary>
        public double VerticalFovDegrees;

        /// <summary>Middle of the receiver.</summary>
        public double3 ReceiverCentre;

        /// <summary>Unit axes of the receiver: along its width, along its height, the way it faces.</summary>
        public double3 ReceiverRight, ReceiverUp, ReceiverForward;

        /// <summary>Width and height of the receiver.</summary>
        public double2 ReceiverSize;

        /// <summary>Half the picture's height at distance 1 from the camera.</summary>
        public double TanHalfFov => math.tan(math.radians(VerticalFovDegrees) / 2);

        /// <summary>Refuses a view that no ray can leave or return to.</summary>
        /// <param name="owner">Who holds the view, for the message.</param>
        /// <exception cref="GlintException">Field of view or receiver size out of range, or a position that is not finite.</exception>
        public void Validate(string owner)
        {
            if (!(VerticalFovDegrees > 0 && VerticalFovDegrees < 180))
                throw new GlintException($"{owner}: field of view {RadarSettings.Text(VerticalFovDegrees)} deg must be above 0 and below 180");
            if (!(ReceiverSize.x > 0 && ReceiverSize.y > 0) || !math.all(math.isfinite(ReceiverSize)))
                throw new GlintException($"{owner}: receiver size {RadarSettings.Text(ReceiverSize.x)} x {RadarSettings.Text(ReceiverSize.y)} m must be positive and finite");
            ValidatePlace(owner, "camera", Position);
            ValidatePlace(owner, "receiver", ReceiverCentre);
        }

        static void ValidatePlace(string owner, string what, double3 place)
        {
            if (!math.all(math.abs(place) <= TriangleMesh.LargestCoordinate))
                throw new GlintException($"{owner}: its {what} stands at ({RadarSettings.Text(place.x)}, {RadarSettings.Text(place.y)}, {RadarSettings.Text(place.z)}) m, and every coordinate must be within {RadarSettings.Text(TriangleMesh.LargestCoordinate)} m: bring the scene nearer to the world's origin");
        }
    }
}
