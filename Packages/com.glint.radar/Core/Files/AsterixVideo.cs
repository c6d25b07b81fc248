using System;
using System.IO;

namespace Glint.Core
{
    /// <summary>
    /// Encodes radar video as EUROCONTROL ASTERIX category 240, edition 1.3: a data block of one video message, not
    /// compressed, for the range cells of one azimuth. Data blocks one after the other are a file, each alone is a UDP
    /// datagram.
    /// </summary>
    public sealed class AsterixVideo
    {
        /// <summary>The first byte of each data block.</summary>
        public const byte Category = 240;

        const byte VideoMessage = 2, EightBits = 4;

        // Items of a record, in the two bytes that list them: identifier, type, index, header with femtoseconds and
        // resolution; then counters, a block of cells, and time of day.
        const byte FirstItems = 0xE7, LastItems = 0x88;

        const int TicksASecond = 128, SecondsADay = 86400, MaxBlocks = 255;

        // Bytes of a group of cells, and the bit of the item that holds such groups.
        static readonly (int Size, byte Item)[] s_groups = { (4, 0x40), (64, 0x20), (256, 0x10) };

        readonly byte _areaCode, _identificationCode;
        readonly uint _cellDuration;
        uint _index;

        /// <param name="areaCode">SAC, system area code of the radar.</param>
        /// <param name="identificationCode">SIC, system identification code of the radar.</param>
        /// <param name="cellSize">Metres from a range cell to the next, up to 643.</param>
        /// <exception cref="GlintException">The cell size is out of its range.</exception>
        public AsterixVideo(byte areaCode, byte identificationCode, double cellSize)
        {
            // The item has 32 bits of femtoseconds.
            Require.Within("ASTERIX", "cell size", cellSize, "m", Interval.Closed(0.001, 643));
            (_areaCode, _identificationCode) = (areaCode, identificationCode);
            _cellDuration = (uint)Math.Round(2e15 * cellSize / Signal.SpeedOfLight);
        }

        /// <summary>The data block of an azimuth. Messages are numbered from 0.</summary>
        /// <param name="startDegrees">Azimuth where the cells begin, clockwise from north, any number of turns.</param>
        /// <param name="endDegrees">That of their end.</param>
        /// <param name="startCell">Number of the first cell: its range is that times the cell size.</param>
        /// <param name="cells">Levels from 0 to 255, at most 65,280.</param>
        /// <param name="secondsOfDay">Time after midnight UTC.</param>
        /// <exception cref="GlintException">No cells or too many, or a number out of its range.</exception>
        public byte[] Encode(double startDegrees, double endDegrees, uint startCell, byte[] cells, double secondsOfDay)
        {
            int largest = MaxBlocks * s_groups[s_groups.Length - 1].Size;
            Require.Count("ASTERIX", "number of cells", cells.Length, largest);
            Require.Within("ASTERIX", "time of day", secondsOfDay, "s", Interval.Closed(0, SecondsADay));
            var (size, item) = Array.Find(s_groups, group => cells.Length <= MaxBlocks * group.Size);
            int groups = (cells.Length + size - 1) / size;

            var block = new MemoryStream();
            block.WriteByte(Category);
            Write(block, 2, 0);
            block.WriteByte(FirstItems);
            block.WriteByte((byte)(LastItems | item));
            block.WriteByte(_areaCode);
            block.WriteByte(_identificationCode);
            block.WriteByte(VideoMessage);
            Write(block, 4, _index++);
            Write(block, 2, AzimuthCode(startDegrees));
            Write(block, 2, AzimuthCode(endDegrees));
            Write(block, 4, startCell);
            Write(block, 4, _cellDuration);
            Write(block, 2, EightBits);
            Write(block, 2, (uint)cells.Length);
            Write(block, 3, (uint)cells.Length);
            block.WriteByte((byte)groups);
            block.Write(cells, 0, cells.Length);
            block.Write(new byte[groups * size - cells.Length], 0, groups * size - cells.Length);
            Write(block, 3, (uint)(secondsOfDay % SecondsADay * TicksASecond));

            byte[] bytes = block.ToArray();
            (bytes[1], bytes[2]) = ((byte)(bytes.Length >> 8), (byte)bytes.Length);
            return bytes;
        }

        // Units of 360 / 2^16 degrees.
        static uint AzimuthCode(double degrees)
        {
            Require.Within("ASTERIX", "azimuth", degrees, "degrees", Interval.Closed(-1e6, 1e6));
            return (uint)(long)Math.Round(degrees / 360 * 65536) & 0xFFFF;
        }

        // Big endian.
        static void Write(Stream block, int bytes, uint value)
        {
            for (int i = bytes - 1; i >= 0; i--)
                block.WriteByte((byte)(value >> 8 * i));
        }
    }
}
