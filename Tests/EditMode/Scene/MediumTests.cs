using System;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Permittivity and permeability over frequency.</summary>
    public sealed class MediumTests
    {
        [TestCase(1e-3)]
        [TestCase(10e9)]
        [TestCase(1e300)]
        public void Constant_AtAnyFrequency_IsItself(double frequency)
        {
            var (permittivity, permeability) = Medium.Constant(4, 0.4, 1.5, 1.8).At(frequency);
            Assert.That((permittivity.Real, permittivity.Imaginary), Is.EqualTo((4, -0.4)));
            Assert.That((permeability.Real, permeability.Imaginary), Is.EqualTo((1.5, -1.8)));
        }

        [Test]
        public void Table_BetweenTwoFrequencies_IsLinear()
        {
            var medium = Medium.Table(new[]
            {
                new MediumSample(8e9, 4, 0.4, 1, 0), new MediumSample(12e9, 6, 0.2, 2, 1),
                new MediumSample(13e9, 7, 0, 1, 0)
            });
            var (permittivity, permeability) = medium.At(9e9);
            Assert.That(permittivity.Real, Is.EqualTo(4.5).Within(1e-14));
            Assert.That(permittivity.Imaginary, Is.EqualTo(-0.35).Within(1e-14));
            Assert.That(permeability.Real, Is.EqualTo(1.25).Within(1e-14));
            Assert.That(permeability.Imaginary, Is.EqualTo(-0.25).Within(1e-14));
            Assert.That(medium.At(12.5e9).permittivity.Real, Is.EqualTo(6.5).Within(1e-14));
            Assert.That(medium.At(8e9).permittivity.Real, Is.EqualTo(4));
            Assert.That(medium.At(12e9).permittivity.Real, Is.EqualTo(6));
            Assert.That(medium.At(13e9).permittivity.Real, Is.EqualTo(7));
            Assert.That(medium.Frequencies.ToString(), Is.EqualTo("from 8e9 to 1.3e10"));
        }

        [Test]
        public void Table_OfOneFrequency_HasDataThereOnly()
        {
            var medium = Medium.Table(new[] { new MediumSample(10e9, 4, 0.4) });
            Assert.That(medium.At(10e9).permittivity.Real, Is.EqualTo(4));
            Assert.That(medium.Frequencies.Contains(10e9 + 1), Is.False);
        }

        // ITU-R P.2040 gives e'' = 17.98 conductivity / f, f in GHz.
        [TestCase(1)]
        [TestCase(10)]
        public void PowerLaw_HasTheLossOfItsConductivity(double gigahertz)
        {
            var (permittivity, permeability) = Medium.PowerLaw(30, -0.4, 0.15, 1.3, 1e9, 10e9).At(gigahertz * 1e9);
            Assert.That(permittivity.Real, Is.EqualTo(gigahertz == 1 ? 30 : 30 / 2.5118864).Within(1e-6));
            double conductivity = gigahertz == 1 ? 0.15 : 0.15 * 19.9526231;
            Assert.That(-permittivity.Imaginary, Is.EqualTo(17.98 * conductivity / gigahertz).Within(0.05).Percent);
            Assert.That((permeability.Real, permeability.Imaginary), Is.EqualTo((1, 0)));
        }

        [TestCase(4, -0.1, 1, 0, "the relative permittivity e' = 4, e'' = -0.1 has gain: give e'' of 0 or more, as the "
            + "value is e' - j e''")]
        [TestCase(4, 0, 1, -1e-9, "the relative permeability mu' = 1, mu'' = -1E-09 has gain: give mu'' of 0 or more, "
            + "as the value is mu' - j mu''")]
        [TestCase(0, 0, 1, 0, "the relative permittivity e' = 0, e'' = 0 is 0: give e', which is 1 in free space")]
        [TestCase(4, 0, 0, 0, "the relative permeability mu' = 0, mu'' = 0 is 0: give mu', which is 1 in free space")]
        [TestCase(double.NaN, 0, 1, 0, "the relative permittivity e' = NaN, e'' = 0 is not finite: give numbers")]
        [TestCase(4, 0, 1, double.PositiveInfinity,
            "the relative permeability mu' = 1, mu'' = Infinity is not finite: give numbers")]
        public void Constant_ThatNoPassiveMediumHas_IsRefused(double permittivity, double permittivityLoss,
            double permeability, double permeabilityLoss, string message)
        {
            Assert.That(Assert.Throws<GlintException>(() => Medium.Constant(permittivity, permittivityLoss,
                permeability, permeabilityLoss)).Message, Is.EqualTo(message));
            var sample = new MediumSample(1e9, permittivity, permittivityLoss, permeability, permeabilityLoss);
            Assert.That(Assert.Throws<GlintException>(() => Medium.Table(new[] { sample })).Message,
                Is.EqualTo(message));
        }

        [Test]
        public void Table_OutOfOrder_IsRefused()
        {
            Assert.That(Refusal(), Is.EqualTo("the table of a medium is empty: give at least one frequency"));
            Assert.That(Refusal(0), Does.StartWith("the table of a medium has 0 Hz after 0 Hz: give frequencies"));
            Assert.That(Refusal(2e9, 1e9), Is.EqualTo("the table of a medium has 1000000000 Hz after 2000000000 Hz: "
                + "give frequencies above 0 in increasing order"));
            Assert.That(Refusal(2e9, 2e9), Does.Contain("2000000000 Hz after 2000000000 Hz"));
            Assert.That(Refusal(double.NaN), Does.Contain("NaN Hz after 0 Hz"));
            Assert.That(Refusal(double.PositiveInfinity), Does.Contain("Infinity Hz after 0 Hz"));

            string Refusal(params double[] frequencies) => Assert.Throws<GlintException>(() =>
                Medium.Table(Array.ConvertAll(frequencies, frequency => new MediumSample(frequency, 4, 0)))).Message;
        }

        [TestCase(0, 0, 0, 0, 1e9, 2e9)]
        [TestCase(4, 0, -0.1, 0, 1e9, 2e9)]
        [TestCase(4, double.NaN, 0, 0, 1e9, 2e9)]
        [TestCase(4, 0, 0, 0, 0, 2e9)]
        [TestCase(4, 0, 0, 0, 2e9, 1e9)]
        public void PowerLaw_ThatNoPassiveMediumHas_IsRefused(double a, double b, double c, double d, double from,
            double to) =>
            Assert.That(Assert.Throws<GlintException>(() => Medium.PowerLaw(a, b, c, d, from, to)).Message,
                Does.StartWith("the medium e' ").And.Contain("is not valid: give a above 0"));
    }
}
