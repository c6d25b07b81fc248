namespace Glint.Core
{
    /// <summary>Which rays a result carries one by one.</summary>
    public enum RayReadback
    {
        /// <summary>Rays that reached the receiver.</summary>
        Received,

        /// <summary>Every ray emitted: 48 bytes each.</summary>
        All,

        /// <summary>None: only sums are read back.</summary>
        None,
    }
}
