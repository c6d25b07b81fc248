using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// A picture on white that is drawn without a graphics device, with smooth edges.
    /// Positions are in points from its upper left corner.
    /// </summary>
    sealed class Raster : IChartCanvas
    {
        // An area is sampled in as many rows of a pixel; across it is exact.
        const int RowsOfPixel = 4;

        // Thickness of letters over the size of the font.
        const float TextWeight = 0.11f;

        readonly float _scale;
        readonly Color32[] _pixels; // row by row from the top

        // Part of each pixel that the shape being drawn covers, and the rectangle in which it is not 0.
        readonly float[] _cover;
        int _left, _top, _right, _bottom;

        /// <param name="width">Points.</param>
        /// <param name="height">Points.</param>
        /// <param name="scale">Pixels of a point.</param>
        public Raster(int width, int height, int scale)
        {
            (Width, Height, _scale) = (scale * width, scale * height, scale);
            _pixels = Enumerable.Repeat(new Color32(255, 255, 255, 255), Width * Height).ToArray();
            _cover = new float[Width * Height];
            Forget();
        }

        /// <summary>Pixels.</summary>
        public int Width { get; }

        /// <inheritdoc cref="Width"/>
        public int Height { get; }

        /// <summary>Colour of a pixel, from the upper left corner.</summary>
        public Color32 this[int x, int y] => _pixels[y * Width + x];

        /// <summary>The picture as a PNG file.</summary>
        public byte[] Png()
        {
            var picture = new Texture2D(Width, Height, TextureFormat.RGBA32, false);
            try
            {
                picture.SetPixels32(Enumerable.Range(0, Height).Reverse()
                    .SelectMany(row => new ArraySegment<Color32>(_pixels, row * Width, Width)).ToArray());
                return picture.EncodeToPNG();
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(picture);
            }
        }

        public void Line(IReadOnlyList<Vector2> corners, bool isClosed, float width, Color colour)
        {
            Cover(corners, isClosed, width);
            Blend(colour);
        }

        public void Area(IReadOnlyList<Vector2> outline, Color colour)
        {
            var corners = outline.Select(corner => _scale * corner).ToArray();
            int first = Math.Max(0, RowsOfPixel * Mathf.FloorToInt(corners.Min(corner => corner.y))),
                end = RowsOfPixel * Math.Min(Height, Mathf.CeilToInt(corners.Max(corner => corner.y)));
            var crossings = new List<float>();
            for (int row = first; row < end; row++)
            {
                float y = (row + 0.5f) / RowsOfPixel;
                crossings.Clear();
                for (int i = 0; i < corners.Length; i++)
                {
                    Vector2 a = corners[i], b = corners[(i + 1) % corners.Length];
                    if (a.y > y != b.y > y)
                        crossings.Add(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
                }
                crossings.Sort();
                for (int i = 0; i < crossings.Count; i += 2)
                    CoverRow(row / RowsOfPixel, crossings[i], crossings[i + 1]);
            }
            Blend(colour);
        }

        /// <param name="anchor">Where in the text the position is: 0 at its left and its top, 1 at the others.</param>
        /// <param name="size">Size of the font, points.</param>
        public void Write(string text, Vector2 position, Vector2 anchor, float size, Color colour)
        {
            var corner = position - Vector2.Scale(anchor, StrokeFont.SizeOf(text, size));
            foreach (var line in StrokeFont.Lines(text, size))
                Cover(line.Select(point => corner + point).ToArray(), false, TextWeight * size);
            Blend(colour);
        }

        // Without gaps or thicker spots where the pieces of a line meet.
        void Cover(IReadOnlyList<Vector2> corners, bool isClosed, float width)
        {
            for (int i = 0; i < corners.Count; i++)
                if (i > 0 || isClosed)
                    CoverPiece(_scale * corners[(i + corners.Count - 1) % corners.Count], _scale * corners[i],
                        _scale * width / 2);
        }

        void CoverPiece(Vector2 from, Vector2 to, float radius)
        {
            var way = to - from;
            int left = Math.Max(0, Mathf.FloorToInt(Mathf.Min(from.x, to.x) - radius)),
                right = Math.Min(Width, Mathf.CeilToInt(Mathf.Max(from.x, to.x) + radius) + 1),
                bottom = Math.Min(Height, Mathf.CeilToInt(Mathf.Max(from.y, to.y) + radius) + 1);
            for (int y = Math.Max(0, Mathf.FloorToInt(Mathf.Min(from.y, to.y) - radius)); y < bottom; y++)
                for (int x = left; x < right; x++)
                {
                    var pixel = new Vector2(x + 0.5f, y + 0.5f) - from;
                    float along = way == Vector2.zero ? 0
                        : Mathf.Clamp01(Vector2.Dot(pixel, way) / Vector2.Dot(way, way));
                    float cover = Mathf.Clamp01(radius + 0.5f - (pixel - along * way).magnitude);
                    if (cover > _cover[y * Width + x])
                        Mark(x, y, cover);
                }
        }

        void CoverRow(int y, float from, float to)
        {
            int end = Math.Min(Width, Mathf.CeilToInt(to));
            for (int x = Math.Max(0, Mathf.FloorToInt(from)); x < end; x++)
                Mark(x, y, _cover[y * Width + x] + (Mathf.Min(to, x + 1) - Mathf.Max(from, x)) / RowsOfPixel);
        }

        void Mark(int x, int y, float cover)
        {
            _cover[y * Width + x] = cover;
            (_left, _right) = (Math.Min(_left, x), Math.Max(_right, x));
            (_top, _bottom) = (Math.Min(_top, y), Math.Max(_bottom, y));
        }

        // Paints what is covered.
        void Blend(Color colour)
        {
            Color32 opaque = new Color(colour.r, colour.g, colour.b);
            for (int y = _top; y <= _bottom; y++)
                for (int i = y * Width + _left; i <= y * Width + _right; i++)
                {
                    _pixels[i] = Color32.Lerp(_pixels[i], opaque, colour.a * _cover[i]);
                    _cover[i] = 0;
                }
            Forget();
        }

        void Forget() => (_left, _top, _right, _bottom) = (Width, Height, -1, -1);
    }
}
