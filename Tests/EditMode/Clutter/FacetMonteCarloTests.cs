using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>
    /// The Monte Carlo of a sea's facets, 1024 x 1024 in each of four tiles, against the figures of another program
    /// with other random numbers. Sets of four tiles differ by up to 0.1 dB, 0.006 lit and 18 % of a shape.
    /// </summary>
    [Category("Slow")]
    public sealed class FacetMonteCarloTests
    {
        const double Decibels = 0.3, OfLit = 0.01, PercentOfShape = 20;

        FacetMonteCarlo _sea;

        [OneTimeSetUp]
        public void MakeSea() => _sea = new FacetMonteCarlo(10, 1024, 4);

        [TestCase(1, -50.9, -28.7)]
        [TestCase(3, -48.7, -27.2)]
        [TestCase(10, -42.2, -23.1)]
        [TestCase(30, -28.4, -17.1)]
        public void Mean_WithoutShadow_IsThePublishedOne(double grazing, double hh, double vv)
        {
            var sea = _sea.At(grazing);
            AssertNear(sea.HH, hh);
            AssertNear(sea.VV, vv);
        }

        [TestCase(1, 0.163, -55.5, -33.7)]
        [TestCase(3, 0.423, -50.0, -28.8)]
        [TestCase(10, 0.910, -42.2, -23.2)]
        [TestCase(30, 1.000, -28.4, -17.1)]
        public void Mean_WithShadow_IsThePublishedOne(double grazing, double lit, double hh, double vv)
        {
            var sea = _sea.At(grazing);
            Assert.That(sea.LitFraction, Is.EqualTo(lit).Within(OfLit));
            AssertNear(sea.LitHH, hh);
            AssertNear(sea.LitVV, vv);
        }

        // Breaking waves are what returns HH at low grazing; in VV the shape is without them.
        [TestCase(1, -37.7, -32.4, 0.50, 0.64)]
        [TestCase(3, -36.5, -28.2, 0.69, 1.93)]
        [TestCase(10, -35.0, -23.0, 0.92, 10.8)]
        [TestCase(30, -27.7, -17.0, 7.0, 61)]
        public void MeanAndShape_WithBreakingWaves_AreThePublishedOnes(double grazing, double hh, double vv,
            double shapeHH, double shapeVV)
        {
            var sea = _sea.At(grazing);
            AssertNear(sea.BreakingHH, hh);
            AssertNear(sea.BreakingVV, vv);
            Assert.That(sea.ShapeHH, Is.EqualTo(shapeHH).Within(PercentOfShape).Percent);
            Assert.That(sea.ShapeVV, Is.EqualTo(shapeVV).Within(PercentOfShape).Percent);
        }

        // Smith's formula with the slopes of the waves that the facets carry; published 0.174, 0.455 and 0.916.
        [TestCase(1, 0.174)]
        [TestCase(3, 0.455)]
        [TestCase(10, 0.916)]
        public void LitFraction_IsNearSmiths(double grazing, double published)
        {
            double smith = _sea.SmithFraction(grazing);
            Assert.That(smith, Is.EqualTo(published).Within(0.001));
            Assert.That(_sea.At(grazing).LitFraction, Is.EqualTo(smith).Within(0.04));
        }

        static void AssertNear(double sigma, double decibels) =>
            Assert.That(Sigma0.Decibels(sigma), Is.EqualTo(decibels).Within(Decibels));
    }
}
