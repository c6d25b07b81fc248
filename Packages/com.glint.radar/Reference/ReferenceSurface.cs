using System;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// Fresnel reflection from a perfect conductor, a conductor behind one layer, or a half-space (rcs: permittivity
    /// e' - j e'', permeability mu' - j mu'', both relative). It shares no code with the materials of the product.
    /// </summary>
    public sealed class ReferenceSurface
    {
        // Sine of the incidence below which any polarisation is that normal to the plane of incidence.
        const double NormalIncidence = 1e-9;

        readonly Complex _permittivity, _permeability;

        // metres; infinite: a half-space
        readonly double _thickness;

        ReferenceSurface(Complex permittivity, Complex permeability, double thickness) =>
            (_permittivity, _permeability, _thickness) = (permittivity, permeability, thickness);

        /// <summary>The perfect conductor.</summary>
        public static ReferenceSurface Conductor { get; } = new ReferenceSurface(1, 1, 0);

        /// <summary>A conductor behind a layer.</summary>
        /// <param name="thickness">Metres.</param>
        public static ReferenceSurface Layer(Complex permittivity, Complex permeability, double thickness) =>
            new ReferenceSurface(permittivity, permeability, thickness);

        /// <summary>A half-space.</summary>
        public static ReferenceSurface HalfSpace(Complex permittivity, Complex permeability) =>
            new ReferenceSurface(permittivity, permeability, double.PositiveInfinity);

        /// <summary>Whether it is a perfect conductor.</summary>
        public bool IsConductor => _thickness == 0;

        /// <summary>
        /// Reflection coefficients of E normal to the plane of incidence (s) and in it (p); a conductor has -1 and 1.
        /// </summary>
        /// <param name="wavenumber">Radians a metre, in air.</param>
        /// <param name="cosine">Of the angle of incidence from the normal.</param>
        public (Complex s, Complex p) Coefficients(double wavenumber, double cosine)
        {
            if (IsConductor)
                return (-1, 1);
            Complex q = Complex.Sqrt(_permittivity * _permeability - (1 - cosine * cosine));
            // The wave in the material decays away from the surface.
            if (q.Imaginary > 0 || q.Imaginary == 0 && q.Real < 0)
                q = -q;
            // Impedances of the surface over that of air.
            Complex s = _permeability / q, p = q / _permittivity;
            if (!double.IsInfinity(_thickness))
            {
                Complex through = Complex.ImaginaryOne * Complex.Tan(wavenumber * _thickness * q);
                s *= through;
                p *= through;
            }
            return ((s * cosine - 1) / (s * cosine + 1), -(p - cosine) / (p + cosine));
        }

        /// <summary>The reflected field.</summary>
        /// <param name="field">The arriving field.</param>
        /// <param name="direction">In which it arrives.</param>
        /// <param name="normal">Unit normal towards the side of arrival.</param>
        internal ComplexVector Reflect(in ComplexVector field, double3 direction, double3 normal, double wavenumber)
        {
            double along = math.dot(direction, normal);
            if (IsConductor)
                return 2 * field.Dot(normal) * (ComplexVector)normal - field;
            double3 mirrored = direction - 2 * along * normal;
            double3 s = math.cross(direction, normal);
            double sine = math.length(s);
            if (sine < NormalIncidence)
            {
                s = math.cross(direction, math.abs(direction.x) < 0.5 ? new double3(1, 0, 0) : new double3(0, 1, 0));
                sine = math.length(s);
            }
            s /= sine;
            var (ofS, ofP) = Coefficients(wavenumber, Math.Abs(along));
            return ofS * field.Dot(s) * (ComplexVector)s
                + ofP * field.Dot(math.cross(s, direction)) * (ComplexVector)math.cross(s, mirrored);
        }
    }
}
