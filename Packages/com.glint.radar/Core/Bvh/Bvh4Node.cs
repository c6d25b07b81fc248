namespace Glint.Core
{
    /// <summary>A record of a BVH of up to four children a node: an inner node or a leaf.</summary>
    struct Bvh4Node
    {
        /// <summary>What it is in the binary BVH: a node, or ~ a leaf.</summary>
        public int Binary;

        /// <summary>An inner node's first child; the others follow it.</summary>
        public int FirstChild;

        public int ChildCount;
    }
}
