using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ComparisonTests
    {
        static readonly PublishedTable Corner =
            PublishedTable.All.Single(table => table.Name == "table_a2_corner_reflector");

        [Test]
        public void Tables_ThatThePackageOffers_AreAllThere()
        {
            foreach (var table in PublishedTable.All)
            {
                var rows = Comparison.With(table).Rows;
                Assert.That(rows.Count, Is.InRange(10, 46), table.Title);
                Assert.That(rows.All(row => row[table.Axis].HasValue), table.Title);
            }
        }

        // Published at 0 deg: amplitude 46.66582, 676 of 217,470 rays; at 45 deg no rays.
        [Test]
        public void Text_OfKnownDifferences_TellsTheLargestAndTheRootMeanSquare()
        {
            var comparison = Comparison.With(Corner);
            var rows = new[]
            {
                SamplePoses.At(new SweepPose(0), 46.66582 - 3, 0, 676, 217470),
                SamplePoses.At(new SweepPose(45), 1, 0, 4, (long)comparison.Rows[45][ResultColumn.RaysHit]),
                SamplePoses.At(new SweepPose(0.5), 1)
            };
            var lines = comparison.Text(rows).Split('\n');
            Assert.That(lines[0], Does.Contain("2 poses in common"));
            // sqrt((9 + 1) / 2); 3 of 46.67 are 6.43 %.
            Assert.That(lines[1], Does.Contain("at most -3 (-6.43 %) at 0 deg, rms 2.2361"));
            Assert.That(lines[2], Does.Contain("at most +4 at 45 deg, rms 2.8284"));
            Assert.That(lines[3], Is.EqualTo("Rays hit: equal"));
        }

        // The published ship is on one snapshot; ours is on two.
        [Test]
        public void Pairs_WhereTheOtherRunLacksAnAxis_MatchOnTheRest()
        {
            var comparison = Comparison.With(Corner);
            var rows = new[]
            {
                SamplePoses.At(SweepAxis.Angle, 1, SweepAxis.Snapshot, 1),
                SamplePoses.At(SweepAxis.Angle, 1, SweepAxis.Snapshot, 2),
                SamplePoses.At(SweepAxis.Angle, 1.5, SweepAxis.Snapshot, 1)
            };
            Assert.That(comparison.Pairs(rows).Select(pair => pair.Theirs),
                Is.EqualTo(new[] { comparison.Rows[1], comparison.Rows[1] }));
        }

        [Test]
        public void Pairs_WithARunOverWhatWeDoNotStepThrough_AreNone()
        {
            var sea = Comparison.With(PublishedTable.All.Single(table => table.Axis == SweepAxis.Snapshot));
            var rows = new[] { SamplePoses.At(0, 1) };
            Assert.That(sea.Pairs(rows), Is.Empty);
            Assert.That(sea.Text(rows), Does.Contain("no pose in common"));
        }

        [Test]
        public void Comparison_WithAFolder_IsItsRows()
        {
            using (var temporary = new TemporaryFolder())
            {
                using (var folder = ResultsFolder.Open(temporary.PathOf("run")))
                {
                    folder.Append(SampleRun.Row(1));
                    folder.Append(SampleRun.Miss(2));
                    folder.Finish(SampleRun.Info());
                }
                var comparison = Comparison.With(temporary.PathOf("run"));
                Assert.That(comparison.Title, Is.EqualTo("run"));
                // 3 - 4i with twice the rays, then no rays.
                Assert.That(comparison.Rows.Select(
                        row => (row[SweepAxis.Angle], row[ResultColumn.Amplitude], row[ResultColumn.Normalised],
                            row[ResultColumn.RaysReceived])),
                    Is.EqualTo(new (double?, double?, double?, double?)[] { (1, 5, 2.5, 300), (2, 0, 0, 0) }));
                Assert.Throws<GlintException>(() => Comparison.With(temporary.PathOf("nothing")));
            }
        }

        [Test]
        public void Chart_WithARunLaidOver_ShowsBothOnOneScale()
        {
            var comparison = Comparison.With(Corner);
            var chart = new SweepChart(new[] { SamplePoses.At(0, 5), SamplePoses.At(90, 10) }, SweepAxis.Angle,
                ResultColumn.Normalised, false, comparison);
            Assert.That(chart.Series.Select(series => (series.Name, series.IsCompared)),
                Is.EqualTo(new[] { ("", false), (comparison.Title, true) }));
            Assert.That((chart.X.Max, chart.Y.Max), Is.EqualTo((90.0, 50.0)));
            Assert.That(chart.Series[1].Runs.Single()[0].Y, Is.EqualTo(46.66582 / 50).Within(1e-9));
        }
    }
}
