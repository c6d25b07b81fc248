using System;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ChartChoiceTests
    {
        [Test]
        public void Axis_ThatTheRunDoesNotStepThrough_IsTheFastest()
        {
            var rows = new[]
            {
                SamplePoses.At(SweepAxis.Angle, 0, SweepAxis.Range, 50),
                SamplePoses.At(SweepAxis.Angle, 0, SweepAxis.Range, 60)
            };
            Assert.That(new ChartChoice { Axis = "angle" }.AxisOf(rows), Is.EqualTo(SweepAxis.Range));
            Assert.That(new ChartChoice { Axis = "range" }.AxisOf(rows), Is.EqualTo(SweepAxis.Range));
            Assert.That(new ChartChoice().AxisOf(Array.Empty<StoredRow>()), Is.EqualTo(SweepAxis.Angle));
        }

        // A choice is kept for the next run.
        [TestCase(-1, 1)]
        [TestCase(0, 0)]
        [TestCase(2, 1)]
        public void Pose_ThatTheRunDoesNotHave_IsTheStrongest(int chosen, int shown)
        {
            var rows = new[] { SamplePoses.At(0, 1), SamplePoses.At(1, 3) };
            var choice = new ChartChoice { Pose = chosen };
            Assert.That(choice.Chosen(rows), Is.SameAs(rows[shown]));
            Assert.That(choice.Chosen(Array.Empty<StoredRow>()), Is.Null);
        }

        [Test]
        public void Column_ThatIsNoAmplitude_IsNeverInDecibels()
        {
            var rows = Enumerable.Range(0, 3).Select(i => SamplePoses.At(new SweepPose(i), i, 0, 7, 100)).ToArray();
            var choice = new ChartChoice { InDecibels = true };
            Assert.That(choice.Chart(rows, null).YTitle, Is.EqualTo("Amplitude, normalised, dB"));
            choice.Column = "Rays hit";
            Assert.That((choice.Chart(rows, null).YTitle, choice.Chart(rows, null).Y.Max),
                Is.EqualTo(("Rays hit", 100.0)));
            choice.Column = "Path length";
            Assert.That(choice.Chart(rows, null).YTitle, Is.EqualTo("Path length, m"));
            choice.Column = "of another version";
            Assert.That(choice.Chart(rows, null).YTitle, Does.StartWith("Amplitude, normalised"));
        }
    }
}
