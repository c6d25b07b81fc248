using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Pose, field of view and receiver of a radar that looks at a mesh file. Degrees and metres, Unity's axes.
    /// </summary>
    public struct RadarPlacement
    {
        /// <summary>The point looked at, metres.</summary>
        public double3 Aim;

        /// <summary>Distance from the radar to its aim point, metres; above 0.</summary>
        public double Distance;

        /// <summary>Angle by which the radar looks down, degrees: -90 to 90.</summary>
        public double GrazingDegrees;

        /// <summary>
        /// Direction of the radar about the vertical, degrees, positive as Unity's rotation about Y; at 0 the radar is
        /// on the -Z side and looks along +Z.
        /// </summary>
        public double AzimuthDegrees;

        /// <summary>Vertical field of view, degrees, above 0 and below 180.</summary>
        public double VerticalFovDegrees;

        /// <summary>Above 0: spacing of parallel rays, across and down, metres. 0: perspective.</summary>
        public double RaySpacing;

        /// <summary>
        /// Width and height of the aperture of parallel rays, metres; 0: fitted to the mesh seen from the radar.
        /// </summary>
        public double2 ApertureSize;

        /// <summary>
        /// Width and height of the receiver, metres; 0, with parallel rays: those of the aperture.
        /// </summary>
        public double2 ReceiverSize;
    }
}
