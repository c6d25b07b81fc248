using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>One ray as the judge traced it, in double precision.</summary>
    public struct JudgeRay
    {
        /// <summary>Reflections made.</summary>
        public int Bounces;

        /// <summary>True if the ray reached the receiver.</summary>
        public bool Received;

        /// <summary>From the camera to the last hit, metres; 0 if nothing was hit.</summary>
        public double LengthToLastHit;

        /// <summary>From the camera over all hits to the receiver plane, metres; 0 if not received.</summary>
        public double PathLength;

        /// <summary>Last point of reflection, metres; the camera if nothing was hit.</summary>
        public double3 LastHit;

        /// <summary>Triangle last hit, counted over the scene's instances in order; -1 if nothing was hit.</summary>
        public int LastTriangle;
    }
}
