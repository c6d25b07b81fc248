using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using static Glint.Cli.TableText;

namespace Glint.Cli;

/// <summary>An axis of values: the position of each, from 0 at the foot to 1 at the head, and the labels.</summary>
sealed class ValueScale
{
    readonly Func<double, double> _position;

    ValueScale(Func<double, double> position, IEnumerable<(double value, string label)> marks)
    {
        _position = position;
        Marks = [.. marks.Select(mark => (Of(mark.value), mark.label))];
    }

    /// <summary>Positions and labels of the marks.</summary>
    public IReadOnlyList<(double Position, string Label)> Marks { get; }

    /// <summary>Position of a value; NaN if it cannot be shown.</summary>
    public double Of(double value) => _position(value);

    /// <summary>Linear, from 0.</summary>
    public static ValueScale Linear(double greatest)
    {
        double step = Step(greatest), end = Math.Max(step, Math.Ceiling(greatest / step) * step);
        return new ValueScale(value => value / end,
            Enumerable.Range(0, (int)Math.Round(end / step) + 1).Select(i => (i * step, Text($"{i * step:#,0.##}"))));
    }

    /// <summary>Logarithmic for whole numbers, with 0 a decade below 1.</summary>
    public static ValueScale Counts(double greatest)
    {
        int decades = Math.Max(1, (int)Math.Ceiling(Math.Log10(Math.Max(1, greatest))));
        return new ValueScale(value => value < 1 ? 0 : (1 + Math.Log10(value)) / (1 + decades),
            Enumerable.Range(0, decades + 1).Select(power => Math.Pow(10, power)).Prepend(0)
                .Select(count => (count, Text($"{count:#,0}"))));
    }

    /// <summary>Amplitudes in decibels. Values below the lowest mark are shown at the foot; 0 is not shown.</summary>
    public static ValueScale Decibels(double greatest)
    {
        const int lowest = -20, step = 20;
        int highest = Math.Max(0, step * (int)Math.Ceiling((Signal.Decibels(greatest) ?? lowest) / step));
        return new ValueScale(value => Signal.Decibels(value) is double decibels ? Math.Max(0,
            (decibels - lowest) / (highest - lowest)) : double.NaN,
            Enumerable.Range(0, (highest - lowest) / step + 1).Select(i => lowest + step * i)
                .Select(decibels => (Math.Pow(10, decibels / 20.0), Text($"{decibels}"))));
    }

    // Steps of 1, 2 or 5 times a power of ten, three to seven of them.
    static double Step(double greatest)
    {
        if (!(greatest > 0))
            return 1;
        double power = Math.Pow(10, Math.Floor(Math.Log10(greatest)));
        return power * (greatest / power < 1.5 ? 0.2 : greatest / power < 3.5 ? 0.5 : greatest / power < 7 ? 1 : 2);
    }
}
