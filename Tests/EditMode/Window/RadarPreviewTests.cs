using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The radar's view in colours: four pixels made by hand.</summary>
    public sealed class RadarPreviewTests
    {
        RadarPreview _preview;

        // Left: nothing, and a wall head-on, received. Right: the sea at 60 degrees, and a bounce off the wall.
        [SetUp]
        public void MakeImage()
        {
            var image = new RadarPreviewImage(4, 4, new RayRegion { Left = 1, Bottom = 2, Width = 2, Height = 2 });
            image.Set(Path(1, 2));
            image.Set(Path(2, 2, (7, 60)));
            image.Set(Path(1, 3, (3, 0), (7, 0)));
            image.Set(Path(2, 3, (7, 60), (3, 0)));
            _preview = new RadarPreview(image, new Dictionary<int, string> { [3] = "Wall", [7] = "Sea" });
        }

        [Test]
        public void Text_OfAPixel_SaysBouncesObjectAndReception()
        {
            Assert.That(_preview.Text(0, 0), Is.EqualTo("nothing met"));
            Assert.That(_preview.Text(1, 0), Is.EqualTo("1 bounce, first Sea"));
            Assert.That(_preview.Text(0, 1), Is.EqualTo("2 bounces, first Wall, received"));
            Assert.That(_preview.Text(1, 1), Is.EqualTo("2 bounces, first Sea, received"));
        }

        [Test]
        public void Legend_CountsThePixels()
        {
            Assert.That(_preview.Legend(false).Select(entry => entry.text),
                Is.EqualTo(new[] { "nothing met (1)", "1 bounce (1)", "2 bounces (2)", "received (2)" }));
            Assert.That(_preview.Legend(true).Select(entry => entry.text),
                Is.EqualTo(new[] { "nothing met (1)", "Sea (2)", "Wall (1)", "received (2)" }));
        }

        [Test]
        public void Colours_OfAPixel_AreThoseOfTheLegend()
        {
            foreach (bool byObject in new[] { false, true })
            {
                var colours = _preview.Colours(byObject);
                var legend = _preview.Legend(byObject)
                    .ToDictionary(entry => entry.text.Split(' ')[0], entry => entry.colour);
                Assert.That(colours[0], Is.EqualTo(legend["nothing"]));
                // 60 degrees: cosine 0.5, brightness 0.3 + 0.35.
                var expected = legend[byObject ? "Sea" : "1"];
                Assert.That((double)colours[1].r / expected.r, Is.EqualTo(0.65).Within(0.02));
                // x + y of the two received pixels is 1 or 2: on a stripe, and between stripes.
                Assert.That(colours[2], Is.EqualTo(legend["received"]));
                Assert.That(colours[3], Is.Not.EqualTo(legend["received"]));
            }
        }

        // A ray along z, reflected by surfaces with these tilts in degrees.
        static RayPath Path(uint x, uint y, params (int number, double degrees)[] hits)
        {
            double3 direction = new double3(0, 0, 1), position = 0;
            var path = new RayPath { Pixel = x + 4 * y, Hits = new PathHit[hits.Length] };
            for (int i = 0; i < hits.Length; i++)
            {
                double slope = math.radians(hits[i].degrees);
                var normal = new double3(math.sin(slope), 0, -math.cos(slope));
                position += 10 * direction;
                direction -= 2 * math.dot(direction, normal) * normal;
                path.Hits[i] = new PathHit { Position = position, Direction = direction, Object = hits[i].number };
            }
            if (hits.Length == 2)
                path.End = position + direction;
            return path;
        }
    }
}
