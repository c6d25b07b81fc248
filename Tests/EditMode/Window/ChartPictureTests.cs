using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The chart that is exported, pixel by pixel.</summary>
    public sealed class ChartPictureTests
    {
        static readonly Color32 White = new Color32(255, 255, 255, 255);

        // From 0 at 0 deg to 10 at 10 deg: the diagonal, since both axes end there.
        [Test]
        public void Line_OfARamp_IsTheDiagonalOfTheChart()
        {
            var raster = Draw(Enumerable.Range(0, 1001).Select(i => SamplePoses.At(i * 0.01, i * 0.01)));
            Color32 line = ChartColours.Light.Line(0);
            foreach (double at in new[] { 0.13, 0.37, 0.51, 0.77 })
            {
                Assert.That(Pixel(raster, at, at), Is.EqualTo(line), $"{at}");
                Assert.That(Pixel(raster, at, at + 0.05), Is.Not.EqualTo(line), $"above {at}");
            }
        }

        // 10, and 5 on either side: from 5 to 15 of 15.
        [Test]
        public void Band_OfAnError_IsPaleAroundTheLine()
        {
            var raster = Draw(Enumerable.Range(0, 500).Select(i => SamplePoses.At(i * 0.02, 10, 5)));
            Color32 line = ChartColours.Light.Line(0),
                pale = Color32.Lerp(White, line, 0.2f);
            Assert.That(Pixel(raster, 0.53, 10 / 15.0), Is.EqualTo(line));
            foreach (double value in new[] { 6, 8, 12, 14 })
                Assert.That((Color)Pixel(raster, 0.53, value / 15), Is.EqualTo((Color)pale), $"{value}");
            Assert.That(Pixel(raster, 0.53, 4 / 15.0), Is.EqualTo(White));
        }

        [Test]
        public void Chosen_Pose_IsMarked()
        {
            var rows = new[] { SamplePoses.At(0, 1), SamplePoses.At(5, 2), SamplePoses.At(10, 1) };
            Color32 mark = ChartColours.Light.Mark;
            Assert.That(Pixels(Draw(rows)).Contains(mark), Is.False);
            var chart = new SweepChart(rows, SweepAxis.Angle, ResultColumn.Normalised, false);
            Assert.That(Pixels(ChartPicture.Draw(chart, rows[1])).Contains(mark));
        }

        // The picture of a chart was once cut off at its lower edge.
        [TestCase(1e-30, "")]
        [TestCase(1, "")]
        [TestCase(-123456.789, "")]
        [TestCase(1e12, "a folder whose name is much longer than what a picture has room for, as there are some, "
            + "with dates and settings and machines in them: 2024-01-01 to 2024-12-31")]
        public void Labels_OfAnyLength_AreWholeAndApart(double size, string compared)
        {
            var rows = Enumerable.Range(0, 60).Select(
                i => SamplePoses.At(SweepAxis.Range, 100000 + 1234 * (i % 5), SweepAxis.Snapshot, 1 + i / 5,
                    (i + 1) * size)).ToArray();
            var column = ResultColumn.All.Single(it => it.Name == "in_phase");
            var chart = new SweepChart(rows, SweepAxis.Range, column, false);
            foreach (var series in chart.Series)
                series.Name += compared;
            var raster = ChartPicture.Draw(chart, null);
            for (int x = 0; x < raster.Width; x++)
                Assert.That((raster[x, 0], raster[x, raster.Height - 1]), Is.EqualTo((White, White)), $"column {x}");
            for (int y = 0; y < raster.Height; y++)
                Assert.That((raster[0, y], raster[raster.Width - 1, y]), Is.EqualTo((White, White)), $"row {y}");
            var boxes = new ChartDrawing(chart, ChartPicture.Area).Texts().Select(Box).ToArray();
            for (int i = 0; i < boxes.Length; i++)
                for (int j = 0; j < i; j++)
                    Assert.That(boxes[i].Overlaps(boxes[j]), Is.False, $"{boxes[i]} and {boxes[j]}");
            foreach (var box in boxes)
                Assert.That(Ink(raster, box), Is.GreaterThan(4), $"{box}");
        }

        [Test]
        public void Legend_NamesEveryLine_InItsColour()
        {
            var one = Draw(new[] { SamplePoses.At(0, 1), SamplePoses.At(10, 2) });
            var rows = Enumerable.Range(0, 4).Select(
                i => SamplePoses.At(SweepAxis.Angle, i % 2, SweepAxis.Snapshot, 1 + i / 2)).ToArray();
            var two = Draw(rows);
            Assert.That(two.Height, Is.GreaterThan(one.Height));
            var below = Pixels(two).Skip(one.Height * one.Width).ToArray();
            Assert.That(below, Has.Member((Color32)ChartColours.Light.Line(0)));
            Assert.That(below, Has.Member((Color32)ChartColours.Light.Line(1)));
            Assert.That(below, Has.No.Member((Color32)ChartColours.Light.Line(2)));
        }

        [Test]
        public void Chart_OfNoPoses_IsItsAxes() =>
            Assert.That(Pixels(Draw(Array.Empty<StoredRow>())).Contains(ChartColours.Light.Frame));

        static Raster Draw(IEnumerable<StoredRow> rows) => ChartPicture.Draw(
            new SweepChart(rows.ToArray(), SweepAxis.Angle, ResultColumn.Normalised, false), null);

        // At chart coordinates, 0 to 1 with y up.
        static Color32 Pixel(Raster raster, double x, double y)
        {
            var area = ChartPicture.Area;
            return raster[(int)(ChartPicture.Scale * (area.x + x * area.width)),
                (int)(ChartPicture.Scale * (area.yMax - y * area.height))];
        }

        // Letters leave a sixth of a line free above and below.
        static Rect Box(ChartText text)
        {
            var size = StrokeFont.SizeOf(text.Text, text.IsTitle ? ChartPicture.TitleSize : ChartPicture.TickSize);
            var corner = text.Position - Vector2.Scale(text.Anchor, size);
            return new Rect(corner.x, corner.y + size.y / 6, size.x, size.y * 2 / 3);
        }

        static int Ink(Raster raster, Rect box)
        {
            int ink = 0;
            for (int y = (int)(ChartPicture.Scale * box.yMin); y < ChartPicture.Scale * box.yMax; y++)
                for (int x = (int)(ChartPicture.Scale * box.xMin); x < ChartPicture.Scale * box.xMax; x++)
                    ink += raster[x, y].r < 160 ? 1 : 0;
            return ink;
        }

        static IEnumerable<Color32> Pixels(Raster raster) =>
            Enumerable.Range(0, raster.Width * raster.Height).Select(i => raster[i % raster.Width, i / raster.Width]);
    }
}
