using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// A chart with its legend as a picture for documents: on white, of the same size on every screen.
    /// </summary>
    static class ChartPicture
    {
        /// <summary>Where the chart is in the picture, points.</summary>
        public static readonly Rect Area = new Rect(80, 36, 680, 344);

        /// <summary>Pixels of a point.</summary>
        public const int Scale = 2;

        /// <summary>Sizes of the fonts, points.</summary>
        public const float TickSize = 11, TitleSize = 12;

        // Points. The legend begins below the title of the x axis.
        const int Width = 800, LegendTop = 424, LegendRow = 18, KeySize = 16, KeyGap = 5, EntryGap = 14;

        /// <param name="marked">The chosen pose; may be null.</param>
        public static Raster Draw(SweepChart chart, StoredRow marked)
        {
            var colours = ChartColours.Light;
            var legend = Legend(chart);
            var raster = new Raster(Width, LegendTop + LegendRow * (legend.Count == 0 ? 0 : 1 + legend.Max(e => e.row)),
                Scale);
            var drawing = new ChartDrawing(chart, Area);
            drawing.Draw(raster, colours, marked);
            foreach (var text in drawing.Texts())
                raster.Write(text.Text, text.Position, text.Anchor, text.IsTitle ? TitleSize : TickSize, colours.Frame);
            foreach (var (series, name, x, row) in legend)
            {
                var centre = new Vector2(x + KeySize / 2, LegendTop + (row + 0.5f) * LegendRow - KeyGap);
                if (series >= 0)
                    Markers.Draw(raster, centre, series, 5, colours.Line(series), chart.Series[series].IsCompared);
                raster.Write(name, new Vector2(x + KeySize + KeyGap, centre.y), new Vector2(0, 0.5f), TitleSize,
                    colours.Frame);
            }
            return raster;
        }

        // The entries in rows as wide as the chart. Series: -1 for the note of those not shown.
        static IReadOnlyList<(int series, string name, float x, int row)> Legend(SweepChart chart)
        {
            var names = chart.Series.Count > 1 ? chart.Series.Select((series, i) => (i, series.Label)).ToList()
                : new List<(int, string Label)>();
            if (chart.LeftOut > 0)
                names.Add((-1, chart.LeftOutText));
            var entries = new List<(int, string, float, int)>();
            float x = Area.x;
            int row = 0;
            foreach (var (series, label) in names)
            {
                string name = Shortened(label);
                float width = KeySize + KeyGap + StrokeFont.SizeOf(name, TitleSize).x;
                if (x > Area.x && x + width > Area.xMax)
                    (x, row) = (Area.x, row + 1);
                entries.Add((series, name, x, row));
                x += width + EntryGap;
            }
            return entries;
        }

        // A name that is too long for a row, such as that of a folder, ends in dots.
        static string Shortened(string name)
        {
            int length = name.Length;
            while (StrokeFont.SizeOf(name.Substring(0, length), TitleSize).x > Area.width - KeySize - KeyGap)
                length--;
            return length == name.Length ? name : name.Substring(0, length) + "...";
        }
    }
}
