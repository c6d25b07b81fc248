using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>One ray of the reference tracer, in double precision.</summary>
    public struct ReferenceRay
    {
        /// <summary>Reflections made.</summary>
        public int Bounces;

        /// <summary>True if the ray reached the receiver.</summary>
        public bool Received;

        /// <summary>Lengths from the radar to the first hit and to the last, metres; 0 without a hit.</summary>
        public double LengthToFirstHit, LengthToLastHit;

        /// <summary>Length from the radar over all hits to the receiver plane, metres; 0 if not received.</summary>
        public double PathLength;

        /// <summary>
        /// Received: the whole path. Otherwise: to the last hit. Metres, as RayData.PathLength.
        /// </summary>
        public double LengthToEnd => Received ? PathLength : LengthToLastHit;

        /// <summary>Last point of reflection, metres; the ray's start if nothing was hit.</summary>
        public double3 LastHit;

        /// <summary>Unit direction of the last segment.</summary>
        public double3 Direction;

        /// <summary>Triangle last hit, counted over the scene's instances in order; -1 if nothing was hit.</summary>
        public int LastTriangle;

        /// <summary>Object and surface last hit, as <see cref="MeshRange"/> has them; -1 if nothing was hit.</summary>
        public int LastObject, LastSurface;

        /// <summary>
        /// Hash of the triangles hit, in their order; 0 if nothing was hit.
        /// </summary>
        public long PathHash;
    }
}
