using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Numerics;
using System.Text;

namespace Glint.Core
{
    /// <summary>
    /// Writes arrays as numpy.load reads them: a ZIP archive, not compressed, of files in NPY format 1.0. The same
    /// arrays give the same bytes.
    /// </summary>
    public sealed class NumpyArchive : IArrayFile
    {
        // Magic text, two bytes of version, two of the header's length.
        const int PrefixLength = 10, Alignment = 64;

        // Written at once.
        const int BlockNumbers = 1 << 13;

        // The earliest time that a ZIP archive can hold.
        static readonly DateTimeOffset s_time = new DateTimeOffset(1980, 1, 1, 0, 0, 0, TimeSpan.Zero);

        readonly ZipArchive _zip;

        /// <param name="output">Receives the archive; stays open.</param>
        public NumpyArchive(Stream output) => _zip = new ZipArchive(output, ZipArchiveMode.Create, leaveOpen: true);

        /// <inheritdoc/>
        public void Add(string name, int[] sizes, IEnumerable<double> values) => Write(name, "<f8", sizes, values);

        /// <inheritdoc/>
        public void Add(string name, int[] sizes, IEnumerable<Complex> values) =>
            Write(name, "<c16", sizes, PartsOf(values));

        /// <summary>The arrays of real numbers in an archive that was written so, by their names.</summary>
        /// <exception cref="IOException">It cannot be read.</exception>
        /// <exception cref="InvalidDataException">It is no such archive.</exception>
        public static IReadOnlyDictionary<string, double[]> Read(string path)
        {
            using (var zip = ZipFile.OpenRead(path))
                return zip.Entries.ToDictionary(entry => Path.GetFileNameWithoutExtension(entry.Name), Read);
        }

        static double[] Read(ZipArchiveEntry entry)
        {
            using (var file = new BinaryReader(new BufferedStream(entry.Open(), 1 << 16)))
            {
                byte[] prefix = file.ReadBytes(PrefixLength);
                int header = prefix.Length < PrefixLength ? 0 : BitConverter.ToUInt16(prefix, PrefixLength - 2);
                if (!Encoding.ASCII.GetString(file.ReadBytes(header)).StartsWith("{'descr': '<f8'", StringComparison.Ordinal))
                    throw new InvalidDataException($"{entry.Name} holds no real numbers");
                var bytes = file.ReadBytes((int)entry.Length - PrefixLength - header);
                var numbers = new double[bytes.Length / sizeof(double)];
                Buffer.BlockCopy(bytes, 0, numbers, 0, bytes.Length);
                return numbers;
            }
        }

        /// <summary>Ends the archive.</summary>
        public void Dispose() => _zip.Dispose();

        static IEnumerable<double> PartsOf(IEnumerable<Complex> values)
        {
            foreach (var value in values)
            {
                yield return value.Real;
                yield return value.Imaginary;
            }
        }

        void Write(string name, string type, int[] sizes, IEnumerable<double> numbers)
        {
            var entry = _zip.CreateEntry(name + ".npy", CompressionLevel.NoCompression);
            entry.LastWriteTime = s_time;
            using (var file = entry.Open())
            {
                var header = HeaderOf(type, sizes);
                file.Write(header, 0, header.Length);
                var block = new double[BlockNumbers];
                var bytes = new byte[BlockNumbers * sizeof(double)];
                int count = 0;
                void WriteBlock()
                {
                    Buffer.BlockCopy(block, 0, bytes, 0, count * sizeof(double));
                    file.Write(bytes, 0, count * sizeof(double));
                    count = 0;
                }
                foreach (double number in numbers)
                {
                    block[count++] = number;
                    if (count == block.Length)
                        WriteBlock();
                }
                WriteBlock();
            }
        }

        /// <summary>The bytes before the numbers of an array.</summary>
        /// <param name="atLeast">Bytes, so that a header with other sizes is as long.</param>
        internal static byte[] HeaderOf(string type, int[] sizes, int atLeast = 0)
        {
            string header = $"{{'descr': '{type}', 'fortran_order': False, 'shape': "
                + $"({string.Concat(sizes.Select(size => size + ","))}), }}";
            int length = Math.Max(atLeast, (PrefixLength + header.Length + Alignment) / Alignment * Alignment)
                - PrefixLength;
            return new byte[]
                {
                    0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0, (byte)length, (byte)(length >> 8)
                }.Concat(Encoding.ASCII.GetBytes(header.PadRight(length - 1) + "\n")).ToArray();
        }
    }
}
