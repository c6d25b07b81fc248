using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Glint.Tests
{
    /// <summary>Arrays of a MAT-file of version 5, read by the published description of the format.</summary>
    sealed class MatlabReader
    {
        MatlabReader(string name, int[] sizes, double[] real, double[] imaginary) =>
            (Name, Sizes, Real, Imaginary) = (name, sizes, real, imaginary);

        public string Name { get; }

        public int[] Sizes { get; }

        /// <summary>In the order of the file: the first index changes fastest.</summary>
        public double[] Real { get; }

        /// <summary>Null for a real array.</summary>
        public double[] Imaginary { get; }

        public static List<MatlabReader> Read(byte[] bytes)
        {
            string header = Encoding.ASCII.GetString(bytes, 0, 116);
            if (!header.StartsWith("MATLAB 5.0 MAT-file", StringComparison.Ordinal)
                || BitConverter.ToUInt16(bytes, 124) != 0x0100 || bytes[126] != 'I' || bytes[127] != 'M')
                throw new FormatException(header);
            var arrays = new List<MatlabReader>();
            for (int at = 128; at < bytes.Length;)
            {
                var (type, data) = Element(bytes, ref at);
                Assert(type == 14, $"element {type} is no array");
                arrays.Add(Array(data));
            }
            return arrays;
        }

        static MatlabReader Array(byte[] bytes)
        {
            int at = 0;
            var (flagsType, flags) = Element(bytes, ref at);
            var (sizesType, sizes) = Element(bytes, ref at);
            var (nameType, name) = Element(bytes, ref at);
            Assert(flagsType == 6 && flags.Length == 8 && sizesType == 5 && nameType == 1, "types of the parts");
            Assert(flags[0] == 6 && (flags[1] & ~8) == 0, "class of the array");
            double[] real = Doubles(bytes, ref at), imaginary = flags[1] == 8 ? Doubles(bytes, ref at) : null;
            Assert(at == bytes.Length, "bytes after the array");
            return new MatlabReader(Encoding.ASCII.GetString(name),
                Enumerable.Range(0, sizes.Length / 4).Select(i => BitConverter.ToInt32(sizes, 4 * i)).ToArray(),
                real, imaginary);
        }

        static double[] Doubles(byte[] bytes, ref int at)
        {
            var (type, data) = Element(bytes, ref at);
            Assert(type == 9, $"element {type} holds no doubles");
            return Enumerable.Range(0, data.Length / 8).Select(i => BitConverter.ToDouble(data, 8 * i)).ToArray();
        }

        static (int type, byte[] data) Element(byte[] bytes, ref int at)
        {
            Assert(at % 8 == 0, "elements begin at multiples of 8");
            int type = BitConverter.ToInt32(bytes, at), length = BitConverter.ToInt32(bytes, at + 4), start = at + 8;
            if (type >> 16 != 0)
                (type, length, start) = (type & 0xFFFF, type >> 16, at + 4);
            Assert(start + length <= bytes.Length, "the element ends after its file");
            at = (start + length + 7) / 8 * 8;
            return (type, bytes.Skip(start).Take(length).ToArray());
        }

        static void Assert(bool isTrue, string text)
        {
            if (!isTrue)
                throw new FormatException(text);
        }
    }
}
