namespace Glint.Core
{
    /// <summary>
    /// One wave of a sea's tile. Its height is 2 Re(h e^(i(2 pi (Column x + Row z) / tile - w t))),
    /// x and z from the tile's corner.
    /// </summary>
    struct SeaMode
    {
        /// <summary>
        /// Waves a tile along x and z; of each pair k and -k, which are the same wave,
        /// the one with z above 0, or z 0 and x above 0.
        /// </summary>
        public int Column, Row;

        /// <summary>h, metres.</summary>
        public double Real, Imaginary;

        /// <summary>w over 2 pi, turns a second: negative if the wave travels along -k.</summary>
        public double Frequency;

        /// <summary>k over its length.</summary>
        public double AlongX, AlongZ;
    }
}
