using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>Where a tube has met surfaces.</summary>
    struct TubePath
    {
        /// <summary>The hits, in order.</summary>
        public List<TubeHit> Hits;

        /// <summary>Direction from the radar.</summary>
        public double3 Direction;

        /// <summary>Whether both paths meet the same patches, seen by the same receivers.</summary>
        public bool HasSignatureOf(in TubePath other)
        {
            if (Hits.Count != other.Hits.Count)
                return false;
            for (int i = 0; i < Hits.Count; i++)
                if (Hits[i].Patch != other.Hits[i].Patch
                    || !Hits[i].Radiates.AsSpan().SequenceEqual(other.Hits[i].Radiates))
                    return false;
            return true;
        }
    }

    /// <summary>A hit of a tube: its centre, and what of the tube is on the surface.</summary>
    struct TubeHit
    {
        /// <summary>Position, in the BVH's coordinates; direction of arrival; normal towards it.</summary>
        public double3 Position, Direction, Normal;

        /// <summary>Edges of the footprint on the tangent plane, per metre of the grid.</summary>
        public double3 Pu, Pv;

        /// <summary>From the wavefront through the phase centre, metres.</summary>
        public double Length;

        /// <summary>Factor of the field's amplitude by the spread of the tube.</summary>
        public double Amplitude;

        /// <summary>Curvature of the surface along the ray, 1/m: positive where it turns away from it.</summary>
        public double Curvature;

        /// <summary>Caustic lines that the tube has passed.</summary>
        public int Caustics;

        /// <summary>Patch and surface.</summary>
        public int Patch, Surface;

        /// <summary>Whether the current here reaches each receiver.</summary>
        public bool[] Radiates;
    }
}
