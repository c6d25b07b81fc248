namespace Glint.Core
{
    /// <summary>A record of a BVH of up to four children a node: an inner node or a leaf.</summary>
    struct Bvh4Node
    {
        /// <summary>Its node of the binary BVH, or ~ (the complement of) its leaf.</summary>
        public int Binary;

        /// <summary>An inner node's first child; the others follow it.</summary>
        public int FirstChild;

        public int ChildCount;
    }
}
