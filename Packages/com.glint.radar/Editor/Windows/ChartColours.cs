using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Colours of a chart. The lines' are those of the HTML report, which the colour-blind tell apart; markers say the
    /// same without colour.
    /// </summary>
    sealed class ChartColours
    {
        public static readonly ChartColours Light = new ChartColours
        {
            Grid = Of(0xc9d1d9), Frame = Of(0x4b5865), Mark = Of(0x16202a), Undersampled = Of(0xb34700),
            _lines = new[] { 0x0060a0, 0xb34700, 0x009e73, 0xcc79a7, 0x8c6d00, 0x7a5af8 }.Select(Of).ToArray()
        };

        static readonly ChartColours s_dark = new ChartColours
        {
            Grid = Of(0x3a4652), Frame = Of(0xa9b5c1), Mark = Of(0xe6ebf0), Undersampled = Of(0xff9f52),
            _lines = new[] { 0x6cbcf0, 0xff9f52, 0x00b083, 0xcc79a7, 0xf0e442, 0x9d87ff }.Select(Of).ToArray()
        };

        Color[] _lines;

        /// <summary>Those of the editor's skin.</summary>
        public static ChartColours Skin => EditorGUIUtility.isProSkin ? s_dark : Light;

        public Color Grid { get; private set; }

        /// <summary>Axes and text.</summary>
        public Color Frame { get; private set; }

        /// <summary>The chosen pose.</summary>
        public Color Mark { get; private set; }

        /// <summary>Undersampled poses.</summary>
        public Color Undersampled { get; private set; }

        /// <summary>Colour of a line, from 0.</summary>
        public Color Line(int series) => _lines[series % _lines.Length];

        static Color Of(int rgb) => new Color32((byte)(rgb >> 16), (byte)(rgb >> 8), (byte)rgb, 255);
    }
}
