using System;
using System.Collections.Generic;
using Glint.Core;

namespace Glint
{
    /// <summary>Collects what is wrong with the rows of a run, for its end.</summary>
    public sealed class RowWarnings
    {
        PlannedCrossSection _worst;
        double _worstError;
        int _rows, _unmet, _outside;

        /// <summary>Takes the next row.</summary>
        public void Add(CrossSectionRow row) =>
            Add(row.MeetsTolerance, row.IsOutsidePhysicalOptics, row.Accuracy.ErrorDb, row.Planned);

        /// <summary>Takes a row of a run that is resumed or merged.</summary>
        public void Add(StoredRow row) => Add(row[CrossSectionColumn.ToleranceMet] != 0,
            row[CrossSectionColumn.OutsidePhysicalOptics] == 1, row[CrossSectionColumn.ErrorDb] ?? 0,
            PlannedCrossSection.Of(row));

        void Add(bool isMet, bool isOutside, double errorDb, in PlannedCrossSection planned)
        {
            _rows++;
            _outside += isOutside ? 1 : 0;
            if (isMet)
                return;
            if (_unmet++ == 0 || errorDb > _worstError)
                (_worst, _worstError) = (planned, errorDb);
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
                    $"{subject}: the tolerance of {toleranceDb:g4} dB was not met in {_unmet} of {_rows} rows (column tolerance_met): the largest standard error reached is {_worstError:g3} dB, at {_worst}; accept it, or ask for a larger {toleranceOrFloor}");
            if (_outside > 0)
                yield return FormattableString.Invariant(
                    $"{subject}: {_outside} of {_rows} rows are outside physical optics, with radar and receiver more than {CrossSectionRow.MaxBistaticDegrees:0} degrees apart (column outside_physical_optics)");
        }
    }
}
