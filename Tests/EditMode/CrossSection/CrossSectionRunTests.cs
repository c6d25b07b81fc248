using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Rows of runs over a band of materials that are no perfect conductors.</summary>
    [Category("Slow")]
    public sealed class CrossSectionRunTests : CrossSectionFixture
    {
        const double Width = 0.3, Height = 0.2, TenGigahertz = 1e10;

        static readonly SurfaceMaterial s_sea = new SurfaceMaterial("sea", halfSpace: Medium.SeaWater());

        // It absorbs at 10 GHz: a quarter wave with much loss.
        static readonly SurfaceMaterial s_absorber = new SurfaceMaterial("absorber",
            new[] { new MaterialLayer(Medium.Constant(4, 2.2), Signal.Wavelength(TenGigahertz) / 8) });

        // Edges off: at normal incidence on its face a box returns |S| = 2 sqrt(pi) |R| a b / lambda.
        [Test, Timeout(60000)]
        public void Band_OfABoxOfAMaterial_HasItsCoefficientAtEachFrequency()
        {
            int Traces(SurfaceMaterial material)
            {
                var setup = SetupOf(material, 90, 0, EchoBand.Frequencies(TenGigahertz, 0.4e9, 100));
                setup.HasEdges = false;
                var (rows, traces) = Rows(setup);
                foreach (var row in rows)
                {
                    double expected = 2 * Math.Sqrt(Math.PI) * Width * Height
                        / Signal.Wavelength(row.Planned.Frequency)
                        * Complex.Abs(material.Reflection(1, row.Planned.Frequency).S);
                    Assert.That(row.S.VV.Magnitude, Is.EqualTo(expected).Within(Allowed(setup) * expected), $"{row}");
                    Assert.That(row.S.HH.Magnitude, Is.EqualTo(expected).Within(Allowed(setup) * expected), $"{row}");
                }
                return traces;
            }
            int sea = Traces(s_sea), absorber = Traces(s_absorber);
            Assert.That(sea, Is.InRange(2, 20));
            Assert.That(absorber, Is.GreaterThan(3 * sea), "its coefficient changes faster");
        }

        [Test, Timeout(60000)]
        public void Band_OfAMaterial_EqualsSingleFrequencies([Values] bool isSea)
        {
            var setup = SetupOf(isSea ? s_sea : s_absorber, 75, 8,
                EchoBand.Frequencies(9.4e9, isSea ? 0.1e9 : 0.03e9, 40));
            var (rows, traces) = Rows(setup);
            Assert.That(traces, Is.InRange(2, rows.Length / 2));
            for (int i = 0; i < rows.Length; i += 3)
            {
                var s = Tracer.Trace(setup.PoseOf(rows[i].Planned)).S[0, 0];
                Assert.That(Complex.Abs(rows[i].S.VV - s.VV), Is.LessThan(Allowed(setup) * Complex.Abs(s.VV)), $"{i}");
                Assert.That(Complex.Abs(rows[i].S.HH - s.HH), Is.LessThan(Allowed(setup) * Complex.Abs(s.HH)), $"{i}");
            }
        }

        // From one group to the next the coefficients of sea water step by up to 2/1000. Without a window, an error of
        // each frequency below 1/1000 of the echo is below 1/1000 of its peak in the profile.
        [Test, Timeout(60000)]
        public void Band_OfAnEcho_ChangesItsProfileByLessThan60DecibelsBelowThePeak()
        {
            double[] frequencies = EchoBand.Frequencies(TenGigahertz, 600e6, 64);
            var setup = SetupOf(s_sea, 90, 0, frequencies);
            (setup.HasEdges, setup.ToleranceDb) = (false, 1);
            setup.Echo = new EchoSettings { Bandwidth = 600e6, Window = "none" };
            var (rows, traces) = Rows(setup);
            Assert.That(traces, Is.InRange(2, 32));
            var range = setup.Echo.RangeOf(setup.Plan);
            var profile = range.Profile(rows.Select(row => row.S.VV).ToArray());
            // The phase of the face in front of the phase centre is that of a perfect conductor's.
            var metal = Rows(SetupOf(SurfaceMaterial.PerfectConductor, 90, 0, frequencies, hasEdges: false)).rows;
            var exact = range.Profile(rows.Select((row, i) => -metal[i].S.VV
                * s_sea.Reflection(1, row.Planned.Frequency).S).ToArray());
            double peak = exact.Max(value => value.Magnitude);
            for (int cell = 0; cell < profile.Length; cell++)
                Assert.That((profile[cell] - exact[cell]).Magnitude, Is.LessThan(1e-3 * peak), $"cell {cell}");
        }

        // 3 directions, 2 groups of frequencies, 2 receivers: a trace gives the rows of a group and both receivers.
        [Test, Timeout(60000)]
        public void RunAhead_HasTheRowsOfOneDirectionAtATime()
        {
            var scene = new RadarScene(CrossSectionTargets.Box(Width, Height, 0.05));
            var plan = new CrossSectionPlan(new[] { 0.0, 20, 33 }, new[] { 5.0 }, new[] { TenGigahertz, 2 * TenGigahertz },
                receiverAzimuths: new[] { 0.0, 90 }, receiverElevation: 5);
            var setup = new CrossSectionSetup(scene, plan) { ToleranceDb = 1 };
            string[] RowsOf(int posesTogether)
            {
                using (var run = new CrossSectionRun(setup, TestKernels.Tubes, posesTogether: posesTogether))
                    return Enumerable.Range(0, run.Count).Select(_ => run.Step().ToString()).Append($"{run.Traces}").ToArray();
            }
            Assert.That(RowsOf(2), Is.EqualTo(RowsOf(1)));
        }

        [Test]
        public void Receivers_AtAFiniteRange_ShareATrace()
        {
            var scene = new RadarScene(CrossSectionTargets.Plate(0.2, 0.1));
            var plan = new CrossSectionPlan(new[] { 0.0, 20 }, new[] { 0.0 }, new[] { TenGigahertz },
                receiverAzimuths: Enumerable.Range(0, 17).Select(i => 5.0 * i).ToArray());
            var (rows, traces) = Rows(new CrossSectionSetup(scene, plan) { Range = 5, ToleranceDb = 1 });
            Assert.That((rows.Length, traces), Is.EqualTo((34, 4)), "16 receivers, and the last");
        }

        (CrossSectionRow[] rows, int traces) Rows(CrossSectionSetup setup)
        {
            using (var run = new CrossSectionRun(setup, TestKernels.Tubes))
                return (Enumerable.Range(0, run.Count).Select(_ => run.Step()).ToArray(), run.Traces);
        }

        static double Allowed(CrossSectionSetup setup) => CrossSectionAccuracy.AllowedBy(setup.ToleranceDb);

        static CrossSectionSetup SetupOf(SurfaceMaterial material, double azimuth, double elevation,
            double[] frequencies, bool hasEdges = true)
        {
            var scene = new RadarScene(CrossSectionTargets.Box(Width, Height, 0.05)) { Surfaces = new[] { material } };
            var plan = new CrossSectionPlan(new[] { azimuth }, new[] { elevation }, frequencies);
            return new CrossSectionSetup(scene, plan) { HasEdges = hasEdges };
        }
    }
}
