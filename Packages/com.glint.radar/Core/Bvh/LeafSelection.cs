namespace Glint.Core
{
    /// <summary>
    /// Quickselect: moves the median of some leaves, by their centres, to the position it has in sorted order.
    /// Linear time.
    /// </summary>
    static class LeafSelection
    {
        /// <summary>
        /// Afterwards no centre before index <paramref name="first"/> + <paramref name="count"/> / 2 is
        /// above one at or after it.
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
                // Up to j: at most the pivot. From i on: at least the pivot. Between them: the pivot.
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
