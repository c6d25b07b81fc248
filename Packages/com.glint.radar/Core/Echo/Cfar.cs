using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>What a CFAR detector takes for the level of noise and clutter.</summary>
    public enum CfarLevel
    {
        /// <summary>CA-CFAR: the mean of the reference cells.</summary>
        Mean,

        /// <summary>
        /// OS-CFAR: the reference cell at three quarters of their order. Other targets change it little.
        /// </summary>
        Rank
    }

    /// <summary>
    /// A detector of constant false-alarm rate behind a square-law detector. The rate holds where the powers of a cell
    /// and of its reference cells are exponentially distributed with the same mean; it rises in spiky clutter.
    /// </summary>
    public sealed class Cfar
    {
        const double RankPart = 0.75;
        const int MaxCells = 200, MaxDistance = 1 << 16;

        readonly CfarLevel _level;
        readonly double _falseAlarmRate;
        readonly int _reference, _guard, _referenceRows, _guardRows, _step, _rowStep;

        // By the number of reference cells, 0 where not computed yet.
        readonly double[] _factors;

        // Of the cell that is tested.
        readonly double[] _referenceCells;

        /// <param name="falseAlarmRate">False alarms a cell.</param>
        /// <param name="reference">Reference cells on each side, along a row, at most 200.</param>
        /// <param name="guard">
        /// Cells between the tested one and those, on each side: at least the width of a target's main lobe.
        /// </param>
        /// <param name="referenceRows">Rows of reference cells on each side, in a map.</param>
        /// <param name="guardRows">Rows between the tested cell's and those.</param>
        /// <param name="step">
        /// Cells from a reference cell to the next one of a row: at least those over which noise is correlated.
        /// </param>
        /// <param name="rowStep">Rows from one with reference cells to the next one, likewise.</param>
        /// <exception cref="GlintException">A number is out of its range.</exception>
        public Cfar(CfarLevel level, double falseAlarmRate, int reference, int guard, int referenceRows = 0,
            int guardRows = 0, int step = 1, int rowStep = 1)
        {
            var cells = Interval.Closed(0, MaxCells);
            Require.Within("CFAR", "false-alarm rate", falseAlarmRate, "", Interval.Closed(1e-12, 0.5));
            Require.Count("CFAR", "number of reference cells on a side", reference, MaxCells);
            Require.Within("CFAR", "number of guard cells on a side", guard, "", Interval.Closed(0, MaxDistance));
            Require.Count("CFAR", "cells from a reference cell to the next", step, MaxDistance);
            Require.Count("CFAR", "rows from a reference cell to the next", rowStep, MaxDistance);
            Require.Within("CFAR", "number of reference rows on a side", referenceRows, "", cells);
            Require.Within("CFAR", "number of guard rows on a side", guardRows, "", cells);
            (_level, _falseAlarmRate) = (level, falseAlarmRate);
            (_reference, _guard, _step) = (reference, guard, step);
            (_referenceRows, _guardRows, _rowStep) = (referenceRows, guardRows, rowStep);
            int width = 2 * (reference + guard) + 1, height = 2 * (referenceRows + guardRows) + 1;
            _factors = new double[width * height + 1];
            _referenceCells = new double[width * height];
        }

        /// <summary>The threshold as a multiple of the level, for this number of reference cells.</summary>
        public static double Factor(CfarLevel level, int cells, double falseAlarmRate)
        {
            if (level == CfarLevel.Mean)
                return cells * (Math.Pow(falseAlarmRate, -1.0 / cells) - 1);
            // Rohling, IEEE Trans. AES-19 (1983) 608: the rate is the product of (N - i) / (N - i + factor), i below
            // the rank. It falls as the factor grows.
            double smallest = 0, largest = 1;
            while (RankRate(cells, largest) > falseAlarmRate)
                largest *= 2;
            for (int halvings = 0; halvings < 60; halvings++)
            {
                double middle = (smallest + largest) / 2;
                (smallest, largest) = RankRate(cells, middle) > falseAlarmRate ? (middle, largest) : (smallest, middle);
            }
            return largest;
        }

        /// <summary>
        /// Indices of the cells whose power is above the threshold that the cells around them give. Cells near an edge
        /// have fewer reference cells and a higher threshold; one without any is not detected.
        /// </summary>
        /// <param name="power">Row by row: a profile is one row.</param>
        /// <param name="columns">Cells of a row.</param>
        /// <exception cref="GlintException">The cells do not fill their rows.</exception>
        public List<int> Detect(double[] power, int columns)
        {
            if (columns < 1 || power.Length % columns != 0)
                throw new GlintException($"CFAR: {power.Length} cells do not fill rows of {columns}");
            var detected = new List<int>();
            for (int index = 0; index < power.Length; index++)
                if (power[index] > Threshold(power, columns, index))
                    detected.Add(index);
            return detected;
        }

        /// <summary>The threshold of a cell; infinite without reference cells.</summary>
        /// <inheritdoc cref="Detect" path="/param"/>
        public double Threshold(double[] power, int columns, int index)
        {
            int count = Gather(power, columns, index);
            return count > 0 ? FactorOf(count) * Level(count) : double.PositiveInfinity;
        }

        // Copies the reference cells of a cell: those of the rectangle around it that are not in the guard rectangle,
        // at the steps.
        int Gather(double[] power, int columns, int index)
        {
            int row = index / columns, column = index % columns, rows = power.Length / columns,
                height = (_guardRows + _referenceRows * _rowStep) / _rowStep * _rowStep,
                between = _guard + 1 - _step, count = 0;
            void Take(int x, int y)
            {
                if (x >= 0 && x < columns)
                    _referenceCells[count++] = power[y * columns + x];
            }

            for (int y = row - height; y <= row + height; y += _rowStep)
            {
                if (y < 0 || y >= rows)
                    continue;
                for (int offset = _guard + 1; offset <= _guard + _reference * _step; offset += _step)
                {
                    Take(column - offset, y);
                    Take(column + offset, y);
                }
                // Above and below the guard rectangle.
                for (int x = column - between; Math.Abs(y - row) > _guardRows && x <= column + between; x += _step)
                    Take(x, y);
            }
            return count;
        }

        double Level(int count)
        {
            if (_level == CfarLevel.Rank)
            {
                Array.Sort(_referenceCells, 0, count);
                return _referenceCells[RankOf(count) - 1];
            }
            double sum = 0;
            for (int i = 0; i < count; i++)
                sum += _referenceCells[i];
            return sum / count;
        }

        double FactorOf(int count)
        {
            if (_factors[count] == 0)
                _factors[count] = Factor(_level, count, _falseAlarmRate);
            return _factors[count];
        }

        static int RankOf(int cells) => (int)Math.Ceiling(RankPart * cells);

        static double RankRate(int cells, double factor)
        {
            double rate = 1;
            for (int i = 0; i < RankOf(cells); i++)
                rate *= (cells - i) / (cells - i + factor);
            return rate;
        }
    }
}
