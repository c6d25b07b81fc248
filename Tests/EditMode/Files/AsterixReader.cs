using System;
using System.Collections.Generic;
using System.IO;

namespace Glint.Tests
{
    /// <summary>
    /// A video message of ASTERIX category 240, read item by item in the order of its user application profile.
    /// </summary>
    sealed class AsterixReader
    {
        readonly byte[] _bytes;
        int _at;

        AsterixReader(byte[] bytes, int at) => (_bytes, _at) = (bytes, at);

        public int AreaCode { get; private set; }

        public int IdentificationCode { get; private set; }

        public int MessageType { get; private set; }

        public long Index { get; private set; }

        public double StartDegrees { get; private set; }

        public double EndDegrees { get; private set; }

        public long StartCell { get; private set; }

        /// <summary>Seconds.</summary>
        public double CellDuration { get; private set; }

        public byte[] Cells { get; private set; }

        public double SecondsOfDay { get; private set; }

        /// <summary>Range of a cell, counted from 1, metres.</summary>
        public double RangeOf(int cell) => CellDuration * (StartCell + cell - 1) * 299792458 / 2;

        /// <summary>The messages of a file: data blocks one after the other.</summary>
        public static List<AsterixReader> Read(byte[] bytes)
        {
            var messages = new List<AsterixReader>();
            for (int at = 0; at < bytes.Length;)
            {
                Require(bytes[at] == 240, $"category {bytes[at]}");
                int length = bytes[at + 1] << 8 | bytes[at + 2];
                var message = new AsterixReader(bytes, at + 3);
                message.ReadRecord();
                at += length;
                Require(message._at == at, "the record's length");
                messages.Add(message);
            }
            return messages;
        }

        void ReadRecord()
        {
            var items = new List<int>();
            for (int item = 1, octet = 1; (octet & 1) != 0; item += 7)
            {
                octet = _bytes[_at++];
                for (int bit = 0; bit < 7; bit++)
                    if ((octet & 0x80 >> bit) != 0)
                        items.Add(item + bit);
            }
            long valid = 0, cells = 0;
            foreach (int item in items)
                switch (item)
                {
                    case 1: (AreaCode, IdentificationCode) = ((int)Number(1), (int)Number(1)); break;
                    case 2: MessageType = (int)Number(1); break;
                    case 3: Index = Number(4); break;
                    case 5: ReadHeader(1e-9); break;
                    case 6: ReadHeader(1e-15); break;
                    case 7: Require(Number(2) == 4, "compression or resolution other than 8 bits"); break;
                    case 8: (valid, cells) = (Number(2), Number(3)); break;
                    case 9: ReadCells(4, valid); break;
                    case 10: ReadCells(64, valid); break;
                    case 11: ReadCells(256, valid); break;
                    case 12: SecondsOfDay = Number(3) / 128.0; break;
                    default: throw new InvalidDataException($"item {item}");
                }
            Require(valid == cells, "octets and cells of 8 bits");
        }

        void ReadHeader(double unit)
        {
            (StartDegrees, EndDegrees) = (Number(2) * 360 / 65536.0, Number(2) * 360 / 65536.0);
            (StartCell, CellDuration) = (Number(4), Number(4) * unit);
        }

        void ReadCells(int size, long valid)
        {
            int octets = (int)Number(1) * size;
            Require(valid <= octets && valid > octets - size, "groups of cells");
            Cells = new byte[valid];
            Array.Copy(_bytes, _at, Cells, 0, valid);
            for (long i = valid; i < octets; i++)
                Require(_bytes[_at + i] == 0, "padding");
            _at += octets;
        }

        long Number(int octets)
        {
            long number = 0;
            for (int i = 0; i < octets; i++)
                number = number << 8 | _bytes[_at++];
            return number;
        }

        static void Require(bool isTrue, string text)
        {
            if (!isTrue)
                throw new InvalidDataException(text);
        }
    }
}
