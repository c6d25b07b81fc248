using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// The pixels that get sub-rays: received ones that are not smooth, and all neighbours of received ones, within the
    /// traced part of the picture.
    /// </summary>
    static class RefinedPixels
    {
        /// <param name="isSmooth">By ray: smooth, without sub-rays.</param>
        /// <returns>The pixels in ascending order.</returns>
        public static List<uint> Find(ReceivedPicture picture, bool[] isSmooth)
        {
            var pixels = new List<uint>();
            if (picture.Count == 0)
                return pixels;
            int firstRow = picture.PositionOf(0).y, lastRow = picture.PositionOf(picture.Count - 1).y;
            var (below, here, above) = (new Row(picture), new Row(picture), new Row(picture));
            for (long row = Math.Max(firstRow - 1, picture.Bottom); row <= Math.Min(lastRow + 1, picture.Top); row++)
            {
                below.MoveTo(row - 1);
                here.MoveTo(row);
                above.MoveTo(row + 1);
                AddRow(picture, isSmooth, row, below, here, above, pixels);
            }
            return pixels;
        }

        // The columns of the received rays of three rows and their neighbours, merged.
        static void AddRow(ReceivedPicture picture, bool[] isSmooth, long row, Row below, Row here,
            Row above, List<uint> pixels)
        {
            long next = picture.Left, start = row * picture.Across;
            int own = here.First;
            while (true)
            {
                long column = Math.Min(below.Column, Math.Min(here.Column, above.Column));
                if (column == long.MaxValue)
                    return;
                below.SkipTo(column + 1);
                here.SkipTo(column + 1);
                above.SkipTo(column + 1);
                for (next = Math.Max(next, column - 1); next <= Math.Min(column + 1, picture.Right); next++)
                {
                    while (own < here.End && picture[own].Pixel < start + next)
                        own++;
                    if (!(own < here.End && picture[own].Pixel == start + next && isSmooth[own]))
                        pixels.Add((uint)(start + next));
                }
            }
        }

        // The rays of one row, from the left.
        struct Row
        {
            readonly ReceivedPicture _picture;
            long _start;
            int _at;

            public Row(ReceivedPicture picture)
                : this() => _picture = picture;

            public int First { get; private set; }

            public int End { get; private set; }

            /// <summary>Column of the current ray; long.MaxValue at the end of the row.</summary>
            public long Column => _at < End ? _picture[_at].Pixel - _start : long.MaxValue;

            public void MoveTo(long row)
            {
                _start = row * _picture.Across;
                _at = First = _picture.FirstFrom(_start);
                End = _picture.FirstFrom(_start + _picture.Across);
            }

            public void SkipTo(long column)
            {
                if (Column < column)
                    _at++;
            }
        }
    }
}
