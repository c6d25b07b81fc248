using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// One spectrum for all waves: the mean of sigma0 over the facets of a sea is that of the whole spectrum, whatever
    /// their size. At 10 GHz, against the wind, without shadow.
    /// </summary>
    [Category("Slow")]
    public sealed class FacetSizeTests
    {
        const double Frequency = 10e9;

        static readonly double[] s_grazing = { 20, 30, 45, 60, 70 };

        // Facets of 0.5 to 4 m on the same long waves, per area of the mean surface. 0.13 dB were found, 0.5 are asked
        // for.
        [TestCase(5, Category = "Stress")]
        [TestCase(10)]
        [TestCase(15, Category = "Stress")]
        public void Sigma0_OfFacetsOfHalfToFourMetres_IsTheSame(double wind)
        {
            var seas = new[] { 512, 256, 128, 64 }
                .Select(cells => Enumerable.Range(1, 2).Select(seed => new Sea(wind, 256, cells, seed)).ToArray())
                .ToArray();
            foreach (double grazing in s_grazing)
            {
                var means = seas.Select(tiles => Mean(tiles, grazing, normal => 1 / normal.y)).ToArray();
                double hh = Sigma0.Decibels(means.Max(it => it.HH) / means.Min(it => it.HH)),
                    vv = Sigma0.Decibels(means.Max(it => it.VV) / means.Min(it => it.VV));
                TestContext.WriteLine(FormattableString.Invariant(
                    $"wind {wind} m/s, grazing {grazing} deg: HH {hh:0.00} dB, VV {vv:0.00} dB"));
                Assert.That(hh, Is.LessThan(0.2), $"HH at {grazing} deg");
                Assert.That(vv, Is.LessThan(0.2), $"VV at {grazing} deg");
            }
        }

        // Tiles of many long waves, whose slopes differ little between seeds: at 60 deg of grazing 1 % of the slope
        // variance is 0.3 dB.
        [TestCase(5, 256)]
        [TestCase(7, 512, Category = "Stress")]
        [TestCase(10, 1024, Category = "Stress")]
        [TestCase(15, 2048, Category = "Stress")]
        [TestCase(20, 2048)]
        public void Sigma0_OfAMesh_IsTheTwoScaleMean(double wind, double tile)
        {
            var tiles = Enumerable.Range(1, 2).Select(seed => new Sea(wind, tile, 512, seed)).ToArray();
            var whole = new AnalyticSea(wind, Frequency);
            foreach (double grazing in s_grazing)
            {
                Sigma0 mean = Mean(tiles, grazing, _ => 1), expected = whole.TwoScale(90 - grazing, 0);
                double hh = Sigma0.Decibels(mean.HH / expected.HH), vv = Sigma0.Decibels(mean.VV / expected.VV);
                TestContext.WriteLine(FormattableString.Invariant(
                    $"wind {wind} m/s, grazing {grazing} deg: HH {hh:0.00} dB, VV {vv:0.00} dB from the mean"));
                Assert.That(hh, Is.EqualTo(0).Within(0.3), $"HH at {grazing} deg");
                Assert.That(vv, Is.EqualTo(0).Within(0.3), $"VV at {grazing} deg");
            }
        }

        static Sigma0 Mean(Sea[] tiles, double grazing, Func<double3, double> weight)
        {
            var radar = SeaTestBed.Radar(90 - grazing, 0);
            var sum = default(Sigma0);
            foreach (var tile in tiles)
                foreach (var normal in tile.Normals)
                    sum += weight(normal) * tile.Table.Read(normal, radar, new double3(0, 0, 1));
            return 1.0 / tiles.Sum(tile => tile.Normals.Length) * sum;
        }

        sealed class Sea
        {
            public readonly FacetTable Table;
            public readonly double3[] Normals;

            public Sea(double wind, double side, int cells, int seed)
            {
                var settings = SeaClutterTests.Waves(wind, side, cells);
                (settings.Seed, settings.Choppiness) = (seed, 0);
                var clutter = new SeaClutter(new SeaSurface(settings), 0, new double3(0, 0, 1), SeaClutterSettings.On);
                Table = clutter.TableAt(Frequency);
                var mesh = clutter.LongWaves.Mesh(0);
                Normals = Enumerable.Range(0, mesh.TriangleCount).Select(t => SeaClutterTests.Normal(mesh, t))
                    .ToArray();
            }
        }
    }
}
