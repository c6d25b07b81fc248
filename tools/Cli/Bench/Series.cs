using System;
using System.Collections.Generic;
using System.Linq;

namespace Glint.Cli;

/// <summary>Measurements of one thing.</summary>
sealed class Series
{
    readonly List<double> _values = [];

    public Series(params IEnumerable<double> values) => _values.AddRange(values);

    public int Count => _values.Count;

    /// <summary>Median; NaN without values.</summary>
    public double Median
    {
        get
        {
            if (Count == 0)
                return double.NaN;
            var sorted = _values.Order().ToArray();
            return (sorted[(Count - 1) / 2] + sorted[Count / 2]) / 2;
        }
    }

    /// <summary>NaN when there are none.</summary>
    public double Mean => Count == 0 ? double.NaN : _values.Average();

    /// <summary>NaN when there are none.</summary>
    public double GeometricMean => Count == 0 ? double.NaN : Math.Exp(_values.Average(Math.Log));

    /// <summary>NaN when there are none.</summary>
    public double Lowest => Count == 0 ? double.NaN : _values.Min();

    /// <summary>NaN when there are none.</summary>
    public double Highest => Count == 0 ? double.NaN : _values.Max();

    public void Add(double value) => _values.Add(value);
}
