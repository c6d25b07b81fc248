using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Power of complex echoes: square metres and dBsm of amplitudes in metres, watts and dBW of amplitudes in the
    /// root of a watt.
    /// </summary>
    public static class PowerLevel
    {
        /// <summary>Square of the magnitude.</summary>
        public static double Of(Complex value) => value.Real * value.Real + value.Imaginary * value.Imaginary;

        /// <summary>Squares of the magnitudes.</summary>
        public static double[] Of(IEnumerable<Complex> values) => values.Select(value => Of(value)).ToArray();

        /// <summary>10 log10 of the powers; minus infinity for 0.</summary>
        public static double[] Decibels(IEnumerable<Complex> values) => Of(values).Select(ToDecibels).ToArray();

        /// <summary>10 log10 of a power; minus infinity for 0.</summary>
        public static double ToDecibels(double power) => 10 * Math.Log10(power);

        /// <summary>The power of a number of decibels.</summary>
        public static double FromDecibels(double decibels) => Math.Pow(10, decibels / 10);
    }
}
