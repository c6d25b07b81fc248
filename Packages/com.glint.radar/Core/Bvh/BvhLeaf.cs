namespace Glint.Core
{
    /// <summary>A thing in a BVH: its box and its number.</summary>
    struct BvhLeaf
    {
        public Box Box;

        public int Item;
    }
}
