using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Glint.Tests
{
    /// <summary>An array of a .npz file, read by the description of NPY format 1.0.</summary>
    sealed class NumpyReader
    {
        NumpyReader(string type, int[] sizes, double[] numbers) => (Type, Sizes, Numbers) = (type, sizes, numbers);

        public string Type { get; }

        public int[] Sizes { get; }

        /// <summary>All numbers in the order of the file, a complex one as two.</summary>
        public double[] Numbers { get; }

        public static string[] Names(string path)
        {
            using (var zip = ZipFile.OpenRead(path))
                return zip.Entries.Select(entry => entry.FullName).ToArray();
        }

        public static NumpyReader Read(string path, string name)
        {
            using (var zip = ZipFile.OpenRead(path))
            using (var file = zip.GetEntry(name + ".npy").Open())
            {
                var copy = new MemoryStream();
                file.CopyTo(copy);
                return Parse(copy.ToArray());
            }
        }

        static NumpyReader Parse(byte[] bytes)
        {
            if (bytes[0] != 0x93 || Encoding.ASCII.GetString(bytes, 1, 5) != "NUMPY" || bytes[6] != 1 || bytes[7] != 0)
                throw new FormatException("no NPY 1.0");
            int start = 10 + bytes[8] + 256 * bytes[9];
            string header = Encoding.ASCII.GetString(bytes, 10, start - 10);
            var match = Regex.Match(header,
                @"^\{'descr': '(<[a-z0-9]+)', 'fortran_order': False, 'shape': \(((?:\d+,)*)\), \} *\n$");
            if (!match.Success || start % 64 != 0)
                throw new FormatException(header);
            var sizes = match.Groups[2].Value.Split(new[] { ',' }, StringSplitOptions.RemoveEmptyEntries)
                .Select(int.Parse).ToArray();
            var numbers = new double[(bytes.Length - start) / sizeof(double)];
            Buffer.BlockCopy(bytes, start, numbers, 0, bytes.Length - start);
            return new NumpyReader(match.Groups[1].Value, sizes, numbers);
        }
    }
}
