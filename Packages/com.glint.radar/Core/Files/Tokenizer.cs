using System;

namespace Glint.Core
{
    /// <summary>The words of a line, separated by blanks and control characters.</summary>
    ref struct Tokenizer
    {
        ReadOnlySpan<byte> _remaining;

        public Tokenizer(ReadOnlySpan<byte> line)
        {
            _remaining = line;
            Current = default;
        }

        public ReadOnlySpan<byte> Current { get; private set; }

        /// <summary>Whether the next word begins a comment, which extends to the end of the line.</summary>
        public bool IsComment
        {
            get
            {
                int start = StartOf(_remaining, 0);
                return start < _remaining.Length && _remaining[start] == '#';
            }
        }

        /// <summary>Goes to the next word; false at the end of the line.</summary>
        public bool Next()
        {
            int start = StartOf(_remaining, 0), end = EndOf(_remaining, start);
            Current = _remaining.Slice(start, end - start);
            _remaining = _remaining.Slice(end);
            return end > start;
        }

        /// <summary>Start of the next word, or the line's length if there is none.</summary>
        public static int StartOf(ReadOnlySpan<byte> line, int at)
        {
            while (at < line.Length && line[at] <= ' ')
                at++;
            return at;
        }

        /// <summary>End of the word at <paramref name="at"/>.</summary>
        public static int EndOf(ReadOnlySpan<byte> line, int at)
        {
            while (at < line.Length && line[at] > ' ')
                at++;
            return at;
        }
    }
}
