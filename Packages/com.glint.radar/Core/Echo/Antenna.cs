using System.Numerics;

namespace Glint.Core
{
    /// <summary>An antenna's gain and the product of its patterns in azimuth and in elevation.</summary>
    public sealed class Antenna
    {
        // Square degrees: the gain times the product of the beam widths of an antenna of usual efficiency.
        const double GainWidths = 26000;

        readonly AntennaPattern _azimuth, _elevation;

        /// <param name="gainDb">Gain in the middle of the beam, decibels of an isotropic antenna.</param>
        /// <exception cref="GlintException">The gain is out of its range.</exception>
        public Antenna(double gainDb, AntennaPattern azimuth, AntennaPattern elevation)
        {
            Require.Within("antenna", "gain", gainDb, "dB", Interval.Closed(-50, 100));
            Peak = System.Math.Sqrt(PowerLevel.FromDecibels(gainDb));
            (_azimuth, _elevation) = (azimuth, elevation);
        }

        /// <summary>The field one way where both patterns are 1: its square is the gain.</summary>
        public double Peak { get; }

        /// <summary>Usual gain of an antenna of these half-power beam widths, decibels.</summary>
        public static double UsualGainDb(double azimuthWidthDegrees, double elevationWidthDegrees) =>
            PowerLevel.ToDecibels(GainWidths / (azimuthWidthDegrees * elevationWidthDegrees));

        /// <summary>The field one way: the square of its magnitude is the gain.</summary>
        /// <param name="azimuth">Angle from the middle of the beam, radians, to the right.</param>
        /// <param name="elevation">Angle from the middle of the beam, radians, upwards.</param>
        public Complex Field(double azimuth, double elevation) =>
            Peak * _azimuth.Field(azimuth) * _elevation.Field(elevation);
    }
}
