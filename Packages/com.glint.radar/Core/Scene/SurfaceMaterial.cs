using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// How a surface reflects: a perfect conductor, a half-space of one medium, or layers on either. Immutable.
    /// </summary>
    public sealed class SurfaceMaterial : IEquatable<SurfaceMaterial>
    {
        /// <summary>
        /// Slope of surfaces that are given none: about what a mesh of flat facets leaves out of a hull or a rock. It is
        /// no measurement.
        /// </summary>
        public const double DefaultSlope = 0.1;

        /// <summary>
        /// Gamma of surfaces that are given none, dB: a choice. Flat land has -20 (MathWorks, surfaceReflectivity), and
        /// rougher ground more.
        /// </summary>
        public const double DefaultGammaDb = -10;

        /// <summary>Slopes that a surface may have.</summary>
        public static readonly Interval Slopes = Interval.Closed(1e-3, 1);

        /// <summary>Values that <see cref="GammaDb"/> may have.</summary>
        public static readonly Interval Gammas = Interval.Closed(-100, 30);

        /// <summary>The material of triangles that are given none.</summary>
        public static readonly SurfaceMaterial PerfectConductor = new SurfaceMaterial("perfect conductor");

        // Cosine in place of 0: reflection along the surface is the limit, without a quotient of zeros.
        const double MinCosine = 1e-100;

        // Cosine of a normal and a direction of unit length, with their rounding.
        const double MaxCosine = 1 + 1e-9;

        readonly string _text;

        /// <summary>A material.</summary>
        /// <param name="name">For messages and results.</param>
        /// <param name="layers">Outermost first; copied. Null for none.</param>
        /// <param name="halfSpace">Medium behind the layers; null for a perfect conductor.</param>
        /// <param name="roughness">
        /// Root mean square height of what is too fine for the mesh, metres: <see cref="RoughnessLoss.MillerBrown"/>
        /// multiplies both reflection coefficients. 0: smooth.
        /// </param>
        /// <param name="slope"><see cref="Slope"/>.</param>
        /// <param name="gammaDb"><see cref="GammaDb"/>.</param>
        /// <exception cref="GlintException">The roughness, the slope or gamma is out of its range.</exception>
        public SurfaceMaterial(string name, IEnumerable<MaterialLayer> layers = null, Medium halfSpace = null,
            double roughness = 0, double slope = DefaultSlope, double gammaDb = DefaultGammaDb)
        {
            if (!(roughness >= 0 && roughness < double.PositiveInfinity))
                throw new GlintException($"material '{name}': its roughness {Medium.Number(roughness)} m is not a "
                    + "height: give 0 for a smooth surface, or metres above 0");
            RequireWithin(name, "slope", slope, Slopes);
            RequireWithin(name, "gamma in dB", gammaDb, Gammas);
            Name = name;
            Layers = layers?.ToArray() ?? Array.Empty<MaterialLayer>();
            HalfSpace = halfSpace;
            Roughness = roughness;
            (Slope, GammaDb) = (slope, gammaDb);
            string behind = halfSpace == null ? "perfect conductor" : $"half-space of {halfSpace}";
            _text = $"{name}: {string.Concat(Layers.Select(layer => $"{layer} on "))}{behind}"
                + (roughness > 0 ? $", roughness {Medium.Number(roughness)} m" : "")
                + (slope != DefaultSlope ? $", slope {Medium.Number(slope)}" : "")
                + (gammaDb != DefaultGammaDb ? $", gamma {Medium.Number(gammaDb)} dB" : "");
        }

        /// <summary>For messages and results.</summary>
        public string Name { get; }

        /// <summary>Outermost first; may be empty.</summary>
        public IReadOnlyList<MaterialLayer> Layers { get; }

        /// <summary>Medium behind the layers; null for a perfect conductor.</summary>
        public Medium HalfSpace { get; }

        /// <summary>Root mean square height of what is too fine for the mesh, metres; 0: smooth.</summary>
        public double Roughness { get; }

        /// <summary>
        /// Root mean square slope of the surface in one direction about its mesh: it spreads what a
        /// radar screen gets back. Nothing else reads it.
        /// </summary>
        public double Slope { get; }

        /// <summary>
        /// Diffuse echo of a radar screen: cross section over the area across the ray, dB (sigma0 = gamma sin(grazing)).
        /// </summary>
        public double GammaDb { get; }

        /// <summary>The same material with another slope and gamma.</summary>
        /// <exception cref="GlintException">One is out of its range.</exception>
        public SurfaceMaterial WithScatter(double slope, double gammaDb) =>
            new SurfaceMaterial(Name, Layers, HalfSpace, Roughness, slope, gammaDb);

        /// <summary>Whether it is a smooth perfect conductor without layers.</summary>
        public bool IsConductor => HalfSpace == null && Layers.Count == 0 && Roughness == 0;

        /// <summary>Confirms that there is data at a frequency.</summary>
        /// <param name="frequency">Hz.</param>
        /// <exception cref="GlintException">
        /// A medium has none; the message has the material, the frequency and the range with data.
        /// </exception>
        public void RequireData(double frequency)
        {
            for (int i = 0; i < Layers.Count; i++)
                RequireData(Layers[i].Medium, $"layer {i + 1}", frequency);
            if (HalfSpace != null)
                RequireData(HalfSpace, "half-space", frequency);
        }

        /// <summary>Reflection coefficients of a plane wave that comes through free space.</summary>
        /// <param name="cosIncidence">Cosine of the angle to the normal, 0 to 1.</param>
        /// <param name="frequency">Hz.</param>
        /// <exception cref="GlintException">There is no data at this frequency.</exception>
        public FresnelCoefficients Reflection(double cosIncidence, double frequency)
        {
            if (!(cosIncidence >= 0 && cosIncidence <= MaxCosine))
                throw new ArgumentOutOfRangeException(nameof(cosIncidence), cosIncidence, "from 0 to 1");
            if (!(frequency > 0 && frequency < double.PositiveInfinity))
                throw new ArgumentOutOfRangeException(nameof(frequency), frequency, "above 0");
            RequireData(frequency);
            double cosine = Math.Max(cosIncidence, MinCosine);
            double wavenumber = 2 * Math.PI * frequency / Signal.SpeedOfLight;
            var (s, p) = BehindLayers(cosine, frequency);
            foreach (var layer in Layers.Reverse())
                ThroughLayer(layer, cosine, frequency, wavenumber, ref s, ref p);
            var ofS = (s.Over * cosine - s.Under) / (s.Over * cosine + s.Under);
            var ofP = (p.Under * cosine - p.Over) / (p.Under * cosine + p.Over);
            if (Roughness == 0)
                return new FresnelCoefficients(ofS, ofP);
            double loss = RoughnessLoss.MillerBrown(wavenumber * Roughness * cosine);
            return new FresnelCoefficients(loss * ofS, loss * ofP);
        }

        /// <summary>Everything of the material in one line: equal materials have equal lines.</summary>
        public override string ToString() => _text;

        /// <inheritdoc/>
        public bool Equals(SurfaceMaterial other) => other?._text == _text;

        /// <inheritdoc/>
        public override bool Equals(object other) => Equals(other as SurfaceMaterial);

        /// <inheritdoc/>
        public override int GetHashCode() => _text.GetHashCode();

        static void RequireWithin(string name, string noun, double value, Interval range)
        {
            if (!range.Contains(value))
                throw new GlintException($"material '{name}': its {noun} {Medium.Number(value)} must be {range}");
        }

        void RequireData(Medium medium, string part, double frequency)
        {
            if (!medium.Frequencies.Contains(frequency))
                throw new GlintException($"material '{Name}' has no data at {Medium.Number(frequency)} Hz: its {part} "
                    + $"has data {medium.Frequencies} Hz; give a frequency in that range, or another material");
        }

        (Impedance s, Impedance p) BehindLayers(double cosine, double frequency)
        {
            if (HalfSpace == null)
                return (new Impedance(0, 1), new Impedance(0, 1));
            var (permittivity, permeability) = HalfSpace.At(frequency);
            var q = Complex.Sqrt(SquaredQ(permittivity, permeability, cosine));
            // The wave decays into the medium; without loss it carries its power into the medium.
            if (q.Imaginary > 0 || q.Imaginary == 0 && (permeability / q).Real < 0)
                q = -q;
            return (new Impedance(permeability, q), new Impedance(q, permittivity));
        }

        // z' = z_l (z + z_l T) / (z_l + z T) with T = j tan(k q t) = (1 - e) / (1 + e), e = exp(-2j k q t), multiplied
        // by 1 + e: no tangent of a large argument, and no quotient of zeros where q is 0.
        static void ThroughLayer(in MaterialLayer layer, double cosine, double frequency, double wavenumber,
            ref Impedance s, ref Impedance p)
        {
            var (permittivity, permeability) = layer.Medium.At(frequency);
            var squaredQ = SquaredQ(permittivity, permeability, cosine);
            var q = Complex.Sqrt(squaredQ);
            if (q.Imaginary > 0)
                q = -q;
            var x = wavenumber * layer.Thickness * q;
            var minusJ = -Complex.ImaginaryOne;
            var e = Complex.Exp(2 * minusJ * x);
            // (1 - e) / q; the sine has no cancellation where e is near 1.
            var ratio = Complex.Abs(x) >= 1
                ? (1 - e) / q
                : -2 * minusJ * wavenumber * layer.Thickness * Complex.Exp(minusJ * x)
                    * (x == Complex.Zero ? Complex.One : Complex.Sin(x) / x);
            s = s.Through(1 + e, permeability * ratio, squaredQ * ratio / permeability);
            p = p.Through(1 + e, squaredQ * ratio / permittivity, permittivity * ratio);
        }

        // eps mu - sin^2 of the incidence.
        static Complex SquaredQ(Complex permittivity, Complex permeability, double cosine) =>
            permittivity * permeability - 1 + cosine * cosine;

        // A surface impedance over that of free space, as a fraction: 0 for metal, infinite a quarter wave before it.
        readonly struct Impedance
        {
            public readonly Complex Over, Under;

            public Impedance(Complex over, Complex under) => (Over, Under) = (over, under);

            public Impedance Through(Complex same, Complex series, Complex shunt) =>
                new Impedance(Over * same + Under * series, Under * same + Over * shunt);
        }
    }

    /// <summary>A layer of a <see cref="SurfaceMaterial"/>.</summary>
    public readonly struct MaterialLayer
    {
        /// <summary>A layer.</summary>
        /// <param name="medium">Its medium.</param>
        /// <param name="thickness">Metres, 0 or more.</param>
        /// <exception cref="GlintException">The thickness is negative or not finite.</exception>
        public MaterialLayer(Medium medium, double thickness)
        {
            if (!(thickness >= 0 && thickness < double.PositiveInfinity))
                throw new GlintException($"the thickness of a layer is {Glint.Core.Medium.Number(thickness)} m: "
                    + "give 0 or more");
            (Medium, Thickness) = (medium, thickness);
        }

        /// <summary>Its medium.</summary>
        public Medium Medium { get; }

        /// <summary>Metres.</summary>
        public double Thickness { get; }

        /// <summary>Everything of the layer.</summary>
        public override string ToString() => $"{Glint.Core.Medium.Number(Thickness)} m of {Medium}";
    }

    /// <summary>
    /// Reflection coefficients of the electric field. s-hat is along d x n, p-hat is s-hat x d, before and after the
    /// mirror; time factor exp(+j omega t). A perfect conductor has -1 and +1.
    /// </summary>
    public readonly struct FresnelCoefficients
    {
        /// <summary>Both coefficients.</summary>
        public FresnelCoefficients(Complex s, Complex p) => (S, P) = (s, p);

        /// <summary>R_s: electric field normal to the plane of incidence.</summary>
        public Complex S { get; }

        /// <summary>R_p: electric field in the plane of incidence.</summary>
        public Complex P { get; }
    }
}
