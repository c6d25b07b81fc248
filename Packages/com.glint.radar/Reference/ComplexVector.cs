using System.Numerics;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>A complex vector: the amplitude of an electric field.</summary>
    readonly struct ComplexVector
    {
        readonly double3 _re, _im;

        public ComplexVector(double3 re, double3 im) => (_re, _im) = (re, im);

        public static implicit operator ComplexVector(double3 real) => new ComplexVector(real, 0);

        public static ComplexVector operator +(in ComplexVector a, in ComplexVector b) =>
            new ComplexVector(a._re + b._re, a._im + b._im);

        public static ComplexVector operator -(in ComplexVector a, in ComplexVector b) =>
            new ComplexVector(a._re - b._re, a._im - b._im);

        public static ComplexVector operator *(Complex factor, in ComplexVector v) => new ComplexVector(
            factor.Real * v._re - factor.Imaginary * v._im, factor.Real * v._im + factor.Imaginary * v._re);

        public Complex Dot(double3 v) => new Complex(math.dot(_re, v), math.dot(_im, v));
    }
}
