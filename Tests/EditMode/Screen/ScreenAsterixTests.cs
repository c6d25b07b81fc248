using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Spokes of a radar screen as messages, read by a decoder written from the specification.</summary>
    public sealed class ScreenAsterixTests
    {
        [Test]
        public void Message_HasTheSpokesBearing_Ranges_AndVideo()
        {
            var radar = ScreenRadar.Default;
            (radar.Spokes, radar.Cells, radar.RangeScale) = (1024, 64, 6400);
            var encoder = new ScreenAsterix(new ScreenGeometry(radar, "test"));
            var video = Enumerable.Range(0, 128).Select(i => new float2(i % 64 / 63f, 1)).ToArray();
            encoder.Encode(0, video, 0, 0);
            // Spoke 256 of the third turn: east.
            var message = AsterixReader.Read(encoder.Encode(2 * 1024 + 256, video, 64, 3600)).Single();
            Assert.That(message.StartDegrees, Is.EqualTo(90 - 180.0 / 1024).Within(0.003));
            Assert.That(message.EndDegrees, Is.EqualTo(90 + 180.0 / 1024).Within(0.003));
            Assert.That(message.Cells, Is.EqualTo(Enumerable.Range(0, 64).Select(i => (byte)(255 * i / 63.0 + 0.5))));
            Assert.That(message.RangeOf(11) - message.RangeOf(1), Is.EqualTo(1000).Within(0.01));
            Assert.That(message.SecondsOfDay, Is.EqualTo(3600));
            Assert.That(message.Index, Is.EqualTo(1));
        }
    }
}
