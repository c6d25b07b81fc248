using System;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Absolute level of echoes by the radar equation, Pr = Pt Gt Gr lambda^2 sigma / ((4 pi)^3 R^4 L), as amplitudes
    /// whose square is the received power in watts.
    /// </summary>
    public sealed class RadarEquation
    {
        readonly double _scale;

        /// <param name="transmitPowerW">Peak power of the transmitter.</param>
        /// <param name="lossDb">Losses of transmitter, lines and receiver together, 0 or more.</param>
        /// <exception cref="GlintException">A number is out of its range.</exception>
        public RadarEquation(double transmitPowerW, double frequencyHz, double lossDb = 0)
        {
            Require.Positive("radar equation", "transmit power", transmitPowerW, "W");
            Require.Positive("radar equation", "frequency", frequencyHz, "Hz");
            Require.Within("radar equation", "loss", lossDb, "dB", Interval.Closed(0, 100));
            _scale = Math.Sqrt(transmitPowerW * PowerLevel.FromDecibels(-lossDb))
                * Signal.Wavelength(frequencyHz) / Math.Pow(4 * Math.PI, 1.5);
        }

        /// <summary>
        /// Amplitude of an echo in the root of a watt, without the phase of the path, which
        /// <see cref="PathGrid.Add"/> brings.
        /// </summary>
        /// <param name="transmitted"><see cref="Antenna.Field"/> in the direction of transmission.</param>
        /// <param name="received">The same in the direction of reception.</param>
        /// <param name="scattering">S in metres: the square of its magnitude is the cross section.</param>
        /// <param name="range">Metres from radar to scatterer, above 0.</param>
        public Complex Amplitude(Complex transmitted, Complex received, Complex scattering, double range) =>
            _scale / (range * range) * transmitted * received * scattering;
    }
}
