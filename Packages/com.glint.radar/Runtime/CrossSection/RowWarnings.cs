using System;
using System.Collections.Generic;
using Glint.Core;

namespace Glint
{
    /// <summary>Collects what is wrong with the rows of a run, for its end.</summary>
    public sealed class RowWarnings
    {
        CrossSectionRow _worst;
        int _rows, _unmet, _outside;

        /// <summary>Takes the next row.</summary>
        public void Add(CrossSectionRow row)
        {
            _rows++;
            _outside += row.IsOutsidePhysicalOptics ? 1 : 0;
            if (row.MeetsTolerance)
                return;
            _unmet++;
            if (_worst == null || row.Accuracy.ErrorDb > _worst.Accuracy.ErrorDb)
                _worst = row;
        }

        /// <summary>
        /// Warnings of rows whose error remained above the tolerance, and of those outside physical optics.
        /// </summary>
        /// <param name="subject">Name of what was computed.</param>
        /// <param name="toleranceDb">The error asked for, decibels.</param>
        /// <param name="toleranceOrFloor">What a user may set larger: "tolerance or floor".</param>
        public IEnumerable<string> Of(string subject, double toleranceDb, string toleranceOrFloor)
        {
            if (_unmet > 0)
                yield return FormattableString.Invariant(
                    $"{subject}: the tolerance of {toleranceDb:g4} dB was not met in {_unmet} of {_rows} rows (column tolerance_met): the largest standard error reached is {_worst.Accuracy.ErrorDb:g3} dB, at {_worst}; accept it, or ask for a larger {toleranceOrFloor}");
            if (_outside > 0)
                yield return FormattableString.Invariant(
                    $"{subject}: {_outside} of {_rows} rows are outside physical optics, with radar and receiver more than {CrossSectionRow.MaxBistaticDegrees:0} degrees apart (column outside_physical_optics)");
        }
    }
}
