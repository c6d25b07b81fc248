using System;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Variance of the height over wave vectors, m4. It is two-sided: waves that run both ways are in it at both of
    /// their vectors, and its integral over all vectors is the variance in m2.
    /// </summary>
    /// <param name="waveNumber">rad/m, above 0.</param>
    /// <param name="cosine">
    /// Cosine of the angle between wind and wave vector; the density is the same at its negative.
    /// </param>
    public delegate double WaveDensity(double waveNumber, double cosine);

    /// <summary>
    /// Sigma0 of the sea at one frequency: Bragg scattering by short waves on tilted facets (small perturbations of
    /// first order), mirror points of the slopes that no mesh carries, and breaking waves. Y is up; vectors have unit
    /// length; H is horizontal. Formulas and sources: Valenzuela 1978; Kudryavtsev et al. 2003.
    /// </summary>
    public sealed class SeaScattering
    {
        /// <summary>
        /// Waves up to this share of the radar's wave number tilt the surface, shorter ones are Bragg waves. A tenth to
        /// a half changes HH by 1.3 dB at 10 deg of grazing, VV by 0.1 dB.
        /// </summary>
        public const double TiltShare = 1.0 / 3;

        /// <summary>
        /// Frequencies in Hz with Bragg waves of at most 2,000 rad/m, to which Elfouhaily's spectrum is used, and of a
        /// permittivity that is known.
        /// </summary>
        public static readonly Interval Frequencies = Interval.Closed(1e9, 4.7e10);

        // Steps across the slopes, in standard deviations: the end and the width of one.
        const double LastSlope = 5;
        const int SlopeSteps = 120;

        // Slope variance of breaking waves, and what they return outside of mirror directions (Kudryavtsev et al.).
        const double BreakingSlopeVariance = 0.19, BreakingPedestal = 0.005;

        // Saturation k^4 density of the ripples on breaking waves (Kudryavtsev et al. 2019).
        const double BreakingSaturation = 0.01;

        readonly Complex _permittivity;
        readonly WaveDensity _density;

        /// <summary>Refuses a frequency outside <see cref="Frequencies"/>, hertz.</summary>
        /// <exception cref="GlintException">It is.</exception>
        public static void RequireFrequency(double frequency)
        {
            if (!Frequencies.Contains(frequency))
                throw new GlintException($"sea clutter: the frequency {Medium.Number(frequency)} Hz must be "
                    + $"{Frequencies} Hz, where spectra of the short waves hold");
        }

        /// <summary>The sea at one frequency.</summary>
        /// <param name="frequency">Hz, one of <see cref="Frequencies"/>.</param>
        /// <param name="permittivity">Relative, e' - j e''.</param>
        /// <param name="density">The short waves, from <see cref="TiltCut"/> to twice the wave number.</param>
        /// <exception cref="GlintException">The frequency or the permittivity is not valid.</exception>
        public SeaScattering(double frequency, Complex permittivity, WaveDensity density)
        {
            RequireFrequency(frequency);
            if (!(permittivity.Real > 1 && permittivity.Imaginary <= 0 && Medium.IsFinite(permittivity.Real)
                && Medium.IsFinite(permittivity.Imaginary)))
                throw new GlintException($"sea clutter: the relative permittivity {Medium.Number(permittivity.Real)} - "
                    + $"j {Medium.Number(-permittivity.Imaginary)} is not that of a sea: give e' above 1 and e'' of 0 "
                    + "or more");
            WaveNumber = 2 * Math.PI / Signal.Wavelength(frequency);
            _permittivity = permittivity;
            _density = density;
        }

        /// <summary>The radar's wave number, rad/m.</summary>
        public double WaveNumber { get; }

        /// <summary>Longest Bragg wave and shortest tilting wave, rad/m.</summary>
        public double TiltCut => TiltShare * WaveNumber;

        /// <summary>Power reflection of a flat sea at normal incidence.</summary>
        public double MirrorPower
        {
            get
            {
                double magnitude = Complex.Abs(BraggCoefficients(_permittivity, 1).hh);
                return magnitude * magnitude;
            }
        }

        /// <summary>g_hh and g_vv of first-order scattering; time factor exp(+j omega t).</summary>
        /// <param name="permittivity">Relative, e' - j e''.</param>
        /// <param name="cosine">Of the incidence, 0 to 1.</param>
        public static (Complex hh, Complex vv) BraggCoefficients(Complex permittivity, double cosine)
        {
            double squaredSine = 1 - cosine * cosine;
            var q = Complex.Sqrt(permittivity - squaredSine);
            var h = cosine + q;
            var v = permittivity * cosine + q;
            return ((permittivity - 1) / (h * h),
                (permittivity - 1) * (permittivity * (1 + squaredSine) - squaredSine) / (v * v));
        }

        /// <summary>
        /// Bragg scattering of a plane facet per its true area: 0 from behind, and where the Bragg wave is longer than
        /// the cut. Valid from 20 deg of incidence on the facet, for short waves of k times height below 0.3.
        /// </summary>
        public Sigma0 Bragg(in double3 normal, in double3 toRadar, in double3 wind)
        {
            var view = new FacetView(normal, toRadar, wind);
            if (!HasBragg(view.Cosine, view.Sine))
                return default;
            var (hh, vv) = BraggCoefficients(_permittivity, view.Cosine);
            return FacetPower.OfTilted(hh, vv, BraggPower(view.Cosine, view.Sine, view.WindCosine), 1, 0)
                .Seen(view.TurnCosine, view.TurnSine);
        }

        /// <summary>
        /// Mirror points of a facet whose unresolved slopes are Gaussian and add to its own, per its true area; the
        /// same in HH and VV, 0 in HV. It belongs to incidences up to some 20 deg, and vanishes by itself at larger
        /// ones.
        /// </summary>
        /// <param name="normal">Of the facet.</param>
        /// <param name="toRadar">Towards the radar.</param>
        /// <param name="wind">Horizontal, along the wind.</param>
        /// <param name="slopeVariance">
        /// Of the waves from the facet's size to <see cref="TiltCut"/>, along and across the wind. 0: none.
        /// </param>
        /// <param name="covariance">Of the slopes along and across the wind.</param>
        public double Specular(in double3 normal, in double3 toRadar, in double3 wind, in double2 slopeVariance,
            double covariance = 0)
        {
            double determinant = slopeVariance.x * slopeVariance.y - covariance * covariance;
            if (!(normal.y > 0 && toRadar.y > 0 && slopeVariance.x > 0 && determinant > 0))
                return 0;
            // The slope that looks at the radar, from that of the facet.
            double2 slope = new double2(normal.x, normal.z) / normal.y - new double2(toRadar.x, toRadar.z) / toRadar.y;
            double along = slope.x * wind.x + slope.y * wind.z, across = slope.x * wind.z - slope.y * wind.x;
            double exponent = (along * along * slopeVariance.y + across * across * slopeVariance.x
                - 2 * along * across * covariance) / (2 * determinant);
            double squared = toRadar.y * toRadar.y;
            // Far from the mirror direction the exponential is 0 before the quotient overflows.
            return exponent > -PortableMath.MinExponent ? 0 : normal.y * MirrorPower * Math.Exp(-exponent)
                / (2 * Math.Sqrt(determinant) * squared * squared);
        }

        /// <summary>
        /// Breaking waves in HH and VV, which are the same, per area of breaking surface. Their slopes are those of the
        /// breakers about the mean sea.
        /// </summary>
        /// <param name="cosine">Of the incidence on the mean sea, above 0.</param>
        public static double Breaking(double cosine)
        {
            double squared = cosine * cosine, tangentSquared = (1 - squared) / squared;
            return (Math.Exp(-tangentSquared / BreakingSlopeVariance) / (squared * squared) + BreakingPedestal)
                / BreakingSlopeVariance;
        }

        /// <summary>
        /// Breaking waves in HV and VH, per area of breaking surface: Bragg scattering of ripples of a constant saturation,
        /// turned by the breakers' slopes across the radar's direction (Kudryavtsev et al. 2019).
        /// </summary>
        /// <param name="cosine">Of the incidence on the mean sea.</param>
        public double BreakingCross(double cosine)
        {
            double sine = Math.Sqrt(Math.Max(0, 1 - cosine * cosine));
            if (!HasBragg(cosine, sine))
                return 0;
            var (hh, vv) = Coefficients(cosine);
            double difference = Complex.Abs(vv - hh), ratio = cosine / sine, acrossVariance = BreakingSlopeVariance / 2;
            return Math.PI * difference * difference * ratio * ratio * ratio * ratio * acrossVariance / (sine * sine)
                * BreakingSaturation;
        }

        /// <summary>
        /// Two-scale mean of a whole sea without shadow and without breaking, per area of its facets: Bragg scattering
        /// and mirror points over Gaussian slopes.
        /// </summary>
        /// <param name="toRadar">Towards the radar.</param>
        /// <param name="wind">Horizontal, along the wind.</param>
        /// <param name="slopeVariance">Of all waves up to <see cref="TiltCut"/>, along and across the wind.</param>
        public Sigma0 TwoScaleMean(in double3 toRadar, in double3 wind, in double2 slopeVariance)
        {
            var up = new double3(0, 1, 0);
            var side = math.cross(up, wind);
            var sum = default(Sigma0);
            double weights = 0;
            for (int i = 0; i <= SlopeSteps; i++)
                for (int j = 0; j <= SlopeSteps; j++)
                {
                    double x = Deviation(i), y = Deviation(j), weight = Math.Exp(-(x * x + y * y) / 2);
                    var slope = x * Math.Sqrt(slopeVariance.x) * wind + y * Math.Sqrt(slopeVariance.y) * side;
                    sum += weight * Bragg(math.normalize(up - slope), toRadar, wind);
                    weights += weight;
                }
            double specular = Specular(up, toRadar, wind, slopeVariance);
            return 1 / weights * sum + new Sigma0(specular, specular, 0);
        }

        internal bool HasBragg(double cosine, double sine) => cosine > 0 && 2 * sine >= TiltShare;

        internal (Complex hh, Complex vv) Coefficients(double cosine) => BraggCoefficients(_permittivity, cosine);

        // 16 pi k^4 cos^4 Psi of the Bragg wave.
        internal double BraggPower(double cosine, double sine, double windCosine)
        {
            double squared = WaveNumber * WaveNumber * cosine * cosine;
            return 16 * Math.PI * squared * squared * _density(BraggWaveNumber(sine), windCosine);
        }

        // Longer Bragg waves than the cut are left out.
        internal double BraggWaveNumber(double sine) => Math.Max(TiltCut, 2 * WaveNumber * sine);

        static double Deviation(int step) => LastSlope * (2.0 * step / SlopeSteps - 1);
    }

    /// <summary>Fraction of the sea's surface that breaks: W = coefficient U10^3.41.</summary>
    public readonly struct WhitecapLaw
    {
        /// <summary>
        /// Of Monahan and O'Muircheartaigh 1980, s^3.41 m^-3.41. Published laws differ by a factor of several.
        /// </summary>
        public const double DefaultCoefficient = 3.84e-6;

        const double Exponent = 3.41;

        internal static readonly Interval Coefficients = Interval.Closed(0, 1e-3);

        static readonly Interval s_winds = Interval.Closed(0, 30);

        readonly double _coefficient;

        /// <summary>A law by its coefficient; 0 is a sea without breaking waves.</summary>
        /// <exception cref="GlintException">The coefficient is out of its range.</exception>
        public WhitecapLaw(double coefficient)
        {
            if (!Coefficients.Contains(coefficient))
                throw new GlintException($"sea clutter: the whitecap coefficient {Medium.Number(coefficient)} must be "
                    + $"{Coefficients}; the default is {Medium.Number(DefaultCoefficient)}");
            _coefficient = coefficient;
        }

        /// <summary>The law of Monahan and O'Muircheartaigh.</summary>
        public static WhitecapLaw Default => new WhitecapLaw(DefaultCoefficient);

        /// <summary>Fraction at a wind in m/s 10 m above the sea, at most 1.</summary>
        /// <exception cref="GlintException">The wind is out of the range of the law.</exception>
        public double Fraction(double wind) => s_winds.Contains(wind)
            ? Math.Min(1, _coefficient * Math.Pow(wind, Exponent))
            : throw new GlintException($"sea clutter: the wind {Medium.Number(wind)} m/s must be {s_winds} m/s for the "
                + "fraction of breaking waves");
    }
}
