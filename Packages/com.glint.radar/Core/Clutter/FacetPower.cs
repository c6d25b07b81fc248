using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Mean products of the elements of a facet's symmetric scattering matrix in the facet's own basis, m2/m2. Its
    /// first vector (s) is along normal x direction to the radar, its second (p) along direction to the radar x s.
    /// These six numbers give sigma0 in any other basis.
    /// </summary>
    readonly struct FacetPower
    {
        /// <summary>Mean squares of the elements ss, pp and sp.</summary>
        public readonly double SS, PP, SP;

        /// <summary>Real parts of the means ss pp*, ss sp*, pp sp*.</summary>
        public readonly double SSPP, SSSP, PPSP;

        public FacetPower(double ss, double pp, double sp, double sspp, double sssp, double ppsp) =>
            (SS, PP, SP, SSPP, SSSP, PPSP) = (ss, pp, sp, sspp, sssp, ppsp);

        /// <summary>
        /// Power of a matrix that is diagonal in a basis of its own, turned from this one: its first vector is
        /// cosine s + sine p.
        /// </summary>
        public static FacetPower OfTilted(Complex first, Complex second, double power, double cosine, double sine)
        {
            double a = cosine * cosine, b = sine * sine;
            Complex ss = a * first + b * second, pp = b * first + a * second, sp = cosine * sine * (first - second);
            return new FacetPower(power * Squared(ss), power * Squared(pp), power * Squared(sp),
                power * RealProduct(ss, pp), power * RealProduct(ss, sp), power * RealProduct(pp, sp));
        }

        public static FacetPower operator +(in FacetPower a, in FacetPower b) => new FacetPower(a.SS + b.SS,
            a.PP + b.PP, a.SP + b.SP, a.SSPP + b.SSPP, a.SSSP + b.SSSP, a.PPSP + b.PPSP);

        public FacetPower Scaled(double factor) =>
            new FacetPower(factor * SS, factor * PP, factor * SP, factor * SSPP, factor * SSSP, factor * PPSP);

        /// <summary>Sigma0 in global H and V.</summary>
        /// <param name="cosine">s in the direction of H.</param>
        /// <param name="sine">s in the direction of V.</param>
        public Sigma0 Seen(double cosine, double sine)
        {
            double a = cosine * cosine, b = sine * sine, product = cosine * sine;
            double both = 4 * a * b * SP + 2 * a * b * SSPP;
            return new Sigma0(
                a * a * SS + b * b * PP + both - 4 * product * (a * SSSP + b * PPSP),
                b * b * SS + a * a * PP + both + 4 * product * (b * SSSP + a * PPSP),
                a * b * (SS + PP - 2 * SSPP) + (a - b) * (a - b) * SP + 2 * product * (a - b) * (SSSP - PPSP));
        }

        static double Squared(Complex value) => RealProduct(value, value);

        static double RealProduct(Complex a, Complex b) => a.Real * b.Real + a.Imaginary * b.Imaginary;
    }
}
