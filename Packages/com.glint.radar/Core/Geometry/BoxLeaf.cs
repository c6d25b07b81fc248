namespace Glint.Core
{
    /// <summary>A thing in a tree: its box and its number.</summary>
    struct BoxLeaf
    {
        public Box Box;

        public int Item;
    }
}
