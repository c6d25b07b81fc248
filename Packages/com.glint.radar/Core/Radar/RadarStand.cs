using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Where a radar stands that looks at a mesh file. Degrees and metres, Unity's axes.</summary>
    public struct RadarStand
    {
        /// <summary>The point looked at.</summary>
        public double3 Aim;

        /// <summary>From the radar to the point looked at.</summary>
        public double Distance;

        /// <summary>How far the radar looks down.</summary>
        public double GrazingDegrees;

        /// <summary>About the vertical, positive as Unity's rotation about Y; 0: the radar stands on the -Z side and looks along +Z.</summary>
        public double AzimuthDegrees;

        /// <summary>Vertical field of view.</summary>
        public double VerticalFovDegrees;
    }
}
