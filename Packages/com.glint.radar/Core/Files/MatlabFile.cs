using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;

namespace Glint.Core
{
    /// <summary>
    /// Writes arrays as MATLAB loads them: a MAT-file of version 5, not compressed. Indices have the order that they
    /// have in <see cref="NumpyArchive"/>; an array of one index is a column. The same arrays give the same bytes.
    /// </summary>
    public sealed class MatlabFile : IArrayFile
    {
        // Types of data elements, and the class of arrays of doubles with its flag for complex ones.
        const int Int8 = 1, Int32 = 5, UInt32 = 6, Double = 9, Matrix = 14;
        const uint DoubleClass = 6, ComplexFlag = 0x800;

        // Text of the header; bytes of a tag, to whose multiple elements are padded; those that a tag itself can hold;
        // characters of a name.
        const int HeaderText = 116, TagLength = 8, SmallElement = 4, LongestName = 63;

        /// <summary>Numbers that a complex array has at most.</summary>
        public const int MaxComplexNumbers = (int.MaxValue - 1024) / (2 * sizeof(double));

        readonly BinaryWriter _file;

        /// <param name="output">Receives the file; stays open.</param>
        public MatlabFile(Stream output)
        {
            _file = new BinaryWriter(output, Encoding.ASCII, leaveOpen: true);
            _file.Write(Encoding.ASCII.GetBytes("MATLAB 5.0 MAT-file, written by Glint".PadRight(HeaderText)));
            // No data of a subsystem, version 1.0, and the order of bytes.
            _file.Write(0L);
            _file.Write((ushort)0x0100);
            _file.Write(new[] { (byte)'I', (byte)'M' });
        }

        /// <inheritdoc/>
        /// <exception cref="GlintException">The name is none of MATLAB's, or the array is too large.</exception>
        public void Add(string name, int[] sizes, IEnumerable<double> values) =>
            Write(name, sizes, 0, new[] { ByColumns(sizes, values.ToArray()) });

        /// <inheritdoc/>
        /// <exception cref="GlintException">The name is none of MATLAB's, or the array is too large.</exception>
        public void Add(string name, int[] sizes, IEnumerable<Complex> values)
        {
            var array = ByColumns(sizes, values.ToArray());
            Write(name, sizes, ComplexFlag, new[]
            {
                array.Select(value => value.Real).ToArray(), array.Select(value => value.Imaginary).ToArray()
            });
        }

        /// <summary>Ends the file.</summary>
        public void Dispose() => _file.Dispose();

        void Write(string name, int[] sizes, uint flag, double[][] parts)
        {
            if (name.Length > LongestName || name.Length == 0 || !IsLetter(name[0])
                || !name.All(c => IsLetter(c) || c >= '0' && c <= '9' || c == '_'))
                throw new GlintException($"MAT-file: the name \"{name}\" must have letters, digits and _, a letter "
                    + $"first, and at most {LongestName} characters");
            int[] dimensions = sizes.Length > 1 ? sizes : new[] { sizes.Length == 1 ? sizes[0] : 1, 1 };
            long length = 2 * TagLength + ElementLength(sizeof(int) * dimensions.Length) + ElementLength(name.Length)
                + parts.Sum(part => ElementLength((long)sizeof(double) * part.Length));
            if (length > int.MaxValue)
                throw new GlintException($"MAT-file: the array {name} takes {length} bytes, the format has at most "
                    + $"{int.MaxValue}: write it as NPZ");

            WriteTag(Matrix, (int)length);
            WriteElement(UInt32, BitConverter.GetBytes(DoubleClass | flag).Concat(new byte[4]).ToArray());
            WriteElement(Int32, ToBytes(dimensions));
            WriteElement(Int8, Encoding.ASCII.GetBytes(name));
            foreach (double[] part in parts)
                WriteElement(Double, ToBytes(part));
        }

        // Elements of at most four bytes lie in the second half of their tag.
        void WriteElement(int type, byte[] data)
        {
            if (IsSmall(data.Length))
                _file.Write(data.Length << 16 | type);
            else
                WriteTag(type, data.Length);
            _file.Write(data);
            int tag = IsSmall(data.Length) ? TagLength - SmallElement : TagLength;
            _file.Write(new byte[ElementLength(data.Length) - data.Length - tag]);
        }

        void WriteTag(int type, int length)
        {
            _file.Write(type);
            _file.Write(length);
        }

        static bool IsSmall(long length) => length > 0 && length <= SmallElement;

        static long ElementLength(long length) =>
            IsSmall(length) ? TagLength : TagLength + (length + TagLength - 1) / TagLength * TagLength;

        static bool IsLetter(char c) => c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z';

        static byte[] ToBytes(Array numbers)
        {
            var bytes = new byte[Buffer.ByteLength(numbers)];
            Buffer.BlockCopy(numbers, 0, bytes, 0, bytes.Length);
            return bytes;
        }

        // The first index changes fastest in MATLAB.
        static T[] ByColumns<T>(int[] sizes, T[] values)
        {
            Require.Equal("MAT-file", "values of an array", values.Length, sizes.Aggregate(1, (a, b) => a * b));
            var columns = new T[values.Length];
            var index = new int[sizes.Length];
            for (int i = 0; i < values.Length; i++)
            {
                int to = 0;
                for (int axis = sizes.Length - 1; axis >= 0; axis--)
                    to = to * sizes[axis] + index[axis];
                columns[to] = values[i];
                for (int axis = sizes.Length - 1; axis >= 0 && ++index[axis] == sizes[axis]; axis--)
                    index[axis] = 0;
            }
            return columns;
        }
    }
}
