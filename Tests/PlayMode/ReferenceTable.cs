using System;
using System.Globalization;
using System.Linq;

namespace Glint.Tests
{
    /// <summary>A table of the package (Editor/Published) by angle: amplitude, rays received, rays hit.</summary>
    sealed class ReferenceTable
    {
        readonly double[][] _rows;

        ReferenceTable(double[][] rows) => _rows = rows;

        public static ReferenceTable Load(string name)
        {
            string text = PlayAsset.ReadText($"Packages/com.glint.radar/Editor/Published/{name}.csv");
            var lines = text.Split(new[] { '\n', '\r' }, StringSplitOptions.RemoveEmptyEntries);
            return new ReferenceTable(lines.Skip(1).Select(line => line.Split(',')
                .Select(cell => double.Parse(cell, CultureInfo.InvariantCulture)).ToArray()).ToArray());
        }

        public int Count => _rows.Length;

        public double Angle(int row) => _rows[row][0];

        public double Amplitude(int row) => _rows[row][1];

        public double Received(int row) => _rows[row][2];

        public double Hit(int row) => _rows[row][3];
    }
}
