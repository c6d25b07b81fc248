using System.IO;
using System.IO.Compression;
using System.Text;

namespace Glint.Core
{
    /// <summary>Writes pictures as PNG.</summary>
    public static class PngFile
    {
        // Bits of a sample, and colour types: grey levels; red, green, blue and opacity.
        const byte Bits = 8, Grey = 0, Colour = 6;

        // Header of a zlib stream with the usual window, without a dictionary.
        static readonly byte[] s_zlib = { 0x78, 0x01 };

        /// <summary>Writes a picture of grey levels.</summary>
        /// <param name="output">Stays open.</param>
        /// <param name="levels">Row by row from the top, 0 black and 255 white.</param>
        public static void WriteGrey(Stream output, int width, byte[] levels) =>
            Write(output, width, levels, 1, Grey);

        /// <summary>Writes a picture of colours.</summary>
        /// <param name="output">Stays open.</param>
        /// <param name="pixels">Red, green, blue and opacity, row by row from the top.</param>
        public static void WriteColour(Stream output, int width, byte[] pixels) =>
            Write(output, width, pixels, 4, Colour);

        static void Write(Stream output, int width, byte[] pixels, int pixelBytes, byte colourType)
        {
            int rowBytes = width * pixelBytes, height = pixels.Length / rowBytes;
            output.Write(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A }, 0, 8);
            var header = new MemoryStream();
            WriteNumber(header, (uint)width);
            WriteNumber(header, (uint)height);
            header.Write(new[] { Bits, colourType, (byte)0, (byte)0, (byte)0 }, 0, 5);
            WriteChunk(output, "IHDR", header.ToArray());
            // Each row begins with its filter: none.
            var rows = new byte[height * (rowBytes + 1)];
            for (int row = 0; row < height; row++)
                System.Array.Copy(pixels, row * rowBytes, rows, row * (rowBytes + 1) + 1, rowBytes);
            WriteChunk(output, "IDAT", Compressed(rows));
            WriteChunk(output, "IEND", new byte[0]);
        }

        static byte[] Compressed(byte[] data)
        {
            var stream = new MemoryStream();
            stream.Write(s_zlib, 0, s_zlib.Length);
            using (var deflate = new DeflateStream(stream, CompressionLevel.Optimal, leaveOpen: true))
                deflate.Write(data, 0, data.Length);
            // Adler-32.
            uint sum = 1, sums = 0;
            foreach (byte value in data)
            {
                sum = (sum + value) % 65521;
                sums = (sums + sum) % 65521;
            }
            WriteNumber(stream, sums << 16 | sum);
            return stream.ToArray();
        }

        static void WriteChunk(Stream output, string type, byte[] data)
        {
            byte[] name = Encoding.ASCII.GetBytes(type);
            WriteNumber(output, (uint)data.Length);
            output.Write(name, 0, name.Length);
            output.Write(data, 0, data.Length);
            WriteNumber(output, ~Crc(Crc(uint.MaxValue, name), data));
        }

        // CRC-32 with the polynomial 0xEDB88320, bits in reverse order.
        static uint Crc(uint crc, byte[] data)
        {
            foreach (byte value in data)
            {
                crc ^= value;
                for (int bit = 0; bit < 8; bit++)
                    crc = (crc & 1) == 0 ? crc >> 1 : crc >> 1 ^ 0xEDB88320;
            }
            return crc;
        }

        static void WriteNumber(Stream output, uint number) => output.Write(
            new[] { (byte)(number >> 24), (byte)(number >> 16), (byte)(number >> 8), (byte)number }, 0, 4);
    }
}
