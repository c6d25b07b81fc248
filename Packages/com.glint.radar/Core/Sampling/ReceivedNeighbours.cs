namespace Glint.Core
{
    /// <summary>
    /// The eight neighbours of a received ray, for one ray after another in the order of their pixels; -1 if not
    /// received.
    /// </summary>
    struct ReceivedNeighbours
    {
        public int West, East, South, North, SouthWest, SouthEast, NorthWest, NorthEast;

        readonly ReceivedPicture _picture;
        long _rowStart; // first pixel of the row
        int _below, _above; // first rays in the row below and above that may be neighbours

        /// <param name="first">The first ray.</param>
        public ReceivedNeighbours(ReceivedPicture picture, int first)
            : this()
        {
            _picture = picture;
            if (picture.Count == 0)
                return;
            long pixel = picture[first].Pixel;
            Row = picture.RowOf(first);
            _rowStart = Row * picture.Across;
            _below = picture.FirstFrom(pixel - picture.Across - 1);
            _above = picture.FirstFrom(pixel + picture.Across - 1);
        }

        /// <summary>Column and row of the ray.</summary>
        public int Column { get; private set; }

        /// <inheritdoc cref="Column"/>
        public long Row { get; private set; }

        /// <summary>Received rays among the eight.</summary>
        public int Count => Has(West) + Has(East) + Has(South) + Has(North) + Has(SouthWest) + Has(SouthEast)
            + Has(NorthWest) + Has(NorthEast);

        /// <summary>Moves to the same or a later ray.</summary>
        public void MoveTo(int ray)
        {
            uint pixel = _picture[ray].Pixel;
            for (; pixel >= _rowStart + _picture.Across; _rowStart += _picture.Across)
                Row++;
            Column = (int)(pixel - _rowStart);
            bool hasWest = Column > 0, hasEast = Column + 1 < _picture.Across;
            West = hasWest && ray > 0 && _picture[ray - 1].Pixel == pixel - 1 ? ray - 1 : -1;
            East = hasEast && ray + 1 < _picture.Count && _picture[ray + 1].Pixel == pixel + 1 ? ray + 1 : -1;
            FindRow((long)pixel - _picture.Across, hasWest, hasEast, ref _below, out SouthWest,
                out South, out SouthEast);
            FindRow((long)pixel + _picture.Across, hasWest, hasEast, ref _above, out NorthWest,
                out North, out NorthEast);
        }

        void FindRow(long index, bool hasWest, bool hasEast, ref int first, out int west, out int centre, out int east)
        {
            while (first < _picture.Count && _picture[first].Pixel < index - 1)
                first++;
            int at = first;
            west = Take(index - 1, ref at);
            centre = Take(index, ref at);
            east = Take(index + 1, ref at);
            if (!hasWest)
                west = -1;
            if (!hasEast)
                east = -1;
        }

        int Take(long pixel, ref int at) => at < _picture.Count && _picture[at].Pixel == pixel ? at++ : -1;

        static int Has(int ray) => ray < 0 ? 0 : 1;
    }
}
