using System;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// The spectrum of Elfouhaily et al. 1997 for a fully developed sea, written from the paper with System.Math, and
    /// integrals over it.
    /// </summary>
    sealed class ElfouhailyFromPaper
    {
        const double Gravity = 9.81, Peak = 370, SlowestSpeed = 0.23, InverseAge = 0.84;

        readonly double _peak, _peakSpeed, _friction;

        public ElfouhailyFromPaper(double wind)
        {
            _peak = Gravity / (wind * wind) * InverseAge * InverseAge;
            _peakSpeed = Speed(_peak);
            _friction = Math.Sqrt((0.8 + 0.065 * wind) * 1e-3) * wind;
        }

        /// <summary>Variance per wave number, m3.</summary>
        public double Omnidirectional(double k)
        {
            double root = Math.Sqrt(k / _peak), width = 0.08 * (1 + 4 * Math.Pow(InverseAge, -3));
            double enhancement = Math.Pow(1.7, Math.Exp(-(root - 1) * (root - 1) / (2 * width * width)));
            double side = Math.Exp(-1.25 * Math.Pow(_peak / k, 2)) * enhancement;
            double longWaves = 0.5 * 0.006 * Math.Sqrt(InverseAge) * _peakSpeed / Speed(k) * side
                * Math.Exp(-InverseAge / Math.Sqrt(10) * (root - 1));
            double strength = 0.01 * (1 + (_friction <= SlowestSpeed ? 1 : 3) * Math.Log(_friction / SlowestSpeed));
            double shortWaves = 0.5 * strength * SlowestSpeed / Speed(k) * side
                * Math.Exp(-0.25 * (k / Peak - 1) * (k / Peak - 1));
            return (longWaves + shortWaves) / (k * k * k);
        }

        /// <summary>Two-sided density, m4.</summary>
        public double Density(double k, double cosine) =>
            Omnidirectional(k) / (2 * Math.PI * k) * (1 + Spreading(k) * (2 * cosine * cosine - 1));

        /// <summary>Slope variance along and across the wind of waves between two wave numbers, rad/m.</summary>
        public double2 SlopeVariance(double from, double to) => Integral(from, to,
            k => k * k * Omnidirectional(k) / 2 * new double2(1 + Spreading(k) / 2, 1 - Spreading(k) / 2));

        /// <summary>
        /// Half the Stokes drift along the wind, m/s, of waves up to a wave number that all run with the wind.
        /// </summary>
        public double HalfStokesDrift(double to) => Integral(1e-3, to, k => k * Math.Sqrt(Gravity * k)
            * Omnidirectional(k) * (2 / Math.PI) * (1 + Spreading(k) / 3) * new double2(1, 0)).x;

        double Spreading(double k) => Math.Tanh(Math.Log(2) / 4 + 4 * Math.Pow(Speed(k) / _peakSpeed, 2.5)
            + 0.13 * _friction / SlowestSpeed * Math.Pow(SlowestSpeed / Speed(k), 2.5));

        static double Speed(double k) => Math.Sqrt(Gravity / k * (1 + k * k / (Peak * Peak)));

        // Over the logarithm of k, by the midpoints of many steps.
        static double2 Integral(double from, double to, Func<double, double2> density)
        {
            const int steps = 4000;
            double width = Math.Log(to / from) / steps;
            double2 sum = 0;
            for (int i = 0; i < steps; i++)
            {
                double k = from * Math.Exp((i + 0.5) * width);
                sum += density(k) * (k * width);
            }
            return sum;
        }
    }
}
