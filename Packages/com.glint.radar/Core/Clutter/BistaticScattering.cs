using System;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// What ripples and mirror points of a sea scatter of one wave into another, at one frequency: small perturbations of
    /// first order (Rice 1951, Barrick and Peake 1968), geometrical optics on Gaussian slopes (Barrick 1968), and breaking
    /// waves. All are symmetric in the waves. Of one wave and its opposite they are <see cref="SeaScattering"/>'s.
    /// </summary>
    public sealed class BistaticScattering
    {
        static readonly double3[] s_axes = { new double3(1, 0, 0), new double3(0, 1, 0), new double3(0, 0, 1) };

        readonly Complex _permittivity;
        readonly double _waveNumber;
        readonly WaveDensity _density;

        /// <summary>Scattering at one frequency.</summary>
        /// <param name="frequency">Hz.</param>
        /// <param name="permittivity">Relative, e' - j e''.</param>
        /// <param name="density">Of the ripples.</param>
        public BistaticScattering(double frequency, Complex permittivity, WaveDensity density) =>
            (_waveNumber, _permittivity, _density) = (2 * Math.PI / Signal.Wavelength(frequency), permittivity, density);

        /// <summary>
        /// Sum of fields along and across the surface that both waves make on it: times k^2 / 4 pi and the Fourier
        /// transform of the ripples it is the scattered field, metres.
        /// </summary>
        /// <param name="normal">Of the facet, towards both waves.</param>
        public Complex Coupling(in SurfaceWave a, in SurfaceWave b, double3 normal)
        {
            var (fieldA, fieldB) = (FieldOf(a, normal), FieldOf(b, normal));
            return (_permittivity - 1) * (fieldA.X * fieldB.X + fieldA.Y * fieldB.Y + fieldA.Z * fieldB.Z
                + fieldA.Normal * fieldB.Normal / _permittivity);
        }

        /// <summary>
        /// Mean cross section of a facet per area over the squared magnitude of the coupling: pi k^4 times the density of the
        /// ripples that scatter one direction into the other; 0 where these are longer than the cut.
        /// </summary>
        /// <param name="towards">Directions of both waves, from the facet.</param>
        /// <param name="wind">Horizontal, along the wind.</param>
        /// <param name="growth">Of the density at a wave in gusts: factor by wave number and cosine to the wind.</param>
        public double RipplePower(double3 towards, double3 otherTowards, double3 normal, double3 wind,
            Func<double, double, double> growth = null)
        {
            if (!(math.dot(towards, normal) > 0 && math.dot(otherTowards, normal) > 0))
                return 0;
            double3 sum = towards + otherTowards, along = sum - math.dot(sum, normal) * normal;
            double size = math.length(along);
            if (!(size >= SeaScattering.TiltShare))
                return 0;
            double flat = Math.Sqrt(along.x * along.x + along.z * along.z), waveNumber = _waveNumber * size,
                cosine = flat > 0 ? (along.x * wind.x + along.z * wind.z) / flat : 1, squared = _waveNumber * _waveNumber;
            return Math.PI * squared * squared * _density(waveNumber, cosine) * (growth?.Invoke(waveNumber, cosine) ?? 1);
        }

        /// <summary>The field that a mirror point receives of wave b in the polarisation of wave a; not symmetric.</summary>
        public Complex Mirrored(in SurfaceWave a, in SurfaceWave b)
        {
            var (s, p, cosine, q) = Incidence(b, math.normalize(a.Towards + b.Towards));
            double3 mirrored = math.cross(s, a.Towards);
            return (cosine - q) / (cosine + q) * b.Along(s) * a.Along(s)
                + (_permittivity * cosine - q) / (_permittivity * cosine + q) * b.Along(p) * a.Along(mirrored);
        }

        /// <summary>The same of a mirror point that loses nothing; symmetric.</summary>
        public static Complex MirroredWhole(in SurfaceWave a, in SurfaceWave b)
        {
            double3 middle = math.normalize(a.Towards + b.Towards);
            var sum = 2 * a.Along(middle) * b.Along(middle);
            foreach (var axis in s_axes)
                sum -= a.Along(axis) * b.Along(axis);
            return sum;
        }

        /// <summary>
        /// Breaking waves per area of breaking surface, over the squared magnitude of <see cref="MirroredWhole"/>: what
        /// they return to a radar that looks along the slope that mirrors one direction into the other.
        /// </summary>
        public static double BreakingPower(double3 towards, double3 otherTowards)
        {
            double cosine = math.normalize(towards + otherTowards).y;
            return cosine > 0 ? SeaScattering.Breaking(cosine) : 0;
        }

        /// <summary>
        /// Mean cross section of a facet per area over the squared magnitude of <see cref="Mirrored"/>.
        /// </summary>
        /// <param name="variance">Of the unresolved slopes, along and across the wind, with their covariance.</param>
        public static double MirrorDensity(double3 towards, double3 otherTowards, double3 normal, double3 wind,
            double2 variance, double covariance)
        {
            double3 middle = math.normalize(towards + otherTowards);
            double determinant = variance.x * variance.y - covariance * covariance;
            if (!(normal.y > 0 && middle.y > 0 && variance.x > 0 && determinant > 0))
                return 0;
            double2 slope = normal.xz / normal.y - middle.xz / middle.y;
            double along = slope.x * wind.x + slope.y * wind.z, acrossWind = slope.x * wind.z - slope.y * wind.x,
                exponent = (along * along * variance.y + acrossWind * acrossWind * variance.x
                    - 2 * along * acrossWind * covariance) / (2 * determinant), squared = middle.y * middle.y;
            return exponent > -PortableMath.MinExponent ? 0
                : normal.y * Math.Exp(-exponent) / (2 * Math.Sqrt(determinant) * squared * squared);
        }

        // Of a direction along the normal.
        const double MinSine = 1e-9;

        // Across the plane of incidence and in it, the cosine of the incidence, and the wave number in the water along the
        // normal over that in air.
        (double3 S, double3 P, double Cosine, Complex Q) Incidence(in SurfaceWave wave, double3 normal)
        {
            double3 across = math.cross(normal, wave.Towards);
            double cosine = math.dot(normal, wave.Towards), sine = math.length(across);
            double3 s = sine > MinSine ? across / sine : wave.Across(normal);
            return (s, math.cross(wave.Towards, s), cosine, Complex.Sqrt(_permittivity - (1 - cosine * cosine)));
        }

        // Field of a wave and its reflection just above the surface.
        (Complex X, Complex Y, Complex Z, Complex Normal) FieldOf(in SurfaceWave wave, double3 normal)
        {
            var (s, p, cosine, q) = Incidence(wave, normal);
            var vertical = _permittivity * cosine + q;
            double upwards = math.dot(p, normal);
            double3 level = p - upwards * normal;
            Complex alongS = 2 * cosine / (cosine + q) * wave.Along(s), alongP = wave.Along(p),
                alongLevel = 2 * q / vertical * alongP;
            return (alongS * s.x + alongLevel * level.x, alongS * s.y + alongLevel * level.y,
                alongS * s.z + alongLevel * level.z, 2 * _permittivity * cosine / vertical * upwards * alongP);
        }
    }

    /// <summary>A wave that a place sends or receives.</summary>
    public readonly struct SurfaceWave
    {
        readonly double3 _v, _h;
        readonly Complex _alongV, _alongH;

        /// <summary>A wave of one polarisation.</summary>
        /// <param name="towards">Unit vector to where it comes from, or goes to.</param>
        /// <param name="v">Unit vectors across it.</param>
        /// <param name="alongV">Its field along these.</param>
        public SurfaceWave(double3 towards, double3 v, double3 h, Complex alongV, Complex alongH) =>
            (Towards, _v, _h, _alongV, _alongH) = (towards, v, h, alongV, alongH);

        /// <summary>Unit vector to where it comes from, or goes to.</summary>
        public double3 Towards { get; }

        /// <summary>Its field along a direction.</summary>
        public Complex Along(double3 direction) =>
            _alongV * math.dot(_v, direction) + _alongH * math.dot(_h, direction);

        // A unit vector across a direction close to the wave's.
        internal double3 Across(double3 direction) =>
            math.normalize(_v - math.dot(_v, direction) * direction);
    }
}
