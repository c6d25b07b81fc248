using System;
using System.IO;

namespace Glint.Core
{
    /// <summary>
    /// Lines of a text file as bytes, without copies or strings: a mesh has millions of them.
    /// Lines end with LF or CR LF; a UTF-8 byte order mark is skipped.
    /// </summary>
    sealed class LineReader
    {
        const int FirstBuffer = 1 << 16;

        // A file with a longer line is not text; the limit keeps it from filling the memory.
        const int LongestLine = 1 << 24;

        readonly Stream _stream;
        readonly string _path;
        readonly bool _joinsContinued;
        byte[] _buffer = new byte[FirstBuffer];
        int _start, _end, _lineStart, _lineLength;
        int _nextNumber = 1;

        /// <param name="joinsContinued">
        /// A line that ends in a backslash continues in the next one, except in comments.
        /// </param>
        public LineReader(Stream stream, string path, bool joinsContinued)
        {
            _stream = stream;
            _path = path;
            _joinsContinued = joinsContinued;
            Fill();
            if (Bytes.StartsWith(Held, 0xef, 0xbb, 0xbf))
                _start = 3;
        }

        /// <summary>Number of the line, from 1; of a joined line its first.</summary>
        public int Number { get; private set; }

        /// <summary>The line without its end; valid until the next call of <see cref="Read"/>.</summary>
        public ReadOnlySpan<byte> Line => new ReadOnlySpan<byte>(_buffer, _lineStart, _lineLength);

        ReadOnlySpan<byte> Held => new ReadOnlySpan<byte>(_buffer, _start, _end - _start);

        /// <summary>Goes to the next line; false at the end of the file.</summary>
        public bool Read()
        {
            Number = _nextNumber;
            int scanned = 0, word = 0;
            while (true)
            {
                int found = Held.Slice(scanned).IndexOf((byte)'\n');
                if (found < 0)
                {
                    scanned = _end - _start;
                    if (Fill())
                        continue;
                    return scanned > 0 && Take(scanned, 0);
                }
                _nextNumber++;
                int length = scanned + found;
                if (!_joinsContinued || !TryBlankContinuation(length, ref word))
                    return Take(length, 1);
                scanned = length + 1;
            }
        }

        /// <summary>A failure at the current line.</summary>
        public GlintException Error(string message) => new GlintException($"{_path}:{Number}: {message}");

        bool Take(int length, int endLength)
        {
            _lineStart = _start;
            _lineLength = length;
            _start += length + endLength;
            if (Line.IndexOf((byte)0) >= 0)
                throw Error("the line holds binary data, but the file should be text; export it again");
            return true;
        }

        // Overwrites backslash and line end by blanks, so that the joined line is contiguous.
        // The position of its first word is cached.
        bool TryBlankContinuation(int length, ref int word)
        {
            int last = length - 1;
            if (last >= 0 && Held[last] == '\r')
                last--;
            if (last < 0 || Held[last] != '\\')
                return false;
            word = Tokenizer.StartOf(Held.Slice(0, last), word);
            if (word < last && Held[word] == '#')
                return false;
            for (int i = last; i <= length; i++)
                _buffer[_start + i] = (byte)' ';
            return true;
        }

        bool Fill()
        {
            if (_start > 0)
            {
                Held.CopyTo(_buffer);
                _end -= _start;
                _start = 0;
            }
            if (_end == _buffer.Length)
            {
                if (_end >= LongestLine)
                    throw Error($"the line is longer than {LongestLine} bytes: "
                        + "the file is not text in lines; export it again");
                Array.Resize(ref _buffer, 2 * _buffer.Length);
            }
            int read = _stream.Read(_buffer, _end, _buffer.Length - _end);
            _end += read;
            return read > 0;
        }
    }
}
