using System;
using System.Collections.Generic;
using System.Numerics;
using Glint.Core;
using Glint.Reference;

namespace Glint.Editor
{
    /// <summary>Compares rows of <c>glint rcs</c> with the double-precision reference tracer.</summary>
    sealed class CrossSectionComparison
    {
        static readonly string s_header =
            FormattableString.Invariant($"{"S of the kernels, m",29}{"S in double precision, m",26}{"dB",12}{"|dS|/scale",12}");

        readonly CrossSectionSetup _setup;
        readonly int _max;
        readonly List<CrossSectionRow> _rows = new List<CrossSectionRow>();
        CrossSectionRow _worst;
        double _largest;

        /// <param name="max">The first rows that are compared; 0: none.</param>
        public CrossSectionComparison(CrossSectionSetup setup, int max) => (_setup, _max) = (setup, max);

        /// <summary>Takes a row, if it is one of the first.</summary>
        public void Add(CrossSectionRow row)
        {
            if (_rows.Count < _max)
                _rows.Add(row);
        }

        /// <summary>Computes the rows again, and prints both.</summary>
        /// <exception cref="GlintException">A row differs by more than the tolerance.</exception>
        /// <exception cref="OperationCanceledException">The user stopped it.</exception>
        public void Execute(string name, IProgressSink progress)
        {
            if (_rows.Count == 0)
                return;
            var reference = new ReferenceCrossSection(_setup.Scene, _setup.CreaseDegrees);
            progress.Start("reference", _rows.Count);
            try
            {
                progress.Print(s_header);
                for (int i = 0; i < _rows.Count; i++)
                {
                    progress.Cancel.ThrowIfCancellationRequested();
                    Compare(_rows[i], reference.Compute(_setup.PoseOf(_rows[i].Planned), TubeSettings.Default)[0, 0],
                        progress);
                    progress.Advance(i + 1, null);
                }
            }
            finally
            {
                progress.Finish();
            }
            double allowed = CrossSectionAccuracy.AllowedBy(_setup.ToleranceDb);
            if (!(_largest <= allowed))
                throw new GlintException(FormattableString.Invariant(
                    $"{name}: |dS| beside the reference tracer is {_largest:g3} of its amplitude or the floor at {_worst}; a tolerance of {_setup.ToleranceDb:g4} dB allows {allowed:g3}: the files are written; ask for a smaller {CrossSectionOptions.Tolerance.Flag}, or a larger {CrossSectionOptions.Floor.Flag} for nulls"));
        }

        void Compare(CrossSectionRow row, in ScatteringMatrix other, IProgressSink progress)
        {
            foreach (var polarisation in _setup.Polarisations)
            {
                Complex s = polarisation.Of(row.S), expected = polarisation.Of(other);
                double relative = (s - expected).Magnitude / CrossSectionAccuracy.ScaleOf(s, row.FloorDbsm);
                // Not a number is worse than any.
                if (_worst == null || !(relative <= _largest))
                    (_worst, _largest) = (row, relative);
                string difference = s == Complex.Zero || expected == Complex.Zero
                    ? "-"
                    : FormattableString.Invariant(
                        $"{ScatteringMatrix.Dbsm(s) - ScatteringMatrix.Dbsm(expected):+0.0000;-0.0000;0.0000}");
                progress.Print(FormattableString.Invariant(
                    $"{polarisation.Name.ToUpperInvariant(),-3}{Text(s),26}{Text(expected),26}{difference,12}{relative,12:0.0e+0}  {row}"));
            }
        }

        // A sum with 0 has no negative zeros.
        static string Text(Complex s) => FormattableString.Invariant(
            $"{s.Real + 0.0:0.00000e+0} {s.Imaginary + 0.0:+0.00000e+0;-0.00000e+0}j");
    }
}
