namespace Glint
{
    /// <summary>What a <see cref="Sea"/> does while the scene plays.</summary>
    public enum SeaMotion
    {
        /// <summary>Nothing.</summary>
        Still,

        /// <summary>It shows one snapshot after the other, and begins again.</summary>
        Snapshots,

        /// <summary>Its waves run: the tile is made anew each frame.</summary>
        Waves
    }
}
