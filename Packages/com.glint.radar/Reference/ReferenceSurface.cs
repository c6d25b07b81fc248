using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// Reflection from a material at one frequency, written from Fresnel's formulas. It takes the values of the media
    /// from <see cref="SurfaceMaterial"/>, and shares no formula with it.
    /// </summary>
    sealed class ReferenceSurface
    {
        // Directions of a mean over a wave: its error is below 1e-12 up to x = 1,000.
        const int WaveSteps = 1024;

        // Sine of the incidence below which any polarisation is that normal to the plane of incidence.
        const double NormalIncidence = 1e-9;

        readonly (Complex permittivity, Complex permeability, double thickness)[] _innerFirst;
        readonly (Complex permittivity, Complex permeability)? _halfSpace;
        readonly double _wavenumber, _roughness;
        readonly bool _isConductor;

        public ReferenceSurface(SurfaceMaterial material, double frequency)
        {
            material.RequireData(frequency);
            _wavenumber = ReferenceCrossSection.Wavenumber(frequency);
            (_roughness, _isConductor) = (material.Roughness, material.IsConductor);
            _innerFirst = material.Layers.Reverse().Select(layer =>
            {
                var (permittivity, permeability) = layer.Medium.At(frequency);
                return (permittivity, permeability, layer.Thickness);
            }).ToArray();
            if (material.HalfSpace != null)
                _halfSpace = material.HalfSpace.At(frequency);
        }

        /// <summary>
        /// Reflection coefficients of E normal to the plane of incidence (s) and in it (p); a conductor has -1 and 1.
        /// </summary>
        public (Complex s, Complex p) Coefficients(double cosine)
        {
            // Impedances of the surface over that of air.
            Complex s = 0, p = 0;
            if (_halfSpace is var (permittivity, permeability))
            {
                var q = Across(permittivity * permeability, cosine);
                (s, p) = (permeability / q, q / permittivity);
            }
            foreach (var layer in _innerFirst)
            {
                var q = Across(layer.permittivity * layer.permeability, cosine);
                // There and back through the layer.
                var path = Complex.Exp(-2 * Complex.ImaginaryOne * _wavenumber * layer.thickness * q);
                s = Through(s, layer.permeability / q, path);
                p = Through(p, q / layer.permittivity, path);
            }
            double loss = Loss(_wavenumber * _roughness * cosine);
            return (loss * (s * cosine - 1) / (s * cosine + 1), -loss * (p - cosine) / (p + cosine));
        }

        /// <summary>The reflected field.</summary>
        /// <param name="field">The arriving field.</param>
        /// <param name="direction">In which it arrives.</param>
        /// <param name="normal">Unit normal towards the side of arrival.</param>
        public ComplexVector Reflect(in ComplexVector field, double3 direction, double3 normal)
        {
            double along = math.dot(direction, normal);
            if (_isConductor)
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
            var (ofS, ofP) = Coefficients(Math.Abs(along));
            return ofS * field.Dot(s) * (ComplexVector)s
                + ofP * field.Dot(math.cross(s, direction)) * (ComplexVector)math.cross(s, mirrored);
        }

        // Miller and Brown's factor exp(-x) I0(x), x = 2 roughness^2, as a mean of phasors over a wave.
        static double Loss(double roughness)
        {
            if (roughness == 0)
                return 1;
            double sum = 0;
            for (int i = 0; i < WaveSteps; i++)
                sum += Math.Exp(2 * roughness * roughness * (Math.Cos(2 * Math.PI * (i + 0.5) / WaveSteps) - 1));
            return sum / WaveSteps;
        }

        // Component of the wave vector across the surface over the wavenumber in air; the wave decays inwards.
        static Complex Across(Complex squaredIndex, double cosine)
        {
            var q = Complex.Sqrt(squaredIndex - (1 - cosine * cosine));
            return q.Imaginary > 0 ? -q : q;
        }

        // Impedance before a layer, with j tan(k q t) = (1 - path) / (1 + path).
        static Complex Through(Complex behind, Complex layer, Complex path) =>
            layer * (behind * (1 + path) + layer * (1 - path)) / (layer * (1 + path) + behind * (1 - path));
    }
}
