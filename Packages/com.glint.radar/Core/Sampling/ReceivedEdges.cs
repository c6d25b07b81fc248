using System;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// The edges of the received part of the picture. Moving an edge outwards changes the sum by the phasors along it.
    /// Position errors are equal along a row or column of pixels, and random along other edges.
    /// </summary>
    sealed class ReceivedEdges
    {
        readonly ReceivedPicture _picture;
        readonly int _firstColumn;
        readonly Complex[] _west, _east; // by column from the first that has a ray
        Complex _south, _north; // of the current row
        long _row = -1;
        double _squares;

        /// <param name="firstColumn">First column that has a ray.</param>
        /// <param name="lastColumn">Last column that has a ray.</param>
        public ReceivedEdges(ReceivedPicture picture, int firstColumn, int lastColumn)
        {
            _picture = picture;
            _firstColumn = firstColumn;
            _west = new Complex[Math.Max(0, lastColumn - firstColumn + 1)];
            _east = new Complex[_west.Length];
        }

        /// <summary>
        /// Adds a ray; rays come in the order of their pixels. A surrounded ray is an edge of its own: a crease may run
        /// through its pixel.
        /// </summary>
        public void Add(in ReceivedNeighbours near, Complex phasor)
        {
            int column = near.Column;
            long row = near.Row;
            if (row != _row)
                EndRow(row);
            if (near.South < 0 && row > _picture.Bottom)
                _south += phasor;
            if (near.North < 0 && row < _picture.Top)
                _north += phasor;
            if (near.West < 0 && column > _picture.Left)
                _west[column - _firstColumn] += phasor;
            if (near.East < 0 && column < _picture.Right)
                _east[column - _firstColumn] += phasor;
            if (near.Count == 8)
                _squares++;
        }

        /// <summary>
        /// Change of the sum, in rays, if edges move by a pixel, independently for each line of pixels. Nothing may be
        /// added afterwards.
        /// </summary>
        public double Strength()
        {
            EndRow(-1);
            for (int i = 0; i < _west.Length; i++)
                _squares += PowerLevel.Of(_west[i]) + PowerLevel.Of(_east[i]);
            return Math.Sqrt(_squares);
        }

        void EndRow(long next)
        {
            _squares += PowerLevel.Of(_south) + PowerLevel.Of(_north);
            _south = _north = 0;
            _row = next;
        }
    }
}
