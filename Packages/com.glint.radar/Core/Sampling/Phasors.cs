using System;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>Fast phasors with six digits.</summary>
    static class Phasors
    {
        /// <summary>cos and sin of 2 pi <paramref name="turns"/>, to 2e-6.</summary>
        public static Complex OfTurns(double turns)
        {
            // The series at a quarter of the angle, doubled twice.
            double x = (turns - Math.Round(turns)) * (Math.PI / 2), square = x * x;
            double cos = 1 - square / 2 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56)));
            double sin = x * (1 - square / 6 * (1 - square / 20 * (1 - square / 42)));
            (cos, sin) = (cos * cos - sin * sin, 2 * cos * sin);
            return new Complex(cos * cos - sin * sin, 2 * cos * sin);
        }
    }
}
