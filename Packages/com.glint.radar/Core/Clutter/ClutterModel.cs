using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Core
{
    /// <summary>What a published model of mean sea reflectivity is asked for.</summary>
    public readonly struct ClutterConditions
    {
        /// <summary>By its values.</summary>
        /// <param name="frequency">Hz.</param>
        /// <param name="grazingDegrees">Above the horizontal.</param>
        /// <param name="seaState">Douglas; fractions are allowed.</param>
        /// <param name="windAngleDegrees">0: the radar looks against the wind; 180: along it.</param>
        public ClutterConditions(double frequency, double grazingDegrees, double seaState, double windAngleDegrees) =>
            (Frequency, GrazingDegrees, SeaState, WindAngleDegrees) =
                (frequency, grazingDegrees, seaState, windAngleDegrees);

        /// <summary>Hz.</summary>
        public double Frequency { get; }

        /// <summary>Angle above the horizontal.</summary>
        public double GrazingDegrees { get; }

        /// <summary>Douglas sea state.</summary>
        public double SeaState { get; }

        /// <summary>
        /// Angle from the direction that the wind comes from. Models without wind direction ignore it.
        /// </summary>
        public double WindAngleDegrees { get; }

        internal double Gigahertz => Frequency / 1e9;

        internal double Wavelength => Signal.Wavelength(Frequency);

        internal double Grazing => GrazingDegrees * Math.PI / 180;

        internal double WindCosine => Math.Cos(WindAngleDegrees * Math.PI / 180);
    }

    /// <summary>
    /// A published model of the mean reflectivity of the sea, for HH and VV, with its range of validity. Their
    /// measurements scatter by several dB between campaigns.
    /// </summary>
    public abstract class ClutterModel
    {
        /// <summary>The models in the order of options and plots: formulas, and a table of measurements.</summary>
        public static readonly IReadOnlyList<ClutterModel> All = new ClutterModel[]
        {
            new NrlModel(), new GitModel(), new TscModel(), new HybridModel(), new NathansonTable()
        };

        /// <summary>Name of a level in options and results: "nrl".</summary>
        public static string NameOf(ClutterLevel level) => level.ToString().ToLowerInvariant();

        /// <summary>The model of a level; null for physics.</summary>
        public static ClutterModel Of(ClutterLevel level) => All.FirstOrDefault(model => model.Name == NameOf(level));

        readonly Interval _gigahertz, _grazing, _seaStates;

        private protected ClutterModel(string name, string title, in Interval gigahertz, in Interval grazing,
            in Interval seaStates)
        {
            (Name, Title) = (name, title);
            (_gigahertz, _grazing, _seaStates) = (gigahertz, grazing, seaStates);
        }

        /// <summary>"nrl".</summary>
        public string Name { get; }

        /// <summary>For plots: authors and year.</summary>
        public string Title { get; }

        /// <summary>Mean sigma0 in decibels.</summary>
        /// <param name="polarisation">hh or vv.</param>
        /// <param name="at">Radar and sea.</param>
        /// <exception cref="GlintException">
        /// A condition is out of the model's range, or it has no such polarisation.
        /// </exception>
        public double Decibels(Polarisation polarisation, in ClutterConditions at)
        {
            if (polarisation.Sent != polarisation.Received)
                throw new GlintException($"clutter model {Name}: it has no {polarisation}: give hh or vv");
            Check(_gigahertz, at.Gigahertz, "frequency", "GHz");
            Check(_grazing, at.GrazingDegrees, "grazing angle", "deg");
            Check(_seaStates, at.SeaState, "sea state", null);
            if (!Medium.IsFinite(at.WindAngleDegrees))
                throw new GlintException($"clutter model {Name}: the wind angle is not a number: give degrees");
            return Compute(polarisation.Sent == 1, at);
        }

        /// <summary>The same; null where the model does not hold.</summary>
        public double? DecibelsOrNull(Polarisation polarisation, in ClutterConditions at)
        {
            try
            {
                return Decibels(polarisation, at);
            }
            catch (GlintException)
            {
                return null;
            }
        }

        /// <summary>Refuses conditions in which the model does not hold for both VV and HH.</summary>
        /// <exception cref="GlintException">A condition is out of the model's range.</exception>
        public void Require(in ClutterConditions at)
        {
            Decibels(Polarisation.VV, at);
            Decibels(Polarisation.HH, at);
        }

        /// <summary>Whether the model holds for both VV and HH.</summary>
        public bool Holds(in ClutterConditions at) =>
            DecibelsOrNull(Polarisation.VV, at) != null && DecibelsOrNull(Polarisation.HH, at) != null;

        // All conditions are in range.
        private protected abstract double Compute(bool isHorizontal, in ClutterConditions at);

        void Check(in Interval range, double value, string noun, string unit)
        {
            unit = unit == null ? "" : " " + unit;
            if (!range.Contains(value))
                throw new GlintException(FormattableString.Invariant(
                    $"clutter model {Name}: the {noun} {value:g6}{unit} must be ")
                    + $"{range}{unit}, where {Title} holds: choose another model, or physics");
        }
    }

    /// <summary>
    /// Gregers-Hansen and Mital, NRL/MR/5310-12-9346 (2012): five constants fitted to Nathanson's table, with a mean
    /// deviation of 2.3 dB up to 10 deg.
    /// </summary>
    sealed class NrlModel : ClutterModel
    {
        public NrlModel() : base("nrl", "NRL (Gregers-Hansen and Mital 2012)", Interval.Closed(0.5, 35),
            Interval.Closed(0.1, 60), Interval.Closed(0, 6))
        {
        }

        private protected override double Compute(bool isHorizontal, in ClutterConditions at)
        {
            double psi = at.GrazingDegrees, state = at.SeaState;
            var (c1, c2, c3, c4, c5) = isHorizontal
                ? (-73.00, 20.78, 7.351, 25.65, 0.00540)
                : (-50.79, 25.93, 0.7093, 21.58, 0.00211);
            return c1 + c2 * Math.Log10(Math.Sin(at.Grazing))
                + (27.5 + c3 * psi) * Math.Log10(at.Gigahertz) / (1 + 0.95 * psi)
                + c4 * Math.Pow(1 + state, 1 / (2 + 0.085 * psi + 0.033 * state)) + c5 * psi * psi;
        }
    }

    /// <summary>
    /// Georgia Tech's model (Horst, Dyer and Tuley 1978). Up to sea state 2 and below 1 deg it lies 10 to 50 dB under
    /// measurements. The roughness is divided by the wavelength; NRL's listing has the wavelength plus 15 mm, which is
    /// up to 7 dB less where the sea is smooth.
    /// </summary>
    sealed class GitModel : ClutterModel
    {
        const double HeightOffset = 0.015, WavelengthOffset = 0.015, AngleOffset = 1e-4;

        public GitModel() : base("git", "GIT (Horst, Dyer and Tuley 1978)", Interval.Closed(1, 12), Interval.Closed(0.1, 10),
            Interval.Closed(1, 6))
        {
        }

        private protected override double Compute(bool isHorizontal, in ClutterConditions at)
        {
            double psi = at.Grazing, wavelength = at.Wavelength, wind = SeaStateFits.GitWind(at.SeaState);
            double height = 4.52e-3 * Math.Pow(wind, 2.5);
            double roughness = Math.Pow((14.4 * wavelength + 5.5) * psi * height / wavelength, 4);
            double interference = roughness / (1 + roughness), offset = wavelength + WavelengthOffset;
            double direction = Math.Exp(0.2 * at.WindCosine * (1 - 2.8 * psi) * Math.Pow(offset, -0.4));
            double speed = Math.Pow(1.94 * wind / (1 + wind / 15.4), 1.1 * Math.Pow(offset, -0.4));
            double hh = Sigma0.Decibels(3.9e-6 * wavelength * Math.Pow(psi, 0.4) * interference * direction * speed);
            if (isHorizontal)
                return hh;
            var (a, b, c, d) = at.Gigahertz >= 3 ? (1.05, 1.09, 1.27, 9.70) : (1.73, 3.76, 2.46, 22.2);
            return hh - a * Math.Log(height + HeightOffset) + b * Math.Log(wavelength)
                + c * Math.Log(psi + AngleOffset) + d;
        }
    }

    /// <summary>
    /// Technology Service Corporation's model (Antipov, DSTO-TR-0679, 1999). Lengths are in feet; listings in metres
    /// differ by 5 dB and more.
    /// </summary>
    sealed class TscModel : ClutterModel
    {
        const double MetresPerFoot = 0.3048;

        public TscModel() : base("tsc", "TSC (Antipov 1999)", Interval.Closed(0.5, 35), Interval.Closed(0.1, 60),
            Interval.Closed(1, 6))
        {
        }

        private protected override double Compute(bool isHorizontal, in ClutterConditions at)
        {
            double psi = at.Grazing, wavelength = at.Wavelength / MetresPerFoot;
            double height = 0.115 * Math.Pow(at.SeaState, 1.95);
            double roughness = Math.Pow(14.9 * psi * (height + 0.25) / wavelength, 1.5);
            double q = Math.Pow(psi, 0.6);
            double exponent = 2.63 * Math.Pow(1 + Math.Pow(wavelength / 0.03, 3), 0.1)
                / (Math.Pow(1 + Math.Pow(wavelength / 0.1, 3), 0.1)
                    * Math.Pow(1 + Math.Pow(wavelength / 0.3, 3), q / 3) * (1 + 0.35 * q));
            double speed = Math.Pow((6.2 * Math.Pow(at.SeaState, 0.8) + 4) / 15, exponent);
            double direction = Math.Exp(0.3 * at.WindCosine * Math.Exp(-psi / 0.17)
                / Math.Pow(wavelength * wavelength + 0.005, 0.2));
            double hh = Sigma0.Decibels(1.7e-5 * Math.Sqrt(psi) * direction * speed * roughness / (1 + roughness)
                / Math.Pow(wavelength + 0.05, 1.8));
            if (isHorizontal)
                return hh;
            var (a, b, c, d) = at.Gigahertz >= 2 ? (1.05, 1.09, 1.27, 9.65) : (1.73, 3.76, 2.46, 19.8);
            return hh - a * Math.Log(2.507 * height + 0.05) + b * Math.Log(wavelength)
                + c * Math.Log(Math.Sin(psi) + 1e-4) + d;
        }
    }

    /// <summary>
    /// Reilly and Dockery 1990. From 3 GHz on: the polarisation term of lower frequencies has no readable source. Two
    /// details differ between listings; here the transition angle has 0.0632, and the term of the wind's direction the
    /// natural logarithm.
    /// </summary>
    sealed class HybridModel : ClutterModel
    {
        const double Transition = 0.0632, ReferenceDegrees = 0.1, DegreesPerRadian = 180 / Math.PI;

        public HybridModel() : base("hybrid", "hybrid (Reilly and Dockery 1990)", Interval.Closed(3, 35),
            Interval.Closed(0.1, 30), Interval.Closed(1, 5))
        {
        }

        private protected override double Compute(bool isHorizontal, in ClutterConditions at)
        {
            double frequency = at.Gigahertz, state = at.SeaState, wavelength = at.Wavelength;
            double reference = frequency <= 12.5 ? 24.4 * Math.Log10(frequency) - 65.2
                : 3.25 * Math.Log10(frequency) - 42;
            double direction = (2 + 1.7 * Math.Log(0.1 / wavelength)) * (at.WindCosine - 1);
            double vv = reference + OfAngle(at.GrazingDegrees, wavelength / (0.031 * state * state)) + 5 * (state - 5)
                + direction;
            return isHorizontal ? vv + OfHorizontal(0.08 * state * state, wavelength, at) : vv;
        }

        static double OfAngle(double degrees, double wavelengthOverHeight)
        {
            double sine = Transition * wavelengthOverHeight;
            double transition = sine >= 1 ? 90 : Math.Asin(sine) * DegreesPerRadian;
            if (transition < ReferenceDegrees)
                return 10 * Math.Log10(degrees / ReferenceDegrees);
            return degrees <= transition
                ? 20 * Math.Log10(degrees / ReferenceDegrees)
                : 20 * Math.Log10(transition / ReferenceDegrees) + 10 * Math.Log10(degrees / transition);
        }

        static double OfHorizontal(double height, double wavelength, in ClutterConditions at) => at.Gigahertz <= 10
            ? 1.1 * Math.Log(height + 0.015) - 1.1 * Math.Log(wavelength) - 1.3 * Math.Log(at.Grazing + 1e-4) - 9.7
            : 1.4 * Math.Log(height) - 3.4 * Math.Log(wavelength) - 1.3 * Math.Log(at.Grazing) - 18.6;
    }
}
