using System;
using System.Collections.Generic;
using System.IO;
using System.Text;

namespace Glint.Core
{
    /// <summary>
    /// Rows as a NumPy array, a row a line and a column for each of the table's; NaN where there is no value. Written
    /// row by row: the header, which has the number of rows, has its size from the beginning.
    /// </summary>
    static class RowArray
    {
        // Bytes.
        const int HeaderLength = 128;

        /// <summary>Bytes up to the end of a number of rows.</summary>
        public static long LengthOf(int rows, ResultTable table) => HeaderLength + (long)rows * BytesOf(table);

        /// <summary>The header of a number of rows.</summary>
        public static byte[] Header(int rows, ResultTable table) =>
            NumpyArchive.HeaderOf("<f8", new[] { rows, table.Columns.Count }, HeaderLength);

        /// <summary>Writes some of a list of rows.</summary>
        public static void Write(Stream output, IReadOnlyList<StoredRow> rows, int first, int count, ResultTable table)
        {
            var bytes = new byte[BytesOf(table)];
            for (int i = first; i < first + count; i++)
            {
                rows[i].CopyTo(bytes);
                output.Write(bytes, 0, bytes.Length);
            }
        }

        /// <summary>The whole rows of a file; none if it is not there, or has no whole header.</summary>
        /// <exception cref="IOException">It cannot be read.</exception>
        /// <exception cref="FormatException">It lacks a value.</exception>
        public static IReadOnlyList<StoredRow> Read(string path, ResultTable table)
        {
            var bytes = File.Exists(path) ? File.ReadAllBytes(path) : Array.Empty<byte>();
            // An interrupted program may leave a part of the header.
            if (bytes.Length < HeaderLength)
                return Array.Empty<StoredRow>();
            string header = Encoding.ASCII.GetString(bytes, 0, HeaderLength);
            if (!header.Contains("'descr': '<f8', 'fortran_order': False")
                || !header.Contains($",{table.Columns.Count},)"))
                throw new FormatException($"{Path.GetFileName(path)} is no array of rows");
            var rows = new StoredRow[(bytes.Length - HeaderLength) / BytesOf(table)];
            for (int i = 0; i < rows.Length; i++)
            {
                var numbers = new double[table.Columns.Count];
                Buffer.BlockCopy(bytes, (int)LengthOf(i, table), numbers, 0, BytesOf(table));
                rows[i] = new StoredRow(numbers, table);
            }
            return rows;
        }

        static int BytesOf(ResultTable table) => table.Columns.Count * sizeof(double);
    }
}
