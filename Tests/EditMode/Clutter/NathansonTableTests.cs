using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>The stored table of measured reflectivities, and how far the formulas are from it.</summary>
    public sealed class NathansonTableTests
    {
        static readonly double[] s_gigahertz = { 0.5, 1.25, 3, 5.6, 9.3, 17, 35 },
            s_grazing = { 0.1, 0.3, 1, 3, 10, 30, 60 };

        static readonly Polarisation s_vv = Polarisation.All[0], s_hh = Polarisation.All[3];

        // As printed for 9.3 GHz.
        [TestCase(true, 3, -53, -46, -40, -39, -37, -34, -21)]
        [TestCase(true, 5, -42, -39, -34, -33, -30, -26, -14)]
        [TestCase(false, 1, -65, -58, -50, -45, -42, -36, -24)]
        [TestCase(false, 4, -48, -43, -37, -35, -29, -24, -14)]
        public void Cells_AreThePublishedOnes(bool isHorizontal, double state, params double[] expected) =>
            Assert.That(s_grazing.Select(grazing => Of("nathanson").Decibels(isHorizontal ? s_hh : s_vv,
                new ClutterConditions(9.3e9, grazing, state, 0))), Is.EqualTo(expected).Within(1e-9));

        [Test]
        public void Between_IsLinearInLogarithmsAndSeaStates()
        {
            double At(double gigahertz, double grazing, double state) =>
                Of("nathanson").Decibels(s_vv, new ClutterConditions(gigahertz * 1e9, grazing, state, 0));
            Assert.That(At(9.3, 3, 3.5), Is.EqualTo((At(9.3, 3, 3) + At(9.3, 3, 4)) / 2).Within(1e-9));
            Assert.That(At(9.3, Math.Sqrt(30), 3), Is.EqualTo((At(9.3, 3, 3) + At(9.3, 10, 3)) / 2).Within(1e-9));
            Assert.That(At(Math.Sqrt(9.3 * 17), 3, 3), Is.EqualTo((At(9.3, 3, 3) + At(17, 3, 3)) / 2).Within(1e-9));
        }

        // No measurement at 0.1 deg and sea state 6, and so none between sea states 5 and 6.
        [TestCase(6)]
        [TestCase(5.5)]
        public void Cell_WithoutMeasurement_IsRefused(double state) => Assert.That(
            () => Of("nathanson").Decibels(s_hh, new ClutterConditions(9.3e9, 0.1, state, 0)),
            Throws.TypeOf<GlintException>().With.Message.Contains("no measurement of hh at 9.3 GHz, 0.1 deg"));

        // 267 cells of HH and 286 of VV; NRL's own deviations up to 10 and up to 60 deg, as its report says.
        [Test]
        public void Nrl_DeviatesAsItsReportSays()
        {
            Assert.That(Cells(s_hh).Count, Is.EqualTo(267));
            Assert.That(Cells(s_vv).Count, Is.EqualTo(286));
            Assert.That(Deviation("nrl", s_hh, 10), Is.EqualTo(2.29).Within(0.01));
            Assert.That(Deviation("nrl", s_vv, 10), Is.EqualTo(2.24).Within(0.01));
            Assert.That(Deviation("nrl", s_hh, 60), Is.EqualTo(2.64).Within(0.01));
            Assert.That(Deviation("nrl", s_vv, 60), Is.EqualTo(2.54).Within(0.01));
        }

        // In feet, sea states 1 to 6, crosswind: 2.8 and 3.1 dB; upwind 4.3.
        [Test]
        public void Tsc_DeviatesAsPublished()
        {
            Assert.That(Deviation("tsc", s_hh, 10, 90, 1), Is.EqualTo(2.8).Within(0.06));
            Assert.That(Deviation("tsc", s_vv, 10, 90, 1), Is.EqualTo(3.1).Within(0.06));
            Assert.That(Deviation("tsc", s_hh, 10, 0, 1), Is.EqualTo(4.3).Within(0.06));
            Assert.That(Deviation("tsc", s_vv, 10, 0, 1), Is.EqualTo(4.3).Within(0.06));
        }

        static ClutterModel Of(string name) => ClutterModel.All.Single(model => model.Name == name);

        // Mean absolute difference over the cells that the model holds for.
        static double Deviation(string name, Polarisation polarisation, double maxGrazing, double windAngle = 0,
            double minState = 0) =>
            Cells(polarisation).Where(cell => cell.at.GrazingDegrees <= maxGrazing
                && cell.at.SeaState >= minState).Average(cell =>
            {
                var at = new ClutterConditions(cell.at.Frequency, cell.at.GrazingDegrees, cell.at.SeaState, windAngle);
                return Math.Abs(Of(name).Decibels(polarisation, at) - cell.decibels);
            });

        static List<(ClutterConditions at, double decibels)> Cells(Polarisation polarisation)
        {
            var cells = new List<(ClutterConditions, double)>();
            foreach (double gigahertz in s_gigahertz)
                foreach (double grazing in s_grazing)
                    for (int state = 0; state <= 6; state++)
                    {
                        var at = new ClutterConditions(gigahertz * 1e9, grazing, state, 0);
                        try
                        {
                            cells.Add((at, Of("nathanson").Decibels(polarisation, at)));
                        }
                        catch (GlintException)
                        {
                            // A cell without measurement.
                        }
                    }
            return cells;
        }
    }
}
