using System;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>What the radar sees, a ray a pixel: how often the ray is reflected, whether it is received, and how squarely it meets the first surface.</summary>
    public sealed class RadarPicture
    {
        readonly byte[] _bounces, _facing;

        /// <summary>A picture in which nothing is seen yet.</summary>
        /// <param name="raysAcross">Rays across the whole picture.</param>
        /// <param name="raysDown">Rays down the whole picture.</param>
        /// <param name="part">The part that is shown, in these rays.</param>
        public RadarPicture(int raysAcross, int raysDown, RayRegion part)
        {
            (RaysAcross, RaysDown, Part) = (raysAcross, raysDown, part);
            _bounces = new byte[part.Width * part.Height];
            _facing = new byte[part.Width * part.Height];
        }

        /// <summary>Rays of the whole picture.</summary>
        public int RaysAcross { get; }

        /// <inheritdoc cref="RaysAcross"/>
        public int RaysDown { get; }

        /// <summary>The part that is shown.</summary>
        public RayRegion Part { get; }

        /// <summary>Sets a ray's pixel.</summary>
        /// <param name="pixel">Of the whole picture, as <see cref="RayData.Pixel"/>.</param>
        /// <param name="facing">Cosine of the angle between the ray and the first surface's normal, 0 to 1.</param>
        public void Set(uint pixel, int bounces, bool isReceived, double facing)
        {
            int place = ((int)(pixel / (uint)RaysAcross) - Part.Bottom) * Part.Width + (int)(pixel % (uint)RaysAcross) - Part.Left;
            _bounces[place] = (byte)(bounces + (isReceived ? 128 : 0));
            _facing[place] = (byte)Math.Round(255 * Math.Min(1, facing));
        }

        // Rows from the bottom. Of a byte of bounces the highest bit says that the ray is received.
        internal JObject ToJson() => new JObject
        {
            ["across"] = RaysAcross,
            ["down"] = RaysDown,
            ["left"] = Part.Left,
            ["bottom"] = Part.Bottom,
            ["width"] = Part.Width,
            ["height"] = Part.Height,
            ["bounces"] = Convert.ToBase64String(_bounces),
            ["facing"] = Convert.ToBase64String(_facing)
        };
    }
}
