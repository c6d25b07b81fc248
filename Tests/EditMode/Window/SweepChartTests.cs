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
        // 26, 20 and 6 dB about.
        static readonly PoseFigures[] Turn =
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
            Assert.That((Points(chart)[1].Lower.Y, Points(chart)[1].Upper.Y), Is.EqualTo((0.4, 0.6)), "8 to 12");
            Assert.That(chart.Series.Single().Runs.Count, Is.EqualTo(1));
        }

        [Test]
        public void Decibels_OfNothing_AreAGap()
        {
            var chart = new SweepChart(Turn, SweepAxis.Angle, Quantity.Normalised, true, false);
            var runs = chart.Series.Single().Runs;
            Assert.That(runs.Select(run => string.Join(",", run.Select(point => point.Row))),
                Is.EqualTo(new[] { "0,1", "3" }));
            Assert.That(chart.YTitle, Does.EndWith("dB"));
            // 6.02 to 26.02 dB: from 5 to 30.
            Assert.That((chart.Y.Min, chart.Y.Max), Is.EqualTo((5.0, 30.0)));
            Assert.That(runs[0][1].Y, Is.EqualTo((20 - 5) / 25.0).Within(1e-12));
            Assert.That(runs[0][1].Upper.Y, Is.EqualTo((20 * Math.Log10(12) - 5) / 25).Within(1e-12));
        }

        [Test]
        public void Decibels_OfAnErrorAsLargeAsTheAmplitude_ReachTheFoot()
        {
            var chart = new SweepChart(new[] { SamplePoses.At(0, 10, 15), SamplePoses.At(1, 1e-30) }, SweepAxis.Angle,
                Quantity.Normalised, true, false);
            Assert.That(Points(chart)[0].Lower.Y, Is.Zero);
            Assert.That(Points(chart)[1].Y, Is.Zero, "600 dB below the other");
            Assert.That(chart.Y.Min, Is.GreaterThanOrEqualTo(-100));
        }

        [Test]
        public void Decibels_OfNothingAnywhere_AreAnEmptyChart()
        {
            var chart =
                new SweepChart(new[] { SamplePoses.At(0, 0) }, SweepAxis.Angle, Quantity.Normalised, true, true);
            Assert.That(Points(chart), Is.Empty);
            Assert.That(chart.Y.Ticks, Is.Not.Empty);
            Assert.That(chart.Nearest(0.5, 0.5, 2), Is.Null);
        }

        // A target is seen from above: north is up, and east, 90 degrees of Unity's rotation, to the right.
        [TestCase(0, 0.5, 1)]
        [TestCase(90, 1, 0.5)]
        [TestCase(180, 0.5, 0)]
        [TestCase(-90, 0, 0.5)]
        [TestCase(30, 0.75, 0.9330127)]
        public void Polar_Angles_GrowClockwiseFromTheTop(double angle, double x, double y)
        {
            var chart = new SweepChart(new[] { SamplePoses.At(angle, 10), SamplePoses.At(7, 0) }, SweepAxis.Angle,
                Quantity.Normalised, false, true);
            var point = Points(chart).Single(found => found.Row == 0);
            Assert.That((point.X - x, point.Y - y), Is.EqualTo((0.0, 0.0)).Using<(double, double)>(
                (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-7 ? 0 : 1));
            Assert.That(chart.IsPolar);
        }

        [Test]
        public void Polar_OverRanges_IsCartesian() =>
            Assert.That(new SweepChart(Turn, SweepAxis.Range, Quantity.Normalised, false, true).IsPolar, Is.False);

        [Test]
        public void Series_OfSeveralAxes_AreOneForEachCombinationOfTheOthers()
        {
            var rows = new List<PoseFigures>();
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

        // What a user types in, in any order.
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
            // As far across as up: in a wide chart the one below is nearer.
            Assert.That(chart.Nearest(0.36, 0.18, 4)?.Point.Row, Is.EqualTo(1));
            Assert.That(chart.Nearest(0.36, 0.18, 0.5)?.Point.Row, Is.EqualTo(2));
        }

        [Test]
        public void Chart_OfNoPoses_IsEmptyAndFinite()
        {
            foreach (var quantity in Quantity.All)
                foreach (bool isPolar in new[] { false, true })
                {
                    var chart = new SweepChart(Array.Empty<PoseFigures>(), SweepAxis.Angle, quantity, true, isPolar);
                    Assert.That(chart.Series, Is.Empty);
                    Assert.That(chart.X.Ticks.Concat(chart.Y.Ticks).Select(tick => tick.Position),
                        Is.All.InRange(-1e-9, 1 + 1e-9));
                }
        }

        [Test]
        public void Amplitude_Raw_HasABandOfItsOwnScale()
        {
            // A quarter of the rays: the raw amplitude is a quarter of the normalised, and so is its error.
            var row = new SweepRow(new SweepPose(0),
                new RadarResult(new RadarSums { InPhase = 5, RaysOfPicture = 518400 },
                    new SamplingReport(4, 0, false)));
            var pose = new PoseFigures(new StoredRow(row));
            Assert.That((Quantity.Normalised.Of(pose), Quantity.Normalised.ErrorOf(pose)), Is.EqualTo((20.0, 4.0)));
            Assert.That((Quantity.Amplitude.Of(pose), Quantity.Amplitude.ErrorOf(pose)), Is.EqualTo((5.0, 1.0)));
        }

        [Test]
        public void Phases_OfAPose_AreBarsOfItsRays()
        {
            var sums = new RadarSums { RaysReceived = 50, RaysHit = 60 };
            (sums.PhaseHistogram[0], sums.PhaseHistogram[35]) = (10, 40);
            var result = new RadarResult(sums);
            var chart = new PhaseChart(new PoseFigures(new StoredRow(new SweepRow(new SweepPose(3), result))));
            Assert.That(chart.Heights.Count, Is.EqualTo(36));
            Assert.That((chart.Heights[0], chart.Heights[1], chart.Heights[35]), Is.EqualTo((0.25, 0.0, 1.0)));
            Assert.That(chart.Text, Does.StartWith("3 deg: 50 rays in bins of 10 degrees"));
            Assert.That(new PhaseChart(null).Heights, Is.Empty);
        }

        static SweepChart Chart(IReadOnlyList<PoseFigures> rows, SweepAxis axis) =>
            new SweepChart(rows, axis, Quantity.Normalised, false, false);

        static List<ChartPoint> Points(SweepChart chart) =>
            chart.Series.SelectMany(series => series.Runs).SelectMany(run => run).ToList();
    }
}
