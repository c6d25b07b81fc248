using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class FrequencyGroupsTests
    {
        const double MaxError = 1e-3, TenGigahertz = 1e10;

        static readonly SurfaceMaterial s_sea = new SurfaceMaterial("sea", halfSpace: Medium.SeaWater());

        // Without loss: a quarter wave at 10 GHz and normal incidence.
        static readonly SurfaceMaterial s_layer = new SurfaceMaterial("layer",
            new[] { new MaterialLayer(Medium.Constant(9, 0), Signal.Wavelength(TenGigahertz) / 12) });

        static readonly SurfaceMaterial[] s_materials = { s_sea, s_layer };

        [Test]
        public void Conductors_ShareWithinATenth()
        {
            var groups = GroupsOf(new[] { 1e9, 1.05e9, 1.09e9, 1.11e9, 1.2e9, 1.3e9 },
                SurfaceMaterial.PerfectConductor);
            Assert.That(Enumerable.Range(0, 6).Select(groups.FirstOf), Is.EqualTo(new[] { 0, 0, 0, 3, 3, 5 }));
            Assert.That(groups.Count, Is.EqualTo(3));
        }

        // Compared at other cosines than by the groups; between theirs the difference may be a little larger.
        [TestCaseSource(nameof(s_materials))]
        public void CoefficientsOfTheMiddle_AreGoodForAllFrequenciesAndAngles(SurfaceMaterial material)
        {
            double[] frequencies = EchoBand.Frequencies(9.4e9, 300e6, 100);
            var groups = GroupsOf(frequencies, material);
            for (int i = 0; i < frequencies.Length; i++)
            {
                var group = Enumerable.Range(0, frequencies.Length)
                    .Where(other => groups.FirstOf(other) == groups.FirstOf(i)).ToArray();
                double middle = (frequencies[group.First()] + frequencies[group.Last()]) / 2;
                for (int step = 0; step <= 301; step++)
                {
                    var own = material.Reflection(step / 301.0, frequencies[i]);
                    var shared = material.Reflection(step / 301.0, middle);
                    Assert.That(ErrorOf(own.S, shared.S), Is.LessThan(1.1 * MaxError), $"R_s, {frequencies[i]} Hz");
                    Assert.That(ErrorOf(own.P, shared.P), Is.LessThan(1.1 * MaxError), $"R_p, {frequencies[i]} Hz");
                }
            }
        }

        // Coefficients of sea water change steadily, so that a group spans a change of twice the error: the one that
        // changes most over the band says how many there are.
        [Test]
        public void SeaWater_TakesAsManyTracesAsItsCoefficientsChange()
        {
            double[] frequencies = EchoBand.Frequencies(TenGigahertz, 600e6, 294);
            double change = Enumerable.Range(0, 301).Max(step =>
            {
                var lowest = s_sea.Reflection(step / 300.0, frequencies[0]);
                var highest = s_sea.Reflection(step / 300.0, frequencies.Last());
                return Math.Max(ErrorOf(lowest.S, highest.S), ErrorOf(lowest.P, highest.P));
            });
            double groups = change / (2 * MaxError);
            Assert.That(GroupsOf(frequencies, s_sea).Count, Is.InRange(0.9 * groups, 1.2 * groups + 1));
        }

        // R has the phase of -(1 - z) / (1 + z), z = j tan(x) / n, with x = pi / 2 f / 10 GHz at normal incidence.
        [TestCase(0.5)]
        [TestCase(1)]
        public void Layer_TakesAsManyTracesAsItsPhaseTurns(double part)
        {
            const double Band = 40e6, Steps = 400;
            double turn = Enumerable.Range(1, 300).Max(step =>
            {
                double cosine = step / 300.0, q = Math.Sqrt(8 + cosine * cosine),
                    square = Math.Pow(Math.Tan(0.5 * Math.PI * part * q / 3), 2);
                // By a radian of x.
                double Slope(double n) => 2 * n * q / 3 * (1 + square) / (n * n + square);
                return Math.Max(Slope(q / cosine), Slope(9 * cosine / q));
            });
            var frequencies = Enumerable.Range(0, (int)Steps).Select(i => part * TenGigahertz + Band / Steps * i);
            double groups = turn * 0.5 * Math.PI * Band / TenGigahertz / (2 * MaxError);
            Assert.That(GroupsOf(frequencies.ToArray(), s_layer).Count, Is.InRange(0.9 * groups, 1.2 * groups + 1));
        }

        [Test]
        public void LargerError_TakesFewerTraces()
        {
            double[] frequencies = EchoBand.Frequencies(TenGigahertz, 600e6, 200);
            var counts = new[] { 1e-3, 1e-2, 1e-1 }
                .Select(error => new FrequencyGroups(frequencies, new[] { s_sea, s_layer }, error).Count).ToArray();
            Assert.That(counts[1], Is.LessThan(counts[0]));
            Assert.That(counts[2], Is.LessThan(counts[1]));
        }

        static FrequencyGroups GroupsOf(double[] frequencies, SurfaceMaterial material) =>
            new FrequencyGroups(frequencies, new[] { material }, MaxError);

        static double ErrorOf(Complex own, Complex shared) =>
            Complex.Abs(own - shared) / Math.Max(0.01, Complex.Abs(own));
    }
}
