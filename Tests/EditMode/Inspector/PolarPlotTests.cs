using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The polar plot of cross sections: its scale, where points are, and what is drawn.</summary>
    public sealed class PolarPlotTests
    {
        static readonly Rect s_area = new Rect(0, 0, 400, 320);

        static readonly double[] s_right = { 0, 90, 180, 270 };

        // The rings are at 0, 5, 10, 15 and 20 dBsm. Azimuth 0 is at the top and 90 on the right.
        [Test]
        public void Path_OfFourDirections_IsClockwiseFromTheTopWithDecibelsAsRadii()
        {
            var plot = new PolarPlot(SampleRows.Of(s_right, azimuth => 20 - azimuth / 18, azimuth => 0));
            Assert.That(string.Join(",", plot.Levels.Ticks.Select(tick => tick.Label)), Is.EqualTo("0,5,10,15,20"));
            var drawing = new PolarDrawing(plot, s_area);
            var rim = RimOf(drawing);
            var centre = s_area.center;
            var path = drawing.PathOf(plot.Curves[0]);
            // 20, 15, 10 and 5 dBsm.
            Assert.That(Vector2.Distance(path[0], centre + rim * new Vector2(0, -1)), Is.LessThan(1e-3));
            Assert.That(Vector2.Distance(path[1], centre + 0.75f * rim * new Vector2(1, 0)), Is.LessThan(1e-3));
            Assert.That(Vector2.Distance(path[2], centre + 0.5f * rim * new Vector2(0, 1)), Is.LessThan(1e-3));
            Assert.That(Vector2.Distance(path[3], centre + 0.25f * rim * new Vector2(-1, 0)), Is.LessThan(1e-3));
        }

        // From above with -Z at the top, +X is on the left.
        [Test]
        public void Path_IsTheViewFromAboveOfTheDirectionsToTheRadar()
        {
            double[] azimuths = { -100, 17, 133, 250 };
            var plot = new PolarPlot(SampleRows.Of(azimuths, azimuth => 10, azimuth => 0));
            var drawing = new PolarDrawing(plot, s_area);
            var path = drawing.PathOf(plot.Curves[0]);
            for (int i = 0; i < azimuths.Length; i++)
            {
                var toRadar = RadarAspect.At(azimuths[i], 0).ToRadar;
                var expected = new Vector2(-(float)toRadar.x, (float)toRadar.z); // y points downwards
                Assert.That(Vector2.Distance((path[i] - s_area.center).normalized, expected), Is.LessThan(1e-5));
            }
        }

        [Test]
        public void Levels_OfDeepNulls_EndFortyDecibelsBelowTheMaximum()
        {
            var plot = new PolarPlot(SampleRows.Of(s_right,
                azimuth => azimuth == 0 ? 20 : azimuth == 90 ? -150 : double.NegativeInfinity, azimuth => 10));
            Assert.That((plot.Levels.Min, plot.Levels.Max), Is.EqualTo((-20, 20)));
            Assert.That(plot.Curves[0].Points.Select(point => point.Y), Is.EqualTo(new[] { 1, 0, 0, 0 }));
            Assert.That(plot.Curves[1].Points.Select(point => point.Y), Is.All.EqualTo(0.75).Within(1e-9));
        }

        [Test]
        public void Levels_OfATargetThatReturnsNothing_AreFinite()
        {
            var plot = new PolarPlot(
                SampleRows.Of(s_right, azimuth => double.NegativeInfinity, azimuth => double.NegativeInfinity));
            Assert.That((plot.Levels.Min, plot.Levels.Max), Is.EqualTo((-40, 0)));
            Assert.That(plot.Curves[0].Points.Select(point => point.Y), Is.All.Zero);
        }

        [TestCase(0, 359, 1, true)]
        [TestCase(0, 360, 1, true)]
        [TestCase(-180, 150, 30, true)]
        [TestCase(0, 358, 1, false)]
        [TestCase(-60, 60, 0.5, false)]
        [TestCase(0, 180, 180, false)]
        public void WholeTurn_IsAGapOfNoMoreThanAStep(double from, double to, double step, bool isWhole)
        {
            double[] azimuths = CrossSectionRanges.Azimuths.Read(
                FormattableString.Invariant($"{from}:{to}:{step}"));
            Assert.That(new PolarPlot(SampleRows.Of(azimuths, azimuth => 0, azimuth => 0)).IsWholeTurn,
                Is.EqualTo(isWhole));
        }

        [TestCase("vv,hh", "VV,HH")]
        [TestCase("all", "VV,HH")]
        [TestCase("hv,hh", "HH,HV")]
        [TestCase("vh", "VH")]
        public void Curves_AreTwoPolarisationsAtMostTheCopolarisedFirst(string asked, string shown) => Assert.That(
            string.Join(",", new PolarPlot(SampleRows.Of(s_right, azimuth => 0, azimuth => 0, asked)).Curves
                .Select(curve => curve.Name)), Is.EqualTo(shown));

        [Test]
        public void Rows_OfOtherElevationsAndFrequencies_AreNotShown()
        {
            var plan = new CrossSectionPlan(new double[] { 30, 0 }, new double[] { 0, 10 }, new[] { 9e9, 10e9 });
            var plot = new PolarPlot(SampleRows.Of(plan, azimuth => azimuth, azimuth => 0));
            Assert.That(plot.Title, Is.EqualTo("dBsm, elevation 10°, 10 GHz"));
            var curve = plot.Curves[0];
            Assert.That(curve.Points.Select(point => plot.AzimuthOf(point)), Is.EqualTo(new double[] { 0, 30 }),
                "in the order of azimuths");
            Assert.That(curve.Points[1].Y, Is.EqualTo(1));
        }

        // The amplitudes of sample rows are those of the radar's azimuth.
        [Test]
        public void Rows_OfSeveralReceivers_AreShownOverThemForTheLastRadar()
        {
            var plan = CrossSectionPlan.OfReceivers(new double[] { 20, 10 }, new double[] { 5 }, new[] { 9e9, 10e9 },
                new double[] { 90, -30, 0 });
            var plot = new PolarPlot(SampleRows.Of(plan, azimuth => azimuth, azimuth => 0), true);
            Assert.That((plot.Title, plot.OtherAzimuth), Is.EqualTo(("dBsm, elevation 5°, 10 GHz", 10)));
            Assert.That(plot.Notes, Is.EqualTo(new[] { "over receivers", "radar at 10°" }));
            Assert.That(plot.Curves[0].Points.Select(point => plot.AzimuthOf(point)),
                Is.EqualTo(new double[] { -30, 0, 90 }).Within(1e-9), "in the order of azimuths");
            Assert.That(plot.Levels.Max, Is.EqualTo(10), "not those of the radar at 20");
        }

        [Test]
        public void Rows_OfFewReceivers_AreShownOverAzimuthForTheLastOne()
        {
            var plan = CrossSectionPlan.OfReceivers(s_right, new double[] { 5 }, new[] { 10e9 },
                new double[] { 0, 40 });
            var plot = new PolarPlot(SampleRows.Of(plan, azimuth => 0, azimuth => 0));
            Assert.That(plot.OtherAzimuth, Is.EqualTo(40));
            Assert.That(plot.Notes, Is.EqualTo(new[] { "receiver at 40°", "elevation 5°" }));
            Assert.That(plot.Curves[0].Points.Select(point => plot.AzimuthOf(point)), Is.EqualTo(s_right));
        }

        // Both are between spokes.
        [Test]
        public void Draw_OfReceivers_MarksTheDirectionOfTheRadarOrTheReceiver()
        {
            var plan = CrossSectionPlan.OfReceivers(new double[] { 105 }, new double[] { 5 }, new[] { 10e9 },
                new double[] { 15, 255 });
            var rows = SampleRows.Of(plan, azimuth => 10, azimuth => 0);
            Color32 mark = ChartColours.Light.Mark;
            foreach (bool isOverReceivers in new[] { true, false })
            {
                var plot = new PolarPlot(rows, isOverReceivers);
                var drawing = new PolarDrawing(plot, s_area);
                var raster = new Raster((int)s_area.width, (int)s_area.height, 1);
                drawing.Draw(raster, ChartColours.Light);
                double radius = RimOf(drawing) / 2, azimuth = Math.PI / 180 * (isOverReceivers ? 105 : 255);
                Assert.That(Shows(raster, 200 + (int)(radius * Math.Sin(azimuth)),
                    160 - (int)(radius * Math.Cos(azimuth)), mark), Is.True, $"{isOverReceivers}");
                Assert.That(Shows(raster, 200 - (int)(radius * 0.866), 160 - (int)radius / 2, mark), Is.False);
                var texts = drawing.Texts().ToArray();
                AssertWhole(texts);
                Assert.That(texts.Select(text => text.Text), Is.SupersetOf(plot.Notes));
                foreach (var note in texts.Where(text => plot.Notes.Contains(text.Text)))
                    Assert.That(texts.Where(text => BoxOf(text).Overlaps(BoxOf(note))).Select(text => text.Text),
                        Is.EqualTo(new[] { note.Text }), "over no other text");
            }
        }

        [Test]
        public void Path_OfVeryManyRows_IsShortAndKeepsThePeak()
        {
            double[] azimuths = CrossSectionRanges.Azimuths.Read("0:359.99:0.01");
            var plot = new PolarPlot(SampleRows.Of(azimuths, azimuth => azimuth == 123.45 ? 30 : 0, azimuth => 0));
            var drawing = new PolarDrawing(plot, s_area);
            var path = drawing.PathOf(plot.Curves[0]);
            Assert.That(path.Count, Is.LessThan(2000));
            Assert.That(path.Max(corner => Vector2.Distance(corner, s_area.center)),
                Is.EqualTo(RimOf(drawing)).Within(1e-3));
        }

        [Test]
        public void Labels_AreRingsInDbsmAnglesTitleAndKeys()
        {
            var plot = new PolarPlot(SampleRows.Of(s_right, azimuth => 20, azimuth => 0));
            var texts = new PolarDrawing(plot, s_area).Texts().ToArray();
            Assert.That(texts.Select(text => text.Text), Is.EqualTo(new[]
            {
                "0°", "30°", "60°", "90°", "120°", "150°", "180°", "210°", "240°", "270°", "300°", "330°",
                "0", "5", "10", "15", "20", "dBsm, elevation 0°, 10 GHz", "VV", "HH"
            }));
            AssertWhole(texts);
            // The ring of 10 dBsm is half way up.
            Assert.That(s_area.center.y - texts.Single(text => text.Text == "10").Position.y,
                Is.EqualTo(RimOf(new PolarDrawing(plot, s_area)) / 2).Within(1e-3));
        }

        [Test]
        public void Draw_OnAPicture_ShowsBothCurvesInTheirColours()
        {
            var plot = new PolarPlot(SampleRows.Of(CrossSectionRanges.Azimuths.Read("0:350:10"), azimuth => 20,
                azimuth => azimuth < 180 ? 10 : 0));
            var raster = new Raster((int)s_area.width, (int)s_area.height, 1);
            var drawing = new PolarDrawing(plot, s_area);
            drawing.Draw(raster, ChartColours.Light);
            int radius = (int)RimOf(drawing);
            var (vv, hh) = ((Color32)ChartColours.Light.Line(0), (Color32)ChartColours.Light.Line(1));
            // VV is the rim; HH is half way on the right, and in the centre on the left.
            Assert.That(Shows(raster, 200 + (int)(radius * 0.866), 160 - radius / 2, vv));
            Assert.That(Shows(raster, 200 - (int)(radius * 0.866), 160 - radius / 2, vv));
            Assert.That(Shows(raster, 200 + (int)(radius * 0.433), 160 - radius / 4, hh));
            Assert.That(Shows(raster, 200 - (int)(radius * 0.433), 160 - radius / 4, hh), Is.False);
        }

        static bool Shows(Raster raster, int x, int y, Color32 colour) => Enumerable.Range(-4, 9).Any(across =>
            Enumerable.Range(-4, 9).Any(down => raster[x + across, y + down].Equals(colour)));

        // Each is whole inside the rectangle.
        static void AssertWhole(IEnumerable<ChartText> texts)
        {
            foreach (var text in texts)
            {
                var box = BoxOf(text);
                Assert.That(box.xMin >= 0 && box.yMin >= -1 && box.xMax <= s_area.width
                    && box.yMax <= s_area.height + 1, $"{text.Text} at {box}");
            }
        }

        static Rect BoxOf(ChartText text)
        {
            var size = StrokeFont.SizeOf(text.Text, ChartPicture.TickSize);
            return new Rect(text.Position - Vector2.Scale(text.Anchor, size), size);
        }

        // Radius of the outermost ring.
        static float RimOf(PolarDrawing drawing)
        {
            var canvas = new Lines();
            drawing.Draw(canvas, ChartColours.Light);
            return canvas.Closed.Max(line => Vector2.Distance(line[0], s_area.center));
        }

        sealed class Lines : IChartCanvas
        {
            public readonly List<IReadOnlyList<Vector2>> Closed = new List<IReadOnlyList<Vector2>>();

            public void Line(IReadOnlyList<Vector2> corners, bool isClosed, float width, Color colour)
            {
                if (isClosed)
                    Closed.Add(corners);
            }

            public void Area(IReadOnlyList<Vector2> outline, Color colour) { }
        }
    }
}
