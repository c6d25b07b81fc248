using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Complex amplitudes S in metres for the received and the sent polarisation: the cross section is |S|^2. Phases
    /// follow exp(+j omega t) and exp(-j k r).
    /// </summary>
    public struct ScatteringMatrix
    {
        /// <summary>Received V, sent V.</summary>
        public Complex VV;

        /// <summary>Received H, sent V.</summary>
        public Complex HV;

        /// <summary>Received V, sent H.</summary>
        public Complex VH;

        /// <summary>Received H, sent H.</summary>
        public Complex HH;

        /// <summary>Sum of two contributions.</summary>
        public static ScatteringMatrix operator +(in ScatteringMatrix a, in ScatteringMatrix b) =>
            new ScatteringMatrix { VV = a.VV + b.VV, HV = a.HV + b.HV, VH = a.VH + b.VH, HH = a.HH + b.HH };

        /// <summary>A contribution times a factor.</summary>
        public static ScatteringMatrix operator *(Complex factor, in ScatteringMatrix s) => new ScatteringMatrix
        {
            VV = factor * s.VV, HV = factor * s.HV, VH = factor * s.VH, HH = factor * s.HH
        };

        /// <summary>The elements of some polarisations; the others are NaN.</summary>
        public ScatteringMatrix Only(IReadOnlyList<Polarisation> polarisations)
        {
            var s = this;
            var elements = Polarisation.All.Select(polarisation => polarisations.Contains(polarisation)
                ? polarisation.Of(s)
                : new Complex(double.NaN, double.NaN)).ToArray();
            return Of(elements);
        }

        /// <summary>The matrix of elements in the order of <see cref="Polarisation.All"/>.</summary>
        public static ScatteringMatrix Of(IReadOnlyList<Complex> elements) => new ScatteringMatrix
        {
            VV = elements[0], HV = elements[1], VH = elements[2], HH = elements[3]
        };

        /// <summary>Cross section of an amplitude, decibels of a square metre; minus infinity for 0.</summary>
        public static double Dbsm(Complex s) => 20 * System.Math.Log10(s.Magnitude);
    }
}
