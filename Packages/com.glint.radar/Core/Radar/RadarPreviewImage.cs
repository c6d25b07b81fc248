using System;
using System.Collections.Generic;
using System.Linq;
using Newtonsoft.Json.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The radar's view, a ray a pixel: number of reflections, whether the ray is received, the first object hit, and
    /// the cosine of the angle of incidence.
    /// </summary>
    public sealed class RadarPreviewImage
    {
        const byte ReceivedBit = 128;

        // Objects that a byte distinguishes; the last value means all others.
        const int MaxNames = 255;

        readonly byte[] _bounces, _facing;
        readonly int[] _objects;

        /// <summary>An empty picture.</summary>
        /// <param name="raysAcross">The whole picture's rays across.</param>
        /// <param name="raysDown">The whole picture's rays down.</param>
        /// <param name="part">The part that is shown, in these rays.</param>
        public RadarPreviewImage(int raysAcross, int raysDown, RayRegion part)
        {
            (RaysAcross, RaysDown, Part) = (raysAcross, raysDown, part);
            _bounces = new byte[part.Width * part.Height];
            _facing = new byte[part.Width * part.Height];
            _objects = new int[part.Width * part.Height];
        }

        /// <summary>Rays of the whole picture.</summary>
        public int RaysAcross { get; }

        /// <inheritdoc cref="RaysAcross"/>
        public int RaysDown { get; }

        /// <summary>The part that is shown.</summary>
        public RayRegion Part { get; }

        /// <summary>Reflections of a pixel's ray.</summary>
        /// <param name="x">From the left edge of the part.</param>
        /// <param name="y">From its bottom.</param>
        public int Bounces(int x, int y) => _bounces[y * Part.Width + x] & ~ReceivedBit;

        /// <summary>Whether a pixel's ray reaches the receiver.</summary>
        public bool IsReceived(int x, int y) => (_bounces[y * Part.Width + x] & ReceivedBit) != 0;

        /// <summary>
        /// Number of the object that a pixel's ray hits first;
        /// <see cref="MeshRange.NoObject"/> if none or unknown.
        /// </summary>
        public int Object(int x, int y) => _objects[y * Part.Width + x];

        /// <summary>
        /// Cosine of the angle between a pixel's ray and the first surface's normal, 0 to 1; 0 without a hit.
        /// </summary>
        public double Facing(int x, int y) => _facing[y * Part.Width + x] / 255.0;

        /// <summary>Numbers of the visible objects, in ascending order.</summary>
        public IReadOnlyList<int> Objects() =>
            _objects.Where(number => number != MeshRange.NoObject).Distinct().OrderBy(number => number).ToArray();

        /// <summary>Sets the pixel of a ray.</summary>
        public void Set(in RayPath path)
        {
            var at = new RadarSettings { RaysAcross = RaysAcross }.PositionOf(path.Pixel);
            int index = (at.y - Part.Bottom) * Part.Width + at.x - Part.Left;
            _bounces[index] = (byte)(path.Bounces + (path.IsReceived ? ReceivedBit : 0));
            _facing[index] = path.Bounces > 0 ? (byte)Math.Round(255 * Math.Min(1, Facing(path))) : (byte)0;
            _objects[index] = path.Bounces > 0 ? path.Hits[0].Object : MeshRange.NoObject;
        }

        // A mirror changes a direction by twice its component along the normal.
        static double Facing(in RayPath path) =>
            math.length(path.Hits[0].Direction - math.normalize(path.Hits[0].Position - path.Start)) / 2;

        /// <summary>
        /// The pixels for the report, rows from the bottom. The highest bit of a byte of bounces means received; objects
        /// are indices into the list of names, from 1.
        /// </summary>
        /// <param name="nameOf">Name of an object by its number.</param>
        public JObject ToJson(Func<int, string> nameOf)
        {
            var seen = Objects();
            var positions = new Dictionary<int, byte> { [MeshRange.NoObject] = 0 };
            for (int i = 0; i < seen.Count; i++)
                positions[seen[i]] = (byte)Math.Min(i + 1, MaxNames);
            return ToJson(seen.Take(MaxNames)
                    .Select((number, i) => i == MaxNames - 1 && seen.Count > MaxNames ? "others" : nameOf(number)),
                Array.ConvertAll(_objects, number => positions[number]));
        }

        JObject ToJson(IEnumerable<string> names, byte[] objects) => new JObject
        {
            ["across"] = RaysAcross,
            ["down"] = RaysDown,
            ["left"] = Part.Left,
            ["bottom"] = Part.Bottom,
            ["width"] = Part.Width,
            ["height"] = Part.Height,
            ["bounces"] = Convert.ToBase64String(_bounces),
            ["facing"] = Convert.ToBase64String(_facing),
            ["objects"] = Convert.ToBase64String(objects),
            ["names"] = new JArray(names)
        };
    }
}
