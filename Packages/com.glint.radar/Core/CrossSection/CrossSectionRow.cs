using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The cross section of a scene in one direction, at one frequency, for one receiver.</summary>
    public sealed class CrossSectionRow
    {
        /// <summary>Angle between radar and receiver, degrees, above which physical optics does not hold.</summary>
        public const double MaxBistaticDegrees = 120;

        readonly IReadOnlyList<Polarisation> _polarisations;

        /// <summary>A row.</summary>
        /// <param name="planned">Directions and frequency.</param>
        /// <param name="s">Scattering matrix, metres.</param>
        /// <param name="polarisations">The elements of the matrix that were asked for.</param>
        public CrossSectionRow(in PlannedCrossSection planned, in ScatteringMatrix s,
            IReadOnlyList<Polarisation> polarisations) => (Planned, S, _polarisations) = (planned, s, polarisations);

        /// <summary>Directions and frequency.</summary>
        public PlannedCrossSection Planned { get; }

        /// <summary>Scattering matrix, metres.</summary>
        public ScatteringMatrix S { get; }

        /// <inheritdoc cref="CrossSectionResult.Errors"/>
        public double Error { get; set; }

        /// <inheritdoc cref="CrossSectionResult.CrossErrors"/>
        public double CrossError { get; set; }

        /// <summary>Level below which no accuracy was asked for, decibels of a square metre.</summary>
        public double FloorDbsm { get; set; }

        /// <summary>The error that was asked for, decibels.</summary>
        public double ToleranceDb { get; set; }

        /// <summary>Radius of the sphere around the scene, metres.</summary>
        public double Radius { get; set; }

        /// <summary>Share of the scene's area whose facets are too coarse at this frequency, 0 to 1.</summary>
        public double CoarseShare { get; set; }

        /// <summary>Tubes and rays of the trace that the row is from; it may be shared with other rows.</summary>
        public long Tubes { get; set; }

        /// <inheritdoc cref="Tubes"/>
        public long Rays { get; set; }

        /// <inheritdoc cref="CrossSectionResult.Bounces"/>
        public int Bounces { get; set; }

        /// <summary>Contributions of the scene's parts; null if they were not asked for.</summary>
        public CrossSectionContributions Contributions { get; set; }

        /// <summary>The amplitude of a polarisation, metres; null if it was not asked for.</summary>
        public Complex? Amplitude(Polarisation polarisation) =>
            _polarisations.Contains(polarisation) ? polarisation.Of(S) : (Complex?)null;

        /// <summary>The largest error of the amplitudes that were asked for, beside each.</summary>
        public CrossSectionAccuracy Accuracy => new CrossSectionAccuracy(_polarisations, S, Error, CrossError, FloorDbsm);

        /// <summary>Whether the error is as small as was asked for.</summary>
        public bool MeetsTolerance => Accuracy.Excess(ToleranceDb) <= 1;

        /// <summary>
        /// Whether radar and receiver are so far apart that physical optics does not hold: above
        /// <see cref="MaxBistaticDegrees"/>, except in the forward lobe. This is the target's shadow, as wide as the
        /// pattern of an aperture of the sphere's diameter.
        /// </summary>
        public bool IsOutsidePhysicalOptics
        {
            get
            {
                if (Planned.ReceiverAzimuthDegrees == null)
                    return false;
                double3 radar = Planned.Radar.ToRadar, receiver = Planned.ReceiverAspect.ToRadar;
                double angle = math.atan2(math.length(math.cross(radar, receiver)), math.dot(radar, receiver));
                double lobe = Signal.Wavelength(Planned.Frequency) / (2 * Radius);
                return angle > math.radians(MaxBistaticDegrees) && Math.PI - angle > lobe;
            }
        }

        /// <summary>Directions and frequency in a few words.</summary>
        public override string ToString() => Planned.ToString();
    }
}
