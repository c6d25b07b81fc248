using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Neighbouring frequencies that share a trace: it has the reflection coefficients of one frequency, the middle of
    /// the group, and shadow edges of the width of the highest one.
    /// </summary>
    public sealed class FrequencyGroups
    {
        // Of the frequencies of a group: the width of shadow edges, of the highest one, is right within 3 %.
        const double MaxRatio = 1.1;

        readonly IReadOnlyList<double> _frequencies;
        readonly CoefficientBand[] _bands;
        readonly int[] _firsts;

        /// <param name="frequencies">Hertz, in ascending order.</param>
        /// <param name="materials">Those of the scene's surfaces, with data at all frequencies.</param>
        /// <param name="maxError">
        /// Error of a coefficient that a group may have at any of its frequencies and any angle of incidence, as a
        /// fraction of the coefficient, or of 0.01 where it is smaller.
        /// </param>
        public FrequencyGroups(IReadOnlyList<double> frequencies, IEnumerable<SurfaceMaterial> materials,
            double maxError)
        {
            _frequencies = frequencies;
            _bands = materials.Where(material => !material.IsConductor)
                .Select(material => new CoefficientBand(material, frequencies, maxError)).ToArray();
            _firsts = new int[frequencies.Count];
            for (int first = 0, last; first < _firsts.Length; first = last + 1)
            {
                last = LastOf(first);
                for (int i = first; i <= last; i++)
                    _firsts[i] = first;
            }
        }

        /// <summary>Number of groups.</summary>
        public int Count => _firsts.Distinct().Count();

        /// <summary>The first frequency of the group of a frequency, both by their places in the list.</summary>
        public int FirstOf(int frequency) => _firsts[frequency];

        /// <summary>The frequency of a group's coefficients, hertz.</summary>
        public static double MiddleOf(double lowest, double highest) => 0.5 * (lowest + highest);

        // By halves: where coefficients come back to what they were, a longer group is missed.
        int LastOf(int first)
        {
            int last = first, end = first;
            while (end + 1 < _firsts.Length && _frequencies[end + 1] <= MaxRatio * _frequencies[first])
                end++;
            while (last < end)
            {
                int middle = (last + end + 1) / 2;
                if (_bands.All(band => band.AreAlike(first, middle)))
                    last = middle;
                else
                    end = middle - 1;
            }
            return last;
        }
    }

    /// <summary>The reflection coefficients of a material over a list of frequencies.</summary>
    sealed class CoefficientBand
    {
        // Intervals of the cosine of incidence: coefficients are compared at their ends, and smooth between them.
        const int Steps = 128;

        // Coefficient below which errors are relative to this one: 40 dB below a conductor.
        const double MinCoefficient = 0.01;

        readonly SurfaceMaterial _material;
        readonly IReadOnlyList<double> _frequencies;
        readonly double _maxError;
        readonly Complex[][] _known;

        public CoefficientBand(SurfaceMaterial material, IReadOnlyList<double> frequencies, double maxError)
        {
            (_material, _frequencies, _maxError) = (material, frequencies, maxError);
            _known = new Complex[frequencies.Count][];
        }

        /// <summary>Whether those in the middle of a range are good enough for all of its frequencies.</summary>
        public bool AreAlike(int first, int last)
        {
            var middle = At(FrequencyGroups.MiddleOf(_frequencies[first], _frequencies[last]));
            for (int i = first; i <= last; i++)
            {
                var own = _known[i] ??= At(_frequencies[i]);
                for (int c = 0; c < own.Length; c++)
                    if (Complex.Abs(own[c] - middle[c])
                        > _maxError * Math.Max(MinCoefficient, Complex.Abs(own[c])))
                        return false;
            }
            return true;
        }

        // R_s and R_p over the cosine of the angle of incidence.
        Complex[] At(double frequency) => Enumerable.Range(0, Steps + 1)
            .Select(step => _material.Reflection((double)step / Steps, frequency))
            .SelectMany(reflection => new[] { reflection.S, reflection.P }).ToArray();
    }
}
