namespace Glint.Core
{
    /// <summary>
    /// Puts the middle one of some leaves where it would stand if they were sorted by their centres.
    /// Time grows with their number, not with its logarithm as well.
    /// </summary>
    static class LeafSelection
    {
        /// <summary>
        /// Afterwards no centre before place <paramref name="first"/> + <paramref name="count"/> / 2 is
        /// above one from there on.
        /// </summary>
        public static void PutMedianInPlace(BoxLeaf[] leaves, int first, int count, int axis)
        {
            int low = first, high = first + count - 1, middle = first + count / 2;
            while (low < high)
            {
                float pivot = MedianOfThree(Centre(leaves, low, axis), Centre(leaves, low + (high - low) / 2, axis),
                    Centre(leaves, high, axis));
                int i = low, j = high;
                while (i <= j)
                {
                    while (Centre(leaves, i, axis) < pivot)
                        i++;
                    while (Centre(leaves, j, axis) > pivot)
                        j--;
                    if (i > j)
                        break;
                    (leaves[i], leaves[j]) = (leaves[j], leaves[i]);
                    i++;
                    j--;
                }
                // Up to j at most the pivot, from i on at least; between them the pivot itself.
                if (middle <= j)
                    high = j;
                else if (middle >= i)
                    low = i;
                else
                    return;
            }
        }

        static float Centre(BoxLeaf[] leaves, int place, int axis) =>
            leaves[place].Box.Low[axis] + leaves[place].Box.High[axis];

        static float MedianOfThree(float a, float b, float c) =>
            a < b ? b < c ? b : a < c ? c : a : a < c ? a : b < c ? c : b;
    }
}
