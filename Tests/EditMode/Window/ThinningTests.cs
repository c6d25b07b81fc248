using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ThinningTests
    {
        // A pixel of a chart as wide as most screens: a line within it has only ends, a lowest and a highest point.
        const int Pixels = 480;

        [Test]
        public void Line_OfManyPoints_KeepsTheEndsAndExtremesOfEveryPixel()
        {
            var all = Noise(100000);
            var kept = Thinning.Line(all);
            Assert.That(kept.Count, Is.LessThanOrEqualTo(4 * Pixels));
            Assert.That(kept.Select(point => point.X), Is.Ordered);
            var left = ByPixel(kept);
            foreach (var pixel in ByPixel(all))
            {
                var points = left[pixel.Key].ToArray();
                Assert.That((points.First(), points.Last()), Is.EqualTo((pixel.First(), pixel.Last())));
                Assert.That((points.Min(point => point.Y), points.Max(point => point.Y)),
                    Is.EqualTo((pixel.Min(point => point.Y), pixel.Max(point => point.Y))));
            }
        }

        [Test]
        public void Band_OfManyPoints_CoversTheErrorOfEveryPoint()
        {
            var all = Noise(100000);
            var band = Thinning.Band(all);
            Assert.That(2 * band.Count, Is.LessThanOrEqualTo(4 * Pixels));
            Assert.That((band[0].X, band[band.Count - 1].X), Is.EqualTo((all[0].X, all[all.Count - 1].X)));
            var covers = ByPixel(band);
            foreach (var pixel in ByPixel(all))
                foreach (var end in covers[pixel.Key])
                    Assert.That((end.Lower, end.Upper),
                        Is.EqualTo((pixel.Min(point => point.Lower), pixel.Max(point => point.Upper))));
        }

        [Test]
        public void FewPoints_AreAllDrawn()
        {
            var few = Noise(900);
            Assert.That(Thinning.Line(few), Is.SameAs(few));
            Assert.That(Thinning.Band(few), Is.SameAs(few));
        }

        static ILookup<int, ChartPoint> ByPixel(IEnumerable<ChartPoint> points) =>
            points.ToLookup(point => (int)Math.Min(Pixels - 1, Math.Floor(point.X * Pixels)));

        static List<ChartPoint> Noise(int count)
        {
            var random = new Random(1);
            return Enumerable.Range(0, count).Select(i =>
            {
                double y = random.NextDouble(), error = 0.1 * random.NextDouble();
                return new ChartPoint
                {
                    Row = i, X = i / (count - 1.0), Y = y, Lower = y - error, Upper = y + error
                };
            }).ToList();
        }
    }
}
