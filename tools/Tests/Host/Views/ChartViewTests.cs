using System;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Editor.Views;
using Glint.Tests;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Host.Tests;

/// <summary>What a chart asks UI Toolkit to draw.</summary>
public sealed class ChartViewTests
{
    // A stroke takes 4 to 8 vertices a point, and UI Toolkit draws no path of more than 65,535.
    const int MaxPoints = 2000;

    [TestCase(20000)]
    [TestCase(100000)]
    public void Paths_OfAChartOfManyPoses_AreShort(int count)
    {
        StoredRow[] poses = Enumerable.Range(0, count)
            .Select(i => SamplePoses.At(i * 0.001, 5 + Math.Sin(i), 0.5)).ToArray();
        Painter2D painter = Paint(poses, SweepAxis.Angle);
        Assert.That(painter.Fills, Is.EqualTo(1), "the band of the error");
        Assert.That(painter.LongestPath, Is.InRange(480, MaxPoints));
    }

    // Every other amplitude is 0, which has no decibels: each pose is a run of its own, and each is undersampled.
    [Test]
    public void Paths_OfManySinglePoses_AreNotOneForEachPose()
    {
        StoredRow[] poses = Enumerable.Range(0, 20000).Select(i => new StoredRow(
            (ResultColumn.Of(SweepAxis.Angle), i * 0.001), (ResultColumn.Normalised, i % 2),
            (ResultColumn.Undersampled, 1))).ToArray();
        Painter2D painter = Paint(poses, SweepAxis.Angle, true);
        Assert.That(painter.Strokes + painter.Fills, Is.InRange(480, 2 * MaxPoints + 20));
    }

    static Painter2D Paint(StoredRow[] poses, SweepAxis axis, bool inDecibels = false)
    {
        var view = new ChartView { Size = new Rect(0, 0, 400, 200) };
        view.Show(new SweepChart(poses, axis, ResultColumn.Normalised, inDecibels), null);
        return view.Paint();
    }
}
