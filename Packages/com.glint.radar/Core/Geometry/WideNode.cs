namespace Glint.Core
{
    /// <summary>A record of a tree of up to four children a node: an inner node or a leaf.</summary>
    struct WideNode
    {
        /// <summary>What it is in the binary tree: a node, or ~ a leaf.</summary>
        public int Binary;

        /// <summary>An inner node's first child; the others follow it.</summary>
        public int FirstChild;

        public int ChildCount;
    }
}
