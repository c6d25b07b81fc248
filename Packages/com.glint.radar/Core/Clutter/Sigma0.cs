using System;

namespace Glint.Core
{
    /// <summary>
    /// Mean radar cross section of a surface per area, linear (m2/m2), for three polarisations; that of VH is that of
    /// HV.
    /// </summary>
    public readonly struct Sigma0
    {
        /// <summary>By its values.</summary>
        public Sigma0(double hh, double vv, double hv) => (HH, VV, HV) = (hh, vv, hv);

        /// <summary>Sent and received in H.</summary>
        public double HH { get; }

        /// <summary>Sent and received in V.</summary>
        public double VV { get; }

        /// <summary>Sent in one and received in the other.</summary>
        public double HV { get; }

        /// <summary>10 log10 of a value; minus infinity for 0.</summary>
        public static double Decibels(double value) => 10 * Math.Log10(value);

        /// <summary>Powers of independent echoes add.</summary>
        public static Sigma0 operator +(Sigma0 a, Sigma0 b) => new Sigma0(a.HH + b.HH, a.VV + b.VV, a.HV + b.HV);

        /// <summary>All three, scaled.</summary>
        public static Sigma0 operator *(double factor, Sigma0 it) =>
            new Sigma0(factor * it.HH, factor * it.VV, factor * it.HV);
    }
}
