namespace Glint.Core
{
    /// <summary>An inner node of a <see cref="BinaryBvh"/>.</summary>
    struct BinaryNode
    {
        public Box Box;

        /// <summary>The first of its leaves.</summary>
        public int First;

        /// <summary>How many leaves it has, two at least.</summary>
        public int Count;

        /// <summary>How many of them, the first ones, are the left child's.</summary>
        public int LeftCount;
    }
}
