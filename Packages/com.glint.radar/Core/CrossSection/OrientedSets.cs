namespace Glint.Core
{
    /// <summary>Sets of numbers that are joined two by two, each number with one of two orientations.</summary>
    sealed class OrientedSets
    {
        readonly int[] _parents;
        readonly bool[] _isFlipped; // against the parent

        /// <summary>Each number from 0 is a set of its own.</summary>
        public OrientedSets(int count)
        {
            _parents = new int[count];
            _isFlipped = new bool[count];
            for (int i = 0; i < count; i++)
                _parents[i] = i;
        }

        /// <summary>The number that identifies the set of <paramref name="item"/>.</summary>
        /// <param name="item">A number.</param>
        /// <param name="flipped">Whether its orientation is not that of the number returned.</param>
        public int Find(int item, out bool flipped)
        {
            flipped = false;
            for (int parent; (parent = _parents[item]) != item; item = _parents[item])
            {
                _isFlipped[item] ^= _isFlipped[parent];
                _parents[item] = _parents[parent];
                flipped ^= _isFlipped[item];
            }
            return item;
        }

        /// <summary>Joins the sets of two numbers whose orientations are the same or opposite.</summary>
        /// <returns>False if they already are in one set with other orientations.</returns>
        public bool Join(int a, int b, bool opposite)
        {
            int rootA = Find(a, out bool flipA), rootB = Find(b, out bool flipB);
            bool flipped = flipA ^ flipB ^ opposite;
            if (rootA == rootB)
                return !flipped;
            _parents[rootB] = rootA;
            _isFlipped[rootB] = flipped;
            return true;
        }
    }
}
