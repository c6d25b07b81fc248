using System;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class StoredSeasTests
    {
        [Test]
        public void SeaStates_DifferInTheirHeightOnly()
        {
            SeaSettings calm = StoredSeas.SeaState5.Settings, rough = StoredSeas.SeaState6.Settings;
            Assert.That((calm.SignificantWaveHeight, rough.SignificantWaveHeight),
                Is.EqualTo((2.5, 6.0)), "metres, as published");
            Assert.That(SeaState.Range(5).From, Is.EqualTo(2.5));
            Assert.That(SeaState.Range(6).To, Is.EqualTo(6));
            // The factor is a ratio of rounded heights.
            Assert.That(calm.HeightFactor, Is.EqualTo(rough.HeightFactor).Within(1e-14));
            (calm.SignificantWaveHeight, calm.HeightFactor) = (rough.SignificantWaveHeight, rough.HeightFactor);
            Assert.That(calm, Is.EqualTo(rough));
        }

        [Test]
        public void Times_AreTen_FarEnoughApartForOtherWaves()
        {
            Assert.That(StoredSeas.SeaState6.Times.Count, Is.EqualTo(10));
            var surface = new SeaSurface(StoredSeas.SeaState6.Settings);
            var snapshots =
                StoredSeas.SeaState6.Times.Select(time => SeaFields.Heights(surface.Mesh(time), 94)).ToArray();
            for (int i = 0; i < snapshots.Length; i++)
                for (int j = 0; j < i; j++)
                    Assert.That(Math.Abs(Correlation(snapshots[i], snapshots[j])), Is.LessThan(0.9),
                        $"snapshots {i} and {j}");
        }

        [Test]
        public void Snapshots_AllHaveTheHeightThatWasAskedFor([Values(2.5, 6)] double height)
        {
            var settings = height == 6 ? StoredSeas.SeaState6.Settings : StoredSeas.SeaState5.Settings;
            var surface = new SeaSurface(settings);
            foreach (double time in StoredSeas.SeaState6.Times)
            {
                Assert.That(surface.MeasuredWaveHeight(time), Is.EqualTo(height).Within(1e-9), $"at {time} s");
                Assert.That(4 * Math.Sqrt(SeaFields.Heights(surface.Mesh(time), 94).Average(y => y * y)),
                    Is.EqualTo(height).Within(2e-5), $"at {time} s, of the mesh");
            }
        }

        // The seed is not extreme: the variance's spread over seeds is 45 % for this spectrum.
        [Test]
        public void Seed_IsTypicalInItsHeight() =>
            Assert.That(StoredSeas.SeaState6.Settings.HeightFactor, Is.InRange(0.75, 1.5));

        [Test]
        public void Wind_PutsThePeakOnTheLongestWaveOfTheTile()
        {
            var settings = StoredSeas.SeaState6.Settings;
            // The spectrum over wave numbers in all directions is k times that of one direction.
            double Height(double length) => SeaSpectrum.Density(settings, 2 * Math.PI / length, 1) / length;
            double peak = Enumerable.Range(100, 1900).Select(i => 0.1 * i).OrderByDescending(Height).First();
            Assert.That(peak, Is.EqualTo(settings.TileSize).Within(1));
        }

        static double Correlation(double[] a, double[] b) =>
            a.Zip(b, (p, q) => p * q).Sum() / Math.Sqrt(a.Sum(p => p * p) * b.Sum(q => q * q));
    }
}
