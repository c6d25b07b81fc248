using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class SweepChartTests
    {
        // About 26, 20 and 6 dB.
        static readonly StoredRow[] Turn =
        {
            SamplePoses.At(0, 20), SamplePoses.At(10, 10, 2), SamplePoses.At(20, 0), SamplePoses.At(40, 2)
        };

        [Test]
        public void Chart_OfAmplitudes_HasThemByAngleFromZero()
        {
            var chart = Chart(Turn, SweepAxis.Angle);
            Assert.That(Points(chart).Select(point => point.X), Is.EqualTo(new[] { 0, 0.25, 0.5, 1 }));
            Assert.That(Points(chart).Select(point => point.Y), Is.EqualTo(new[] { 1, 0.5, 0, 0.1 }).Within(1e-12));
            Assert.That(chart.Y.Ticks.Select(tick => tick.Label), Is.EqualTo(new[] { "0", "5", "10", "15", "20" }));
            Assert.That((Points(chart)[1].Lower, Points(chart)[1].Upper), Is.EqualTo((0.4, 0.6)), "8 to 12");
            Assert.That(chart.Series.Single().Runs.Count, Is.EqualTo(1));
        }

        [Test]
        public void Decibels_OfNothing_AreAGap()
        {
            var chart = new SweepChart(Turn, SweepAxis.Angle, ResultColumn.Normalised, true);
            var runs = chart.Series.Single().Runs;
            Assert.That(runs.Select(run => string.Join(",", run.Select(point => point.Row))),
                Is.EqualTo(new[] { "0,1", "3" }));
            Assert.That(chart.YTitle, Does.EndWith("dB"));
            // 6.02 to 26.02 dB: from 5 to 30.
            Assert.That((chart.Y.Min, chart.Y.Max), Is.EqualTo((5.0, 30.0)));
            Assert.That(runs[0][1].Y, Is.EqualTo((20 - 5) / 25.0).Within(1e-12));
            Assert.That(runs[0][1].Upper, Is.EqualTo((20 * Math.Log10(12) - 5) / 25).Within(1e-12));
        }

        [Test]
        public void Decibels_OfAnErrorAsLargeAsTheAmplitude_ReachTheFoot()
        {
            var chart = new SweepChart(new[] { SamplePoses.At(0, 10, 15), SamplePoses.At(1, 1e-30) }, SweepAxis.Angle,
                ResultColumn.Normalised, true);
            Assert.That(Points(chart)[0].Lower, Is.Zero);
            Assert.That(Points(chart)[1].Y, Is.Zero, "600 dB below the other");
            Assert.That(chart.Y.Min, Is.GreaterThanOrEqualTo(-100));
        }

        [Test]
        public void Decibels_OfNothingAnywhere_AreAnEmptyChart()
        {
            var chart =
                new SweepChart(new[] { SamplePoses.At(0, 0) }, SweepAxis.Angle, ResultColumn.Normalised, true);
            Assert.That(Points(chart), Is.Empty);
            Assert.That(chart.Y.Ticks, Is.Not.Empty);
            Assert.That(chart.Nearest(0.5, 0.5, 2), Is.Null);
        }

        [Test]
        public void Series_OfSeveralAxes_AreOneForEachCombinationOfTheOthers()
        {
            var rows = new List<StoredRow>();
            var plan = new SweepPlan((SweepAxis.Angle, new double[] { 0, 90, 180 }),
                (SweepAxis.Grazing, new double[] { 2, 5 }), (SweepAxis.Frequency, new[] { 9e9, 10e9 }));
            for (int i = 0; i < plan.Count; i++)
                rows.Add(SamplePoses.At(plan[i], i));
            var over = Chart(rows, SweepAxis.Angle);
            Assert.That(over.Series.Select(series => series.Name), Is.EqualTo(new[] { "9000000000 Hz, grazing 2 deg",
                "9000000000 Hz, grazing 5 deg", "10000000000 Hz, grazing 2 deg", "10000000000 Hz, grazing 5 deg" }));
            Assert.That(over.Series[1].Runs.Single().Select(point => point.Row), Is.EqualTo(new[] { 3, 4, 5 }));
            var frequencies = Chart(rows, SweepAxis.Frequency);
            Assert.That(frequencies.Series.Count, Is.EqualTo(6));
            Assert.That((frequencies.X.Min, frequencies.X.Max, frequencies.XTitle),
                Is.EqualTo((9.0, 10.0, "Frequency, GHz")));
            Assert.That(SweepChart.AxesOf(rows),
                Is.EqualTo(new[] { SweepAxis.Angle, SweepAxis.Grazing, SweepAxis.Frequency }));
        }

        [Test]
        public void Series_BeyondADozen_AreCounted()
        {
            var rows = Enumerable.Range(0, 60)
                .Select(i => SamplePoses.At(SweepAxis.Angle, i % 3, SweepAxis.Snapshot, 1 + i / 3)).ToArray();
            var chart = Chart(rows, SweepAxis.Angle);
            Assert.That((chart.Series.Count, chart.LeftOut), Is.EqualTo((12, 8)));
        }

        // User input in any order.
        [Test]
        public void Points_OfAnglesInAnyOrder_RunAlongTheAxis()
        {
            var chart =
                Chart(new[] { SamplePoses.At(10, 1), SamplePoses.At(-10, 2), SamplePoses.At(0, 3) }, SweepAxis.Angle);
            Assert.That(Points(chart).Select(point => point.Row), Is.EqualTo(new[] { 1, 2, 0 }));
        }

        [Test]
        public void Nearest_ToAPlace_IsThatWhichTheEyeTakes()
        {
            var chart = Chart(Turn, SweepAxis.Angle);
            Assert.That(chart.Nearest(0.3, 0.5, 2)?.Point.Row, Is.EqualTo(1));
            Assert.That(chart.Nearest(0.9, 0, 2)?.Point.Row, Is.EqualTo(3));
            // Equally far across and up: in a wide chart the point below is nearer.
            Assert.That(chart.Nearest(0.36, 0.18, 4)?.Point.Row, Is.EqualTo(1));
            Assert.That(chart.Nearest(0.36, 0.18, 0.5)?.Point.Row, Is.EqualTo(2));
        }

        [Test]
        public void Chart_OfNoPoses_IsEmptyAndFinite()
        {
            foreach (var column in ResultColumn.All)
            {
                var chart = new SweepChart(Array.Empty<StoredRow>(), SweepAxis.Angle, column, true);
                Assert.That(chart.Series, Is.Empty);
                Assert.That(chart.X.Ticks.Concat(chart.Y.Ticks).Select(tick => tick.Position),
                    Is.All.InRange(-1e-9, 1 + 1e-9));
            }
        }

        [Test]
        public void Chart_OfWhatWasNotEstimated_SaysSoAndHasNoLine()
        {
            var rows = new[] { SamplePoses.NotEstimated(0, 5), SamplePoses.NotEstimated(10, 6) };
            var errors = new SweepChart(rows, SweepAxis.Angle, ResultColumn.SamplingError, false);
            Assert.That(errors.YTitle, Is.EqualTo("Sampling error: not estimated"));
            Assert.That(Points(errors), Is.Empty);
            var amplitudes = Chart(rows, SweepAxis.Angle);
            Assert.That(Points(amplitudes).All(point => point.Lower == point.Upper), "no band");
            Assert.That(rows[0].Text(), Does.Contain("sampling error not estimated").And.Not.Contain("undersampled"));
        }

        [Test]
        public void Chart_OfValuesBelowZero_HasThemAll()
        {
            var rows = new[] { SamplePoses.At(0, -5), SamplePoses.At(10, -3) };
            var inPhase = ResultColumn.All.Single(column => column.Name == "in_phase");
            var chart = new SweepChart(rows, SweepAxis.Angle, inPhase, true);
            Assert.That((chart.Y.Max, Points(chart).Min(point => point.Y) >= 0), Is.EqualTo((0.0, true)));
            Assert.That(Points(chart)[1].Y, Is.GreaterThan(Points(chart)[0].Y));
        }

        static SweepChart Chart(IReadOnlyList<StoredRow> rows, SweepAxis axis) =>
            new SweepChart(rows, axis, ResultColumn.Normalised, false);

        static List<ChartPoint> Points(SweepChart chart) =>
            chart.Series.SelectMany(series => series.Runs).SelectMany(run => run).ToList();
    }
}
