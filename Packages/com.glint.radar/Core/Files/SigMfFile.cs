using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using Newtonsoft.Json;

namespace Glint.Core
{
    /// <summary>
    /// Writes range profiles, of a train of pulses for instance, as a SigMF recording: complex samples in float32,
    /// profile after profile without the pauses between them, and metadata in JSON with a capture for each. Fields of
    /// the namespace glint give times and ranges.
    /// </summary>
    public static class SigMfFile
    {
        const string SpecificationVersion = "1.2.0", NamespaceVersion = "1.0.0";

        /// <summary>Writes the samples: the content of a .sigmf-data file.</summary>
        /// <param name="output">Stays open.</param>
        /// <param name="profiles">Of <see cref="RangeTransform"/>.</param>
        public static void WriteData(Stream output, IEnumerable<IReadOnlyList<Complex>> profiles)
        {
            using (var file = new BinaryWriter(output, Encoding.ASCII, leaveOpen: true))
                foreach (var profile in profiles)
                    foreach (var sample in profile)
                    {
                        file.Write((float)sample.Real);
                        file.Write((float)sample.Imaginary);
                    }
        }

        /// <summary>Writes the metadata of a train of pulses: the content of a .sigmf-meta file.</summary>
        /// <param name="output">Stays open.</param>
        /// <param name="band">The band of the responses: its centre is the frequency of the captures.</param>
        public static void WriteMeta(TextWriter output, FrequencyBand band, RangeTransform range, PulseTrain pulses) =>
            WriteMeta(output, band, range,
                new[] { ("pulse_repetition_frequency_hz", (object)pulses.RepetitionFrequency) },
                Enumerable.Range(0, pulses.Count).Select(pulse => new[] { ("time_s", (object)pulses.TimeOf(pulse)) }));

        /// <summary>Writes the metadata of profiles of any kind.</summary>
        /// <param name="output">Stays open.</param>
        /// <param name="band">The band of the responses: its centre is the frequency of the captures.</param>
        /// <param name="global">Fields of the namespace glint that hold for all profiles.</param>
        /// <param name="captures">Fields of the namespace glint for each profile.</param>
        public static void WriteMeta(TextWriter output, FrequencyBand band, RangeTransform range,
            IEnumerable<(string name, object value)> global,
            IEnumerable<IEnumerable<(string name, object value)>> captures)
        {
            using (var json = new JsonTextWriter(output) { Formatting = Formatting.Indented, CloseOutput = false })
            {
                json.WriteStartObject();
                json.WritePropertyName("global");
                WriteGlobal(json, band, range, global);
                json.WritePropertyName("captures");
                json.WriteStartArray();
                long start = 0;
                foreach (var fields in captures)
                {
                    json.WriteStartObject();
                    Write(json, "core:sample_start", start);
                    Write(json, "core:frequency", band.Centre);
                    WriteOwn(json, fields);
                    json.WriteEndObject();
                    start += range.Cells;
                }
                json.WriteEndArray();
                json.WritePropertyName("annotations");
                json.WriteStartArray();
                json.WriteEndArray();
                json.WriteEndObject();
            }
        }

        static void WriteGlobal(JsonTextWriter json, FrequencyBand band, RangeTransform range,
            IEnumerable<(string name, object value)> own)
        {
            json.WriteStartObject();
            Write(json, "core:datatype", "cf32_le");
            Write(json, "core:version", SpecificationVersion);
            Write(json, "core:sample_rate", range.Cells * band.Step);
            Write(json, "core:recorder", "Glint " + GlintVersion.Text);
            json.WritePropertyName("core:extensions");
            json.WriteStartArray();
            json.WriteStartObject();
            Write(json, "name", "glint");
            Write(json, "version", NamespaceVersion);
            Write(json, "optional", true);
            json.WriteEndObject();
            json.WriteEndArray();
            WriteOwn(json, own);
            Write(json, "glint:samples_per_pulse", range.Cells);
            Write(json, "glint:start_range_m", range.StartRange);
            Write(json, "glint:range_step_m", range.CellSize);
            Write(json, "glint:bandwidth_hz", band.Bandwidth);
            json.WriteEndObject();
        }

        static void WriteOwn(JsonTextWriter json, IEnumerable<(string name, object value)> fields)
        {
            foreach (var (name, value) in fields)
                Write(json, "glint:" + name, value);
        }

        static void Write(JsonTextWriter json, string name, object value)
        {
            json.WritePropertyName(name);
            json.WriteValue(value);
        }
    }
}
