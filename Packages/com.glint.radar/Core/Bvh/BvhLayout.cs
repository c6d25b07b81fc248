namespace Glint.Core
{
    /// <summary>How the nodes of a BVH look to the kernel.</summary>
    public enum BvhLayout
    {
        /// <summary>Two children with float boxes a node, 48 bytes: for GPUs.</summary>
        Binary,

        /// <summary>
        /// Up to four children with 8-bit boxes a node, 48 bytes: for software devices, where fetches cost most.
        /// </summary>
        Wide,
    }
}
