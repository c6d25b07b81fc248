using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>One spectrum for all waves: sigma0 of a sea does not depend on the facets of its mesh.</summary>
    [Category("Slow")]
    public sealed class FacetSizeTests
    {
        const double Tile = 256, Seeds = 2;

        // dB; 0.09 were found, 0.5 are asked for.
        const double Limit = 0.15;

        // Against the wind, without shadow. Facets of 0.5 to 4 m.
        [Test]
        public void Sigma0_OfFacetsOfHalfToFourMetres_IsTheSame(
            [Values(5, 10, 15)] double wind)
        {
            var seas = new[] { 512, 256, 128, 64 }.Select(cells => Sea(wind, cells)).ToArray();
            foreach (double grazing in new[] { 20.0, 30, 45, 60, 70 })
            {
                var radar = SeaTestBed.Radar(90 - grazing, 0);
                var means = seas.Select(sea => sea(radar)).ToArray();
                double Spread(Func<Sigma0, double> of) => Sigma0.Decibels(means.Max(of) / means.Min(of));
                TestContext.WriteLine(FormattableString.Invariant($"wind {wind} m/s, grazing {grazing} deg: ")
                    + FormattableString.Invariant($"HH {Spread(it => it.HH):0.00} dB, VV {Spread(it => it.VV):0.00} dB"));
                Assert.That(Spread(it => it.HH), Is.LessThan(Limit), $"HH at {grazing} deg");
                Assert.That(Spread(it => it.VV), Is.LessThan(Limit), $"VV at {grazing} deg");
            }
        }

        // The mean over the facets of a sea, per area of the mean surface.
        static Func<double3, Sigma0> Sea(double wind, int cells)
        {
            var tiles = Enumerable.Range(1, (int)Seeds).Select(seed =>
            {
                var settings = SeaClutterTests.Waves(wind, Tile, cells);
                (settings.Seed, settings.Choppiness) = (seed, 0);
                var clutter = new SeaClutter(new SeaSurface(settings), 0, new double3(0, 0, 1), SeaClutterSettings.On);
                return (clutter, mesh: clutter.LongWaves.Mesh(0));
            }).ToArray();
            return radar =>
            {
                var sum = default(Sigma0);
                foreach (var (clutter, mesh) in tiles)
                    for (int t = 0; t < mesh.TriangleCount; t++)
                    {
                        var normal = SeaClutterTests.Normal(mesh, t);
                        sum += 1 / normal.y * clutter.TableAt(10e9).Read(normal, radar, clutter.Wind);
                    }
                return 1 / (Seeds * 2 * cells * cells) * sum;
            };
        }
    }
}
