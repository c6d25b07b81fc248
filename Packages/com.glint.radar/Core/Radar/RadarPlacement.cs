using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Where a radar stands that looks at a mesh file, and what it sees and receives. Degrees and metres, Unity's axes.
    /// </summary>
    public struct RadarPlacement
    {
        /// <summary>The point looked at, metres.</summary>
        public double3 Aim;

        /// <summary>From the radar to the point looked at, metres; above 0.</summary>
        public double Distance;

        /// <summary>How far the radar looks down, degrees: -90 to 90.</summary>
        public double GrazingDegrees;

        /// <summary>
        /// Where the radar stands about the vertical, degrees, positive as Unity's rotation about Y; 0:
        /// the radar stands on the -Z side and looks along +Z.
        /// </summary>
        public double AzimuthDegrees;

        /// <summary>Vertical field of view, degrees, above 0 and below 180.</summary>
        public double VerticalFovDegrees;

        /// <summary>Above 0: parallel rays, so many metres apart across and down, instead of a field of view.</summary>
        public double RaySpacing;

        /// <summary>
        /// Width and height of the rectangle that parallel rays leave, metres; 0:
        /// as large as the mesh looks from the radar.
        /// </summary>
        public double2 ApertureSize;

        /// <summary>
        /// Width and height of the receiver, metres; 0, with parallel rays: as large as their rectangle.
        /// </summary>
        public double2 ReceiverSize;
    }
}
