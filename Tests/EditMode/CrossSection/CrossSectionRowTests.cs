using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class CrossSectionRowTests
    {
        [Test]
        public void Plan_TakesReceiversFastestThenFrequenciesAzimuthsElevations()
        {
            var plan = new CrossSectionPlan(new double[] { 0, 90 }, new double[] { 5, 10 }, new double[] { 2e9, 1e9 },
                new double[] { 20, 30, 40 }, 5);
            var rows = Enumerable.Range(0, plan.Count).Select(row => plan[row]).ToArray();
            var expected = from elevation in new double[] { 5, 10 }
                           from azimuth in new double[] { 0, 90 }
                           from frequency in new double[] { 1e9, 2e9 }
                           from receiver in new double?[] { 20, 30, 40 }
                           select (elevation, azimuth, frequency, receiver);
            Assert.That(rows.Select(row =>
                    (row.ElevationDegrees, row.AzimuthDegrees, row.Frequency, row.ReceiverAzimuthDegrees)),
                Is.EqualTo(expected));
            Assert.That(rows.Select(row => row.ReceiverElevationDegrees), Is.All.EqualTo(5));
            Assert.That(rows.Select(row => row.Pose), Is.Ordered);
            Assert.That(rows.Last().Pose, Is.EqualTo(plan.Poses - 1));
        }

        [Test]
        public void Plan_OfReceivers_HasThemAtTheElevationOfTheRadar()
        {
            double[] azimuths = { 0, 90 }, frequencies = { 1e9 }, receivers = { 20, 30 };
            var plan = CrossSectionPlan.OfReceivers(azimuths, new double[] { 7 }, frequencies, receivers);
            Assert.That(Enumerable.Range(0, plan.Count).Select(row =>
                    (plan[row].AzimuthDegrees, plan[row].ReceiverAzimuthDegrees, plan[row].ReceiverElevationDegrees)),
                Is.EqualTo(new (double, double?, double?)[] { (0, 20, 7), (0, 30, 7), (90, 20, 7), (90, 30, 7) }));
            Assert.That(() => CrossSectionPlan.OfReceivers(azimuths, new double[] { 0, 5, 10 }, frequencies, receivers),
                Throws.TypeOf<UsageException>().With.Message.EqualTo("there are 3 elevations, and the receivers have "
                    + "that of the radar: give one elevation"));
        }

        [TestCase(1, 1, false)]
        [TestCase(2, 1, true)]
        [TestCase(3, 3, true)]
        [TestCase(2, 3, false)]
        public void Plan_IsASweepOfReceivers_WithAsManyAsDirections(int receivers, int azimuths, bool isSweep) =>
            Assert.That(CrossSectionPlan.OfReceivers(Enumerable.Range(0, azimuths).Select(i => (double)i).ToArray(),
                    new double[] { 0 }, new[] { 1e9, 2e9, 3e9, 4e9 },
                    Enumerable.Range(0, receivers).Select(i => (double)i).ToArray()).IsReceiverSweep,
                Is.EqualTo(isSweep));

        [Test]
        public void Plan_IsReadBackFromAnIdentity()
        {
            foreach (var plan in new[]
            {
                new CrossSectionPlan(new[] { 0, 0.1, 0.1 }, new double[] { -1 }, new[] { 9.4e9 }),
                new CrossSectionPlan(new double[] { 0 }, new double[] { -1 }, new[] { 1e9, 2e9 }, new[] { 7.5 }, 3)
            })
            {
                var identity = new SweepIdentity();
                plan.AddTo(identity);
                var read = CrossSectionPlan.Of(identity);
                Assert.That(read.Count, Is.EqualTo(plan.Count));
                for (int row = 0; row < plan.Count; row++)
                    Assert.That(read[row], Is.EqualTo(plan[row]));
            }
        }

        [Test]
        public void Plan_WithAFrequencyGivenTwice_IsRefused() =>
            Assert.That(() => new CrossSectionPlan(new double[] { 0 }, new double[] { 0 }, new[] { 1e9, 2e9, 1e9 }),
                Throws.TypeOf<UsageException>().With.Message.EqualTo(
                    "the frequency 1000000000 Hz is given twice: give each once"));

        // |S| = 2 m and an error of 1 % of it: 20 log10(1.01) dB. Of 0.1 m the same error is 20 %; of a floor of 1 m2, 2 %. Those
        // of HV and VH are 0.003 m: 1 % of 0.3 m.
        [TestCase("vv", -100, 0.0864275)]
        [TestCase("vv,hh", -100, 1.5836249)]
        [TestCase("vv,hh", 0, 0.1720034)]
        [TestCase("hv", -100, 0.0864275)]
        [TestCase("hv,vh", -100, 1.5836249)]
        public void ErrorInDecibels_IsTheLargestOfThePolarisationsAskedFor(string names, double floor, double expected)
        {
            var s = new ScatteringMatrix { VV = new Complex(0, 2), HH = 0.1, HV = new Complex(0, 0.3), VH = 0.015 };
            var polarisations = Polarisation.Read(names);
            var accuracy = new CrossSectionAccuracy(polarisations, s, 0.02, 0.003, floor);
            Assert.That(accuracy.ErrorDb, Is.EqualTo(expected).Within(1e-6));
        }

        // 95 % are within the tolerance only if the standard error is smaller than it.
        [Test]
        public void Tolerance_IsMetByASmallerStandardError()
        {
            Assert.That(RowOf(0, 0, error: 0.0115 / 2).MeetsTolerance, "half of 0.1 dB");
            Assert.That(RowOf(0, 0, error: 0.0115).MeetsTolerance, Is.False, "0.1 dB");
        }

        // The forward lobe of 0.3 m at 10 GHz is 5.7 degrees wide to either side.
        [TestCase(0, 0, false)]
        [TestCase(0, 119.9, false)]
        [TestCase(0, 120.1, true)]
        [TestCase(10, -112, true)]
        [TestCase(10, 132, true)]
        [TestCase(0, 174, true)]
        [TestCase(0, 174.5, false)]
        [TestCase(0, 180, false)]
        public void BistaticAngle_Above120DegreesButForward_IsOutsidePhysicalOptics(double azimuth, double receiver,
            bool isOutside) => Assert.That(RowOf(azimuth, receiver).IsOutsidePhysicalOptics, Is.EqualTo(isOutside));

        [Test]
        public void Polarisations_AreReadInAnyOrder()
        {
            Assert.That(Polarisation.Read("hh, vv").Select(polarisation => polarisation.Name),
                Is.EqualTo(new[] { "vv", "hh" }));
            Assert.That(Polarisation.Read("all"), Is.EqualTo(Polarisation.All));
            var s = new ScatteringMatrix { VV = 1, HV = 2, VH = 3, HH = 4 };
            Assert.That(Polarisation.All.Select(polarisation =>
                    (polarisation.Name, polarisation.Received, polarisation.Sent, polarisation.Of(s).Real)),
                Is.EqualTo(new[] { ("vv", 0, 0, 1d), ("hv", 1, 0, 2), ("vh", 0, 1, 3), ("hh", 1, 1, 4) }));
        }

        static CrossSectionRow RowOf(double azimuth, double receiver, double error = 0)
        {
            var plan = new CrossSectionPlan(new[] { azimuth }, new double[] { 0 }, new[] { 10e9 }, new[] { receiver });
            return new CrossSectionRow(plan[0], new ScatteringMatrix { VV = 1, HH = 1 }, Polarisation.All)
            {
                Error = error, FloorDbsm = -40, ToleranceDb = 0.1, Radius = 0.15
            };
        }
    }
}
