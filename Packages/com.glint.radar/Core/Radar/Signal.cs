using System;

namespace Glint.Core
{
    /// <summary>
    /// From path lengths to phase, in-phase and quadrature: Documentation~/conventions.md, Signal. Phase and sum are
    /// those of the published experiment (a master's thesis of 2023, named in Editor/Published/README.md).
    /// </summary>
    public static class Signal
    {
        /// <summary>Speed of light in vacuum, m/s (exact by definition of the metre).</summary>
        public const double SpeedOfLight = 299792458.0;

        /// <summary>Bins of a phase histogram: 10 degrees each.</summary>
        public const int PhaseBins = 36;

        /// <summary>Wavelength in metres of a frequency in hertz.</summary>
        public static double Wavelength(double frequencyHz) => SpeedOfLight / frequencyHz;

        /// <summary>
        /// Phase 2 pi mod(R, lambda) / lambda in radians, 0 to 2 pi, of a whole path
        /// of <paramref name="pathLength"/> metres, out and back; <paramref name="wavelength"/> in metres too.
        /// It grows with the path: the conjugate of exp(-jkR).
        /// </summary>
        public static double Phase(double pathLength, double wavelength)
        {
            double turns = pathLength / wavelength;
            return 2 * Math.PI * (turns - Math.Floor(turns));
        }

        /// <summary>Wraps an angle from -2 pi to 2 pi to 0 to 2 pi, radians.</summary>
        public static double Turned(double radians) => radians < 0 ? radians + 2 * Math.PI : radians;

        /// <summary>
        /// 20 log10 of an amplitude, not calibrated to a radar cross section;
        /// null for amplitude 0.
        /// </summary>
        public static double? Decibels(double amplitude) => amplitude > 0 ? 20 * Math.Log10(amplitude) : (double?)null;

        /// <summary>The histogram bin of a phase in radians, modulo 2 pi.</summary>
        public static int PhaseBin(double phase)
        {
            double turns = phase / (2 * Math.PI);
            return Math.Min(PhaseBins - 1, (int)((turns - Math.Floor(turns)) * PhaseBins));
        }
    }
}
