using System;
using System.Numerics;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Speckle as a property of the sea's surface: complex Gaussian numbers of mean square 1 that depend on a cell of
    /// the surface, a seed and the time alone. Shaders/Speckle.hlsl has the same in float32.
    /// </summary>
    public readonly struct Speckle
    {
        const double Steps = 1 << 24;

        // In place of a time, for the fraction at which those of a cell begin.
        const uint NoTime = 0x80000000;

        Speckle(Complex approaching, Complex receding) => (Approaching, Receding) = (approaching, receding);

        /// <summary>Of the Bragg waves that run towards the radar.</summary>
        public Complex Approaching { get; }

        /// <summary>Of the Bragg waves that run away from it; independent of the others.</summary>
        public Complex Receding { get; }

        /// <summary>The seed of the speckle of one of the seas of a scene: seas with equal settings have different speckle.</summary>
        /// <param name="seed">Of the sea's settings.</param>
        /// <param name="number">Of the sea in the scene, from 0: the first has the seed of its settings.</param>
        public static uint SeedOf(uint seed, int number) => seed + 0x9e3779b9 * (uint)number;

        /// <summary>The numbers at a whole multiple of the coherence time.</summary>
        /// <param name="cell">Cell of the surface.</param>
        /// <param name="seed">Seed of the sea and its tile.</param>
        /// <param name="time">Times are independent.</param>
        public static Speckle At(int2 cell, uint seed, int time)
        {
            var words = Hash(new uint4((uint)cell.x, (uint)cell.y, seed, (uint)time));
            return new Speckle(Gaussian(words.x, words.y), Gaussian(words.z, words.w));
        }

        /// <summary>
        /// The numbers at any time: those of two whole times of the cell, which are at random fractions. Over the cells
        /// the correlation falls from 1 to 1 / pi over one coherence time, near exp(-t^2 / tau^2), and is 0 from two on.
        /// </summary>
        /// <param name="cell">Cell of the surface.</param>
        /// <param name="seed">Seed of the sea and its tile.</param>
        /// <param name="time">In coherence times.</param>
        public static Speckle Between(int2 cell, uint seed, double time)
        {
            time += (Hash(new uint4((uint)cell.x, (uint)cell.y, seed, NoTime)).x >> 8) / Steps;
            int whole = (int)Math.Floor(time);
            double angle = Math.PI / 2 * (time - whole), cosine = Math.Cos(angle), sine = Math.Sin(angle);
            Speckle before = At(cell, seed, whole), after = At(cell, seed, whole + 1);
            return new Speckle(cosine * before.Approaching + sine * after.Approaching,
                cosine * before.Receding + sine * after.Receding);
        }

        // pcg4d of Jarzynski and Olano, Hash Functions for GPU Rendering (2020).
        static uint4 Hash(uint4 v)
        {
            unchecked
            {
                v = v * 1664525u + 1013904223u;
                Mix(ref v);
                v ^= v >> 16;
                Mix(ref v);
                return v;
            }
        }

        static void Mix(ref uint4 v)
        {
            unchecked
            {
                v.x += v.y * v.w;
                v.y += v.z * v.x;
                v.z += v.x * v.y;
                v.w += v.y * v.z;
            }
        }

        // Box and Muller; the upper 24 bits, as float32 holds them.
        static Complex Gaussian(uint first, uint second) => Complex.FromPolarCoordinates(
            Math.Sqrt(-Math.Log(((first >> 8) + 1) / Steps)), 2 * Math.PI * ((second >> 8) / Steps));
    }
}
