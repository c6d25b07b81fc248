namespace Glint
{
    /// <summary>Motion of a <see cref="Sea"/> while the scene plays.</summary>
    public enum SeaMotion
    {
        /// <summary>No motion.</summary>
        Still,

        /// <summary>Shows one snapshot after the other, repeatedly.</summary>
        Snapshots,

        /// <summary>Travelling waves: the tile is recomputed each frame.</summary>
        Waves
    }
}
