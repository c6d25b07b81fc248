using System;
using System.IO;
using System.Text;

namespace Glint.Core
{
    /// <summary>Helpers for the bytes of a file.</summary>
    static class Bytes
    {
        const int LongestShown = 40;

        /// <summary>
        /// Reads until the buffer holds <paramref name="count"/> bytes or the stream ends; returns how many it holds.
        /// </summary>
        public static int Fill(Stream stream, byte[] buffer, int count)
        {
            int held = 0;
            while (held < count)
            {
                int read = stream.Read(buffer, held, count - held);
                if (read == 0)
                    break;
                held += read;
            }
            return held;
        }

        public static bool StartsWith(ReadOnlySpan<byte> bytes, params byte[] start) => bytes.StartsWith(start);

        public static bool StartsWith(ReadOnlySpan<byte> bytes, string ascii) =>
            bytes.Length >= ascii.Length && IsWord(bytes.Slice(0, ascii.Length), ascii);

        /// <summary>Whether the bytes are this word of lower-case ASCII letters, in any case.</summary>
        public static bool IsWord(ReadOnlySpan<byte> bytes, string lowerCase)
        {
            if (bytes.Length != lowerCase.Length)
                return false;
            for (int i = 0; i < bytes.Length; i++)
                if (bytes[i] != lowerCase[i]
                    && (bytes[i] < 'A' || bytes[i] > 'Z' || bytes[i] + ('a' - 'A') != lowerCase[i]))
                    return false;
            return true;
        }

        /// <summary>The bytes in quotes for a message, shortened to one line.</summary>
        public static string Quote(ReadOnlySpan<byte> bytes)
        {
            var text = new StringBuilder("\"");
            for (int i = 0; i < bytes.Length && i < LongestShown; i++)
                text.Append(bytes[i] >= 0x20 && bytes[i] < 0x7f ? (char)bytes[i] : '?');
            return text.Append(bytes.Length > LongestShown ? "...\"" : "\"").ToString();
        }
    }
}
