using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class AsterixVideoTests
    {
        // By hand from the specification: 5 cells of 50 ns from cell 2 on, 90 to 91 degrees, half past midnight, in two
        // groups of 4 octets. 50 ns are 7.49481145 m.
        [Test]
        public void Message_OfFiveCells_HasTheFormatsBytes()
        {
            var video = new AsterixVideo(25, 7, 7.49481145);
            Assert.That(video.Encode(90, 91, 2, new byte[] { 1, 2, 3, 4, 255 }, 1800), Is.EqualTo(new byte[]
            {
                240, 0, 43, 0xE7, 0xC8, 25, 7, 2, 0, 0, 0, 0,
                0x40, 0x00, 0x40, 0xB6, 0, 0, 0, 2, 0x02, 0xFA, 0xF0, 0x80,
                0, 4, 0, 5, 0, 0, 5, 2, 1, 2, 3, 4, 255, 0, 0, 0, 0x03, 0x84, 0x00
            }));
        }

        // The items that radars in use send, with groups of 64 octets: E7 A8.
        [TestCase(1, 0xC8)]
        [TestCase(1020, 0xC8)]
        [TestCase(1021, 0xA8)]
        [TestCase(2048, 0xA8)]
        [TestCase(16320, 0xA8)]
        [TestCase(16321, 0x98)]
        [TestCase(65280, 0x98)]
        public void Message_OfAnyLength_IsReadBack(int count, int items)
        {
            var random = new Random(count);
            var cells = new byte[count];
            random.NextBytes(cells);
            var video = new AsterixVideo(1, 2, 30);
            video.Encode(0, 0, 0, cells, 0);
            byte[] block = video.Encode(359.99, 360.08, 100, cells, 86399.996);
            Assert.That(block.Skip(3).Take(2), Is.EqualTo(new[] { 0xE7, items }));

            var message = AsterixReader.Read(block).Single();
            Assert.That((message.AreaCode, message.IdentificationCode, message.MessageType), Is.EqualTo((1, 2, 2)));
            Assert.That(message.Index, Is.EqualTo(1), "the second message");
            Assert.That(message.StartDegrees, Is.EqualTo(359.99).Within(0.0028));
            Assert.That(message.EndDegrees, Is.EqualTo(0.08).Within(0.0028));
            Assert.That(message.Cells, Is.EqualTo(cells));
            Assert.That(message.SecondsOfDay, Is.EqualTo(86399.996).Within(1 / 128.0));
            Assert.That(message.RangeOf(1), Is.EqualTo(3000).Within(1e-3));
            Assert.That(message.RangeOf(21), Is.EqualTo(3600).Within(1e-3));
        }

        [Test]
        public void Messages_OneAfterTheOther_AreAFile()
        {
            var video = new AsterixVideo(1, 2, 7.5);
            byte[] file = Enumerable.Range(0, 4)
                .SelectMany(i => video.Encode(90 * i, 90 * i + 90, 0, new[] { (byte)i }, i)).ToArray();
            var messages = AsterixReader.Read(file);
            Assert.That(messages.Select(message => message.Index), Is.EqualTo(new[] { 0, 1, 2, 3 }));
            Assert.That(messages.Select(message => message.StartDegrees), Is.EqualTo(new[] { 0.0, 90, 180, 270 }));
            Assert.That(messages.Last().EndDegrees, Is.Zero, "a full turn");
            Assert.That(messages.Select(message => message.Cells[0]), Is.EqualTo(new[] { 0, 1, 2, 3 }));
        }

        [TestCase(-90, 270)]
        [TestCase(720.5, 0.5)]
        public void Azimuth_OfAnyTurn_IsTheSame(double degrees, double expected)
        {
            byte[] block = new AsterixVideo(1, 2, 7.5).Encode(degrees, degrees, 0, new byte[1], 0);
            Assert.That(AsterixReader.Read(block)[0].StartDegrees, Is.EqualTo(expected).Within(0.0028));
        }

        [Test]
        public void WrongNumbers_AreRefused()
        {
            var video = new AsterixVideo(1, 2, 7.5);
            AssertRefused(() => new AsterixVideo(1, 2, 700),
                "ASTERIX: the cell size is 700 m, it must be from 0.001 to 643");
            AssertRefused(() => video.Encode(0, 1, 0, new byte[0], 0),
                "ASTERIX: the number of cells is 0, it must be from 1 to 65280");
            AssertRefused(() => video.Encode(0, double.NaN, 0, new byte[1], 0),
                "ASTERIX: the azimuth is NaN degrees, it must be from -1e6 to 1e6");
            AssertRefused(() => video.Encode(0, 1, 0, new byte[1], -1),
                "ASTERIX: the time of day is -1 s, it must be from 0 to 86400");
        }

        static void AssertRefused(TestDelegate call, string message) =>
            Assert.That(call, Throws.TypeOf<GlintException>().With.Message.EqualTo(message));
    }
}
