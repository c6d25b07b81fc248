using System;

namespace Glint.Core
{
    /// <summary>Size of a target in wavelengths.</summary>
    public static class ElectricalSize
    {
        // Below it the method says little.
        const double MinWavelengths = 2;

        /// <summary>The warning of a target too small for rays and physical optics; null: it is large enough.</summary>
        /// <param name="subject">Name of what is computed.</param>
        /// <param name="size">Diagonal of the box around the target, metres.</param>
        /// <param name="frequency">The lowest one, hertz.</param>
        public static string Warning(string subject, double size, double frequency)
        {
            double wavelengths = size / Signal.Wavelength(frequency);
            return wavelengths >= MinWavelengths ? null : FormattableString.Invariant(
                $"{subject}: the target is {wavelengths:g2} wavelengths large at {frequency:g4} Hz: rays, physical optics and fringe fields are wrong by decibels there, and by any factor far below a wavelength: use a higher frequency (in hertz: 10 GHz is 10e9), or a full-wave program");
        }
    }
}
