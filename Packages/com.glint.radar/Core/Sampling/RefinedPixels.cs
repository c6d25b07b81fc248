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
            var pixels = new List<uint>(picture.Count);
            if (picture.Count == 0)
                return pixels;
            long first = Math.Max(picture.RowOf(0) - 1, picture.Bottom),
                last = Math.Min(picture.RowOf(picture.Count - 1) + 1, picture.Top);
            var below = new Row(picture, first - 1);
            var here = below.Next();
            for (long row = first; row <= last; row++)
            {
                var above = here.Next();
                AddRow(picture, isSmooth, row, below, here, above, pixels);
                (below, here) = (here, above);
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
            readonly long _start;
            int _at;

            public Row(ReceivedPicture picture, long row)
                : this(picture, row * picture.Across, picture.FirstFrom(row * picture.Across))
            {
            }

            Row(ReceivedPicture picture, long start, int first)
            {
                (_picture, _start, First) = (picture, start, first);
                End = _at = first;
                while (End < picture.Count && picture[End].Pixel < start + picture.Across)
                    End++;
            }

            public int First { get; }

            public int End { get; }

            /// <summary>The row above, from its left.</summary>
            public Row Next() => new Row(_picture, _start + _picture.Across, End);

            /// <summary>Column of the current ray; long.MaxValue at the end of the row.</summary>
            public long Column => _at < End ? _picture[_at].Pixel - _start : long.MaxValue;

            public void SkipTo(long column)
            {
                if (Column < column)
                    _at++;
            }
        }
    }
}
