namespace Glint.Core
{
    /// <summary>An item of a BVH: its box and its number.</summary>
    struct BvhLeaf
    {
        public Box Box;

        public int Item;
    }
}
