namespace Glint.Core
{
    /// <summary>Format of BVH nodes on the device.</summary>
    public enum BvhLayout
    {
        /// <summary>Two children a node, float boxes, 48 bytes: for GPUs.</summary>
        Binary,

        /// <summary>
        /// Up to four children a node, 8-bit boxes, 48 bytes: for software devices, where fetches cost most.
        /// </summary>
        Wide,
    }
}
