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
        public static void PutMedianInPlace(BvhLeaf[] leaves, int first, int count, int axis)
        {
            int left = first, right = first + count - 1, mid = first + count / 2;
            while (left < right)
            {
                float pivot = MedianOfThree(Centre(leaves, left, axis), Centre(leaves, left + (right - left) / 2, axis),
                    Centre(leaves, right, axis));
                int i = left, j = right;
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
                if (mid <= j)
                    right = j;
                else if (mid >= i)
                    left = i;
                else
                    return;
            }
        }

        static float Centre(BvhLeaf[] leaves, int index, int axis) =>
            leaves[index].Box.Min[axis] + leaves[index].Box.Max[axis];

        static float MedianOfThree(float a, float b, float c) =>
            a < b ? b < c ? b : a < c ? c : a : a < c ? a : b < c ? c : b;
    }
}
