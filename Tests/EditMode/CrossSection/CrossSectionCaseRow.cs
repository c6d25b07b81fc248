using System;
using System.Numerics;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>A row of the published cases, and what the kernels made of it.</summary>
    sealed class CrossSectionCaseRow
    {
        // Stands for no echo at all.
        const double NothingDbsm = -120;

        /// <param name="s">Amplitude of the row's polarisation, metres.</param>
        /// <param name="error">Standard error said, metres.</param>
        /// <param name="result">Of the pose, which rows may share.</param>
        /// <param name="milliseconds">Time of the pose.</param>
        public CrossSectionCaseRow(string name, PublishedRow row, Complex s, double error, CrossSectionResult result,
            double milliseconds)
        {
            (Case, Row, Error, Milliseconds) = (name, row, error, milliseconds);
            Dbsm = Math.Max(NothingDbsm, ScatteringMatrix.Dbsm(s));
            ErrorDb = 20 * Math.Log10(1 + error / s.Magnitude);
            (Tubes, Rays) = (result.Tubes, result.Rays);
        }

        public string Case { get; }

        public PublishedRow Row { get; }

        public double Dbsm { get; }

        /// <summary>Difference from the published value, decibels.</summary>
        public double Difference => Dbsm - Row.Dbsm;

        public bool IsWithinTolerance => Math.Abs(Difference) <= Row.ToleranceDb;

        /// <summary>Standard error said, metres.</summary>
        public double Error { get; }

        /// <summary>The same of this amplitude in decibels; infinite or NaN without an echo.</summary>
        public double ErrorDb { get; }

        public long Tubes { get; }

        public long Rays { get; }

        public double Milliseconds { get; }

        public override string ToString() => FormattableString.Invariant($"{Row}: {Dbsm:f3}, error said {Error:g3} m");
    }
}
