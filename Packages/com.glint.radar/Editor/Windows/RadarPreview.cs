using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// The radar's view of a pose in colours: number of reflections of each ray, or the first object hit.
    /// </summary>
    sealed class RadarPreview
    {
        /// <summary>Maximum number of objects in the legend: those with the most pixels.</summary>
        public const int MaxNames = 12;

        static readonly Color32 s_nothing = new Color32(16, 22, 28, 255), s_received = new Color32(255, 255, 255, 255);

        // Colours of the HTML report, which the colour-blind can distinguish.
        static readonly Color32[] s_bounces =
        {
            new Color32(238, 106, 36, 255), new Color32(0, 176, 131, 255),
            new Color32(86, 180, 233, 255), new Color32(240, 228, 66, 255)
        };
        static readonly Color32[] s_objects =
        {
            new Color32(230, 159, 0, 255), new Color32(86, 180, 233, 255),
            new Color32(0, 158, 115, 255), new Color32(204, 121, 167, 255),
            new Color32(0, 114, 178, 255), new Color32(213, 94, 0, 255),
            new Color32(240, 228, 66, 255), new Color32(0, 238, 170, 255),
        };

        readonly RadarPreviewImage _image;
        readonly Dictionary<int, string> _names;
        readonly List<int> _objects; // by number of pixels, descending
        readonly Dictionary<int, int> _pixels;

        /// <param name="names">Names of the picture's objects by their numbers.</param>
        public RadarPreview(RadarPreviewImage image, Dictionary<int, string> names)
        {
            (_image, _names) = (image, names);
            _pixels = All().Where(at => image.Bounces(at.x, at.y) > 0).GroupBy(at => image.Object(at.x, at.y))
                .ToDictionary(group => group.Key, group => group.Count());
            _objects = _pixels.Keys.Where(number => number != MeshRange.NoObject)
                .OrderByDescending(number => _pixels[number]).ThenBy(number => number).ToList();
        }

        /// <summary>Pixels across and down.</summary>
        public int Width => _image.Part.Width;

        /// <inheritdoc cref="Width"/>
        public int Height => _image.Part.Height;

        /// <summary>Traces the view of the scene in its current state.</summary>
        /// <exception cref="GlintException">The radar or a mesh cannot be traced.</exception>
        public static RadarPreview Of(RadarController radar, CancellationToken cancel = default)
        {
            var image = radar.TracePreview(cancel);
            return new RadarPreview(image,
                image.Objects().ToDictionary(number => number, number => radar.ObjectAt(number).name));
        }

        /// <summary>
        /// Colours of all pixels, row by row from the bottom.
        /// Brightness is the cosine of incidence at the first surface; white stripes mark received rays.
        /// </summary>
        public Color32[] Colours(bool byObject) => All().Select(at => ColourAt(at.x, at.y, byObject)).ToArray();

        /// <summary>Meaning of the colours.</summary>
        public IEnumerable<(Color32 colour, string text)> Legend(bool byObject)
        {
            int nothing = Width * Height - _pixels.Values.Sum();
            if (nothing > 0)
                yield return (s_nothing, $"nothing met ({nothing})");
            if (byObject)
            {
                foreach (int number in _objects.Take(MaxNames))
                    yield return (ObjectColour(number), $"{_names[number]} ({_pixels[number]})");
            }
            else
            {
                foreach (var bounces in All().Select(at => _image.Bounces(at.x, at.y)).Where(count => count > 0)
                    .GroupBy(count => count).OrderBy(group => group.Key))
                    yield return (BounceColour(bounces.Key),
                        $"{bounces.Key} bounce{(bounces.Key == 1 ? "" : "s")} ({bounces.Count()})");
            }
            yield return (s_received, $"received ({All().Count(at => _image.IsReceived(at.x, at.y))})");
        }

        /// <summary>Description of a pixel; x and y from the lower left corner.</summary>
        public string Text(int x, int y)
        {
            int bounces = _image.Bounces(x, y);
            if (bounces == 0)
                return "nothing met";
            string first = _names.TryGetValue(_image.Object(x, y), out var name) ? $", first {name}" : "";
            return $"{bounces} bounce{(bounces == 1 ? "" : "s")}{first}"
                + $"{(_image.IsReceived(x, y) ? ", received" : "")}";
        }

        IEnumerable<int2> All()
        {
            for (int y = 0; y < Height; y++)
                for (int x = 0; x < Width; x++)
                    yield return new int2(x, y);
        }

        Color32 ColourAt(int x, int y, bool byObject)
        {
            int bounces = _image.Bounces(x, y);
            if (bounces == 0)
                return s_nothing;
            if (_image.IsReceived(x, y) && (x + y) % 6 < 2)
                return s_received;
            return Color32.Lerp(new Color32(0, 0, 0, 255),
                byObject ? ObjectColour(_image.Object(x, y)) : BounceColour(bounces),
                0.3f + 0.7f * (float)_image.Facing(x, y));
        }

        static Color32 BounceColour(int bounces) => s_bounces[(bounces - 1) % s_bounces.Length];

        Color32 ObjectColour(int number) => s_objects[math.max(0, _objects.IndexOf(number)) % s_objects.Length];
    }
}
