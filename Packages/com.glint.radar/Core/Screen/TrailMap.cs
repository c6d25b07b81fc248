using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>In which frame trails keep their place.</summary>
    public enum TrailMotion
    {
        /// <summary>Of the own ship: what moves relative to it has a trail.</summary>
        Relative,

        /// <summary>Of the ground: what moves over it has a trail.</summary>
        True
    }

    /// <summary>
    /// The map of trails: squares to the east and north. It repeats every <see cref="Side"/> pixels, so that it has no
    /// edge when the antenna moves. Shaders/ScreenTrails.hlsl writes it.
    /// </summary>
    public static class TrailMap
    {
        /// <summary>Pixels along a side: TRAIL_SIDE in Shaders/ScreenPixel.hlsl.</summary>
        public const int Side = 1024;

        /// <summary>Pixels in the range scale: TRAIL_RADIUS.</summary>
        public const int Radius = 480;

        /// <summary>
        /// Pixels that the antenna may move between two frames. With more, the pixel of a place that comes into the
        /// range scale may still hold the trail of a place on the other side.
        /// </summary>
        public const int MaxStep = Side - 2 * Radius;

        /// <summary>The map's pixel of a position, as a real number from 0 to <see cref="Side"/>.</summary>
        /// <param name="position">Metres to the east and to the north.</param>
        public static double2 PixelOf(double2 position, double rangeScale)
        {
            double2 pixels = position * (Radius / rangeScale);
            return pixels - Side * math.floor(pixels / Side);
        }
    }
}
