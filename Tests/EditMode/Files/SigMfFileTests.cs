using System;
using System.IO;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class SigMfFileTests
    {
        static readonly FrequencyBand s_band = new FrequencyBand(9.4e9, 1e6, 100);
        static readonly RangeTransform s_range = new RangeTransform(s_band, Window.None, 1, 1500);
        static readonly PulseTrain s_pulses = new PulseTrain(2000, 3);

        [Test]
        public void Data_IsPairsOfFloat32InLittleEndian()
        {
            var stream = new MemoryStream();
            SigMfFile.WriteData(stream, new[]
            {
                new[] { new Complex(1, -2), new Complex(0.1, 0) }, new[] { new Complex(0, 3e-7) }
            });
            byte[] bytes = stream.ToArray();
            Assert.That(bytes.Take(8), Is.EqualTo(new byte[] { 0, 0, 0x80, 0x3F, 0, 0, 0, 0xC0 }));
            Assert.That(Enumerable.Range(0, bytes.Length / 4).Select(i => BitConverter.ToSingle(bytes, 4 * i)),
                Is.EqualTo(new[] { 1, -2, 0.1f, 0, 0, 3e-7f }));
        }

        // What SigMF 1.2 requires: datatype and version, captures and annotations, in ascending order of their start;
        // extensions of three fields.
        [Test]
        public void Meta_HasTheFieldsOfTheSpecification()
        {
            using (new ForeignCulture())
            {
                var meta = Meta();
                Assert.That(meta.Properties().Select(property => property.Name),
                    Is.EqualTo(new[] { "global", "captures", "annotations" }));
                var global = (JObject)meta["global"];
                Assert.That((string)global["core:datatype"], Is.EqualTo("cf32_le"));
                Assert.That((string)global["core:version"], Does.Match(@"^\d+\.\d+\.\d+$"));
                Assert.That(global["core:extensions"].ToString(Newtonsoft.Json.Formatting.None),
                    Is.EqualTo("[{\"name\":\"glint\",\"version\":\"1.0.0\",\"optional\":true}]"));
                Assert.That(global.Properties().Select(property => property.Name.Split(':')[0]).Distinct(),
                    Is.EqualTo(new[] { "core", "glint" }));
                Assert.That(meta["captures"].Select(capture => (long)capture["core:sample_start"]),
                    Is.EqualTo(new[] { 0, 128, 256 }));
                Assert.That(meta["captures"].Select(capture => (double)capture["core:frequency"]),
                    Is.All.EqualTo(9.4495e9));
                Assert.That(meta["captures"].Select(capture => (double)capture["glint:time_s"]),
                    Is.EqualTo(new[] { 0, 0.0005, 0.001 }));
                Assert.That(meta["annotations"], Is.Empty);
            }
        }

        // As a radar's samples: time by the sample rate gives the range, the phase from pulse to pulse the speed.
        [Test]
        public void Recording_OfAMovingPoint_GivesItsRangeAndSpeed()
        {
            const double range = 1540, speed = 8;
            var stream = new MemoryStream();
            SigMfFile.WriteData(stream, Enumerable.Range(0, 3).Select(pulse =>
            {
                var grid = new PathGrid(s_band);
                grid.Add(2 * (range - speed * s_pulses.TimeOf(pulse)), 1);
                return s_range.Profile(grid.Responses());
            }));
            var global = Meta()["global"];
            int samples = (int)global["glint:samples_per_pulse"];
            byte[] bytes = stream.ToArray();
            Assert.That(bytes.Length, Is.EqualTo(3 * samples * 8));
            var iq = Enumerable.Range(0, 3 * samples).Select(i =>
                new Complex(BitConverter.ToSingle(bytes, 8 * i), BitConverter.ToSingle(bytes, 8 * i + 4))).ToArray();

            int peak = Enumerable.Range(0, samples).OrderBy(i => -iq[i].Magnitude).First();
            double time = peak / (double)global["core:sample_rate"];
            Assert.That((double)global["glint:start_range_m"] + 299792458 * time / 2, Is.EqualTo(range).Within(0.6));
            Assert.That((double)global["glint:range_step_m"] * peak + 1500, Is.EqualTo(range).Within(0.6));
            double turns = (iq[peak + samples] / iq[peak]).Phase / (2 * Math.PI),
                doppler = turns * (double)global["glint:pulse_repetition_frequency_hz"];
            Assert.That(doppler * 299792458 / 9.4495e9 / 2, Is.EqualTo(speed).Within(0.01));
        }

        static JObject Meta()
        {
            var text = new StringWriter();
            SigMfFile.WriteMeta(text, s_band, s_range, s_pulses);
            return JObject.Parse(text.ToString());
        }
    }
}
