using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A facet as the radar sees it, from vectors alone. Y is up, and H is horizontal. All vectors have unit length.
    /// </summary>
    readonly struct FacetView
    {
        /// <summary>Cosine of the incidence on the facet; below 0 it is seen from behind.</summary>
        public readonly double Cosine;

        /// <summary>Sine of the incidence on the facet.</summary>
        public readonly double Sine;

        /// <summary>
        /// Cosine and sine of the angle from the facet's direction towards the radar to the wind, seen from above.
        /// </summary>
        public readonly double WindCosine, WindSine;

        /// <summary>s of <see cref="FacetPower"/> along the global H and V.</summary>
        public readonly double TurnCosine, TurnSine;

        public FacetView(in double3 normal, in double3 toRadar, in double3 wind)
        {
            Cosine = math.dot(normal, toRadar);
            var across = math.cross(normal, toRadar);
            Sine = math.length(across);
            var horizontal = math.cross(new double3(0, 1, 0), toRadar);
            double length = math.length(horizontal);
            // A radar overhead has no H of its own: any will do, and one along the facet's s is at hand.
            (TurnCosine, TurnSine) = (1, 0);
            (WindCosine, WindSine) = (1, 0);
            // Mirror incidence: no direction towards the radar.
            if (!(Sine > 0))
                return;
            var s = across / Sine;
            if (length > 0)
            {
                var h = horizontal / length;
                (TurnCosine, TurnSine) = (math.dot(s, h), math.dot(s, math.cross(toRadar, h)));
            }
            // Directions of waves on the facet are those of their horizontal projections.
            var towards = (toRadar - Cosine * normal) / Sine;
            double flat = Math.Sqrt(towards.x * towards.x + towards.z * towards.z);
            if (flat > 0)
                (WindCosine, WindSine) = ((wind.x * towards.x + wind.z * towards.z) / flat,
                    (wind.x * towards.z - wind.z * towards.x) / flat);
        }
    }
}
