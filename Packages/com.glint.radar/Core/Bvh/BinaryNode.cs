namespace Glint.Core
{
    /// <summary>An inner node of a <see cref="BinaryBvh"/>.</summary>
    struct BinaryNode
    {
        public Box Box;

        /// <summary>Index of its first leaf.</summary>
        public int First;

        /// <summary>Number of its leaves, at least 2.</summary>
        public int Count;

        /// <summary>Number of leaves of the left child, which come first.</summary>
        public int LeftCount;
    }
}
