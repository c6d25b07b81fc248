using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>
    /// X band: a sea's echo against NRL's model, sea states 2 to 6, in decibels averaged over directions (two parts
    /// against the wind, one across it), as the model's measurements have no direction. The wind is that of the sea
    /// state. Nothing is fitted.
    /// </summary>
    [Category("Slow")]
    public sealed class SeaStateTests
    {
        const double Frequency = 9.4e9;

        static readonly int[] s_states = { 2, 3, 4, 5, 6 };

        // The mean over sea states; without a mesh. The published differences of the same formulas of another program
        // agree within 0.1 dB.
        [TestCase("### Without mesh, two-scale mean", false)]
        [TestCase("### Without mesh, with breaking waves and Smith's shadow", true)]
        public void MeanEcho_WithoutMesh_DiffersFromNrlAsPrinted(string heading, bool isShaded)
        {
            var seas = s_states.Select(state => new AnalyticSea(Wind(state), Frequency)).ToArray();
            ClutterPage.AssertTable(heading, new double[] { 60, 45, 30, 20, 10, 3, 1 }.Select(grazing =>
            {
                double Mean(bool isHorizontal) => s_states.Average(state =>
                {
                    var sea = seas[state - s_states[0]];
                    Sigma0 Of(double azimuth) => isShaded
                        ? sea.WithShadow(90 - grazing, azimuth) : sea.TwoScale(90 - grazing, azimuth);
                    return Difference(Of(0), Of(90), state, grazing, isHorizontal);
                });
                return (grazing.ToString(), new[] { Mean(true), Mean(false) });
            }).ToArray());
        }

        [Test]
        [Category("Stress")]
        [Timeout(600000)]
        public void Sea_AtXBand_IsNearNrl()
        {
            double[] angles = { 1, 3, 10, 30 };
            var rows = s_states.SelectMany(state =>
            {
                var sea = new SeaMonteCarlo(Wind(state), Frequency, 1);
                return angles.Select(grazing =>
                {
                    var (against, litAgainst) = sea.At(grazing, false);
                    var (across, litAcross) = sea.At(grazing, true);
                    return ($"{state}, {grazing}", new[]
                    {
                        Difference(against, across, state, grazing, true),
                        Difference(against, across, state, grazing, false), 100 * litAgainst, 100 * litAcross
                    });
                });
            }).ToArray();
            double[] hh = rows.Select(row => Math.Abs(row.Item2[0])).ToArray(),
                vv = rows.Where(row => !row.Item1.EndsWith(" 30")).Select(row => Math.Abs(row.Item2[1])).ToArray();
            TestContext.WriteLine(FormattableString.Invariant(
                $"HH mean absolute {hh.Average():0.00} dB, worst {hh.Max():0.00}; ") + FormattableString.Invariant(
                $"VV up to 10 deg mean absolute {vv.Average():0.00} dB, worst {vv.Max():0.00}"));
            Assert.That((hh.Length, vv.Length), Is.EqualTo((20, 15)));
            Assert.That(hh.Average(), Is.LessThan(3));
            Assert.That(hh.Max(), Is.LessThan(5));
            Assert.That(vv.Average(), Is.LessThan(5));
            Assert.That(vv.Max(), Is.LessThan(7.5));
            ClutterPage.AssertTable("### A sea with its shadow and breakers", rows);
        }

        static double Wind(double state) => SeaStateFits.Wind(SeaStateFits.WaveHeight(state));

        static double Difference(in Sigma0 against, in Sigma0 across, double state, double grazing, bool isHorizontal)
        {
            var nrl = ClutterModel.All.Single(model => model.Name == "nrl");
            var polarisation = Polarisation.Read(isHorizontal ? "hh" : "vv").Single();
            double Decibels(in Sigma0 it) => Sigma0.Decibels(isHorizontal ? it.HH : it.VV);
            return (2 * Decibels(against) + Decibels(across)) / 3
                - nrl.Decibels(polarisation, new ClutterConditions(Frequency, grazing, state, 0));
        }
    }
}
