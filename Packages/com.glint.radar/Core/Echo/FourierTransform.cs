using System.Collections.Generic;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Discrete Fourier transforms of one size, a power of two, by radix 2 in double precision: the same bits on every
    /// machine.
    /// </summary>
    sealed class FourierTransform
    {
        // e^(2 pi i n / size), n below half of the size.
        readonly double[] _cosines, _sines;

        public FourierTransform(int size)
        {
            Size = size;
            Reversed = new int[size];
            for (int i = 1; i < size; i++)
                Reversed[i] = Reversed[i / 2] / 2 + (i % 2) * size / 2;
            _cosines = new double[size / 2];
            _sines = new double[size / 2];
            for (int n = 0; n < size / 2; n++)
                (_sines[n], _cosines[n]) = PortableMath.SinCos((double)n / size);
        }

        public int Size { get; }

        /// <summary>For each index the one with its bits in reverse order.</summary>
        public int[] Reversed { get; }

        /// <summary>The smallest size that holds this number of values.</summary>
        public static int SizeFor(double count)
        {
            int size = 1;
            while (size < count)
                size = checked(2 * size);
            return size;
        }

        /// <summary>
        /// X[k] = sum over n of values[n] e^(+-2 pi i n k / size). Values that are missing at the end are 0.
        /// </summary>
        /// <param name="isPositive">The sign of the exponent.</param>
        public Complex[] Transform(IReadOnlyList<Complex> values, bool isPositive)
        {
            double[] real = new double[Size], imaginary = new double[Size];
            for (int n = 0; n < values.Count; n++)
                (real[Reversed[n]], imaginary[Reversed[n]]) = (values[n].Real, values[n].Imaginary);
            // With real and imaginary parts exchanged, before and after, the exponent has the other sign.
            if (isPositive)
                TransformReversed(real, imaginary, 0, 1, 1);
            else
                TransformReversed(imaginary, real, 0, 1, 1);
            var transform = new Complex[Size];
            for (int k = 0; k < Size; k++)
                transform[k] = new Complex(real[k], imaginary[k]);
            return transform;
        }

        /// <summary>
        /// The transform with exponent +, in place, of values in the order of <see cref="Reversed"/>. An element has
        /// this width: one number along a row, or a whole row across the rows.
        /// </summary>
        public void TransformReversed(double[] real, double[] imaginary, int start, int stride, int width)
        {
            for (int half = 1; half < Size; half *= 2)
                for (int block = 0; block < Size; block += 2 * half)
                    for (int n = 0; n < half; n++)
                    {
                        double cosine = _cosines[n * (Size / 2 / half)], sine = _sines[n * (Size / 2 / half)];
                        int a = start + (block + n) * stride, b = a + half * stride;
                        for (int end = a + width; a < end; a++, b++)
                        {
                            double turnedReal = real[b] * cosine - imaginary[b] * sine,
                                turnedImaginary = real[b] * sine + imaginary[b] * cosine;
                            real[b] = real[a] - turnedReal;
                            imaginary[b] = imaginary[a] - turnedImaginary;
                            real[a] += turnedReal;
                            imaginary[a] += turnedImaginary;
                        }
                    }
        }
    }
}
