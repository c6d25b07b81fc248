using System;
using System.Linq;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ChartScaleTests
    {
        [TestCase(0, 46.7, "0,10,20,30,40,50")]
        [TestCase(0, 217470, "0,50,000,100,000,150,000,200,000,250,000")]
        [TestCase(-13, 26, "-20,-10,0,10,20,30")]
        [TestCase(0, 0.0031, "0,0.001,0.002,0.003,0.004")]
        public void Around_Values_HasRoundTicksBeyondThem(double min, double max, string labels)
        {
            var scale = ChartScale.Around(min, max);
            Assert.That(string.Join(",", scale.Ticks.Select(tick => tick.Label)), Is.EqualTo(labels));
            Assert.That((scale.Ticks.First().Position, scale.Ticks.Last().Position), Is.EqualTo((0.0, 1.0)));
        }

        [TestCase(0, 45, "0,10,20,30,40")]
        [TestCase(9.4, 10, "9.4,9.5,9.6,9.7,9.8,9.9,10")]
        [TestCase(1, 10, "2,4,6,8,10")]
        public void Over_Values_EndsAtThem(double min, double max, string labels)
        {
            var scale = ChartScale.Over(min, max);
            Assert.That((scale.Min, scale.Max), Is.EqualTo((min, max)));
            Assert.That(string.Join(",", scale.Ticks.Select(tick => tick.Label)), Is.EqualTo(labels));
            Assert.That(scale.Ticks.Select(tick => tick.Position), Is.All.InRange(-1e-9, 1 + 1e-9));
        }

        // Every step is 1, 2 or 5 times a power of ten, and a chart has a few ticks for any values.
        [Test]
        public void Ticks_OfAnyValues_AreFewRoundAndFinite()
        {
            var random = new Random(7);
            for (int i = 0; i < 2000; i++)
            {
                double min = (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-30, 30)),
                    max = min + Math.Abs(min) * Math.Pow(10, random.Next(-8, 8)) * random.NextDouble();
                foreach (var scale in new[] { ChartScale.Over(min, max), ChartScale.Around(min, max) })
                {
                    string what = $"{min:r} to {max:r}";
                    Assert.That(scale.Ticks.Count, Is.InRange(2, 11), what);
                    Assert.That(scale.Ticks.Select(tick => tick.Position),
                        Is.Ordered.And.All.InRange(-1e-6, 1 + 1e-6), what);
                    double step = (scale.Max - scale.Min) * (scale.Ticks[1].Position - scale.Ticks[0].Position),
                        mantissa = step / Math.Pow(10, Math.Floor(Math.Log10(step) + 1e-3));
                    Assert.That(new[] { 1.0, 2, 5 }.Min(round => Math.Abs(mantissa / round - 1)),
                        Is.LessThan(1e-3), what);
                    Assert.That((scale.Of(min), scale.Of(max)),
                        Is.EqualTo((Math.Max(scale.Of(min), -1e-6), Math.Min(scale.Of(max), 1 + 1e-6))), what);
                }
            }
        }

        [TestCase(0)]
        [TestCase(5)]
        [TestCase(-1e12)]
        public void Scale_OfOneValue_HasItInside(double value)
        {
            Assert.That(ChartScale.Over(value, value).Of(value), Is.EqualTo(0.5).Within(1e-9));
            Assert.That(ChartScale.Around(value, value).Of(value), Is.InRange(0.2, 0.8));
        }
    }
}
