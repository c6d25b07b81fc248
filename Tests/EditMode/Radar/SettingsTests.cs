using System;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class SettingsTests
    {
        [Test]
        public void Default_IsThePublishedExperiment()
        {
            var settings = RadarSettings.Default;
            settings.Validate("radar");
            Assert.That(settings.RayCount, Is.EqualTo(2073600));
            Assert.That(settings.Wavelength, Is.EqualTo(0.0299792458).Within(1e-15));
        }

        [TestCase(0)]
        [TestCase(-1e9)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(1e300)]
        public void Validate_FrequencyThatNoRadarHas_IsRefusedByName(double frequency)
        {
            var settings = RadarSettings.Default;
            settings.FrequencyHz = frequency;
            AssertRefused(() => settings.Validate("radar 'X'"), "radar 'X'", "frequency");
        }

        [TestCase(0, 1080, "across")]
        [TestCase(1920, -1, "down")]
        [TestCase(RadarSettings.RaysPerAxisLimit + 1, 1, "across")]
        public void Validate_RaysOutOfRange_AreRefusedByName(int across, int down, string axis)
        {
            var settings = RadarSettings.Default;
            (settings.RaysAcross, settings.RaysDown) = (across, down);
            AssertRefused(() => settings.Validate("radar 'X'"), "radar 'X'", axis);
        }

        [TestCase(0)]
        [TestCase(17)]
        public void Validate_BouncesOutOfRange_AreRefused(int bounces)
        {
            var settings = RadarSettings.Default;
            settings.MaxBounces = bounces;
            AssertRefused(() => settings.Validate("radar 'X'"), "bounces", bounces.ToString(), "1 to 16");
        }

        [TestCase(0)]
        [TestCase(180)]
        [TestCase(double.NaN)]
        public void Validate_FieldOfViewThatIsNone_IsRefused(double fov)
        {
            var view = TestRadar.LookAt(0, new double3(0, 0, 1), fov);
            AssertRefused(() => view.Validate("radar 'X'"), "field of view", "below 180");
        }

        [TestCase(0, 3)]
        [TestCase(3, -3)]
        [TestCase(double.PositiveInfinity, 3)]
        public void Validate_ReceiverWithoutArea_IsRefused(double width, double height)
        {
            var view = TestRadar.LookAt(0, new double3(0, 0, 1));
            view.ReceiverSize = new double2(width, height);
            AssertRefused(() => view.Validate("radar 'X'"), "receiver size");
        }

        [TestCase(1e30)]
        [TestCase(double.NaN)]
        public void Validate_CameraBeyondWhatFloatsCanPlace_IsRefused(double x)
        {
            var view = TestRadar.LookAt(0, new double3(0, 0, 1));
            view.Position.x = x;
            AssertRefused(() => view.Validate("radar 'X'"), "camera", "10000000 m");
        }

        static void AssertRefused(Action validate, params string[] fragments)
        {
            string message = Assert.Throws<GlintException>(() => validate()).Message;
            foreach (string fragment in fragments)
                Assert.That(message, Does.Contain(fragment));
        }
    }
}
