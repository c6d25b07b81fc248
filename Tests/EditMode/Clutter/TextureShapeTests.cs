using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>
    /// Shapes of the texture of VV against those measured (Ward, Baker and Watts 1990), under the conditions of the page
    /// clutter.md: a fetch of 200 km, and swell of 2 m and 10 s at 45 degrees to the wind and to the radar, where the
    /// measured shape is that without swell. A tile of 512 m in facets of 1 m. At 10 degrees across the wind the sea of 7
    /// and 10 m/s is too even.
    /// </summary>
    public sealed class TextureShapeTests
    {
        const double SwellDegrees = 45;

        [TestCase(7, 1)]
        [TestCase(10, 1)]
        [TestCase(15, 0)]
        public void ShapeVV_IsWithinAFactorOfThree_ButForOneRowOfWeakWinds(double wind, int tooEven)
        {
            var settings = SeaSettings.Default;
            (settings.WindSpeed, settings.Fetch, settings.GridSize, settings.Cells) = (wind, 200e3, 512, 512);
            (settings.SwellHeight, settings.SwellPeriod, settings.SwellDirectionDegrees) = (2, 10, SwellDegrees);
            var sea = new TextureMonteCarlo(settings);
            double[] factors = new[] { false, true }.SelectMany(isCross => new[] { 2, 5, 10.0 }.Select(grazing =>
            {
                double ratio = sea.At(grazing, isCross).VV / ClutterStatistics.EmpiricalShape(grazing,
                    TextureMonteCarlo.Down * TextureMonteCarlo.Across, false, SwellDegrees);
                TestContext.WriteLine(FormattableString.Invariant(
                    $"{(isCross ? "across" : "against")}, {grazing} deg: {ratio:0.00}"));
                return Math.Max(ratio, 1 / ratio);
            })).OrderBy(factor => factor).ToArray();
            Assert.That(factors.Count(factor => factor > 3), Is.AtMost(tooEven));
            Assert.That(factors.Last(), Is.LessThan(tooEven > 0 ? 4 : 3));
            Assert.That((factors[2] + factors[3]) / 2, Is.LessThan(2), "median");
        }
    }
}
