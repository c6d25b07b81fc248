namespace Glint.Core
{
    /// <summary>Rays that a result carries.</summary>
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
