using System;
using System.IO;
using System.Text;

namespace Glint.Host;

/// <summary>Reads the guid of a .meta file, which is near its beginning.</summary>
internal static class MetaFile
{
    internal const string Extension = ".meta";
    const int GuidDigits = 32;
    const int UsualBytes = 256;

    /// <summary>Null if the file is missing or has no guid.</summary>
    internal static string ReadGuid(string physicalPath)
    {
        try
        {
            // Pipes and devices have length 0 too, and opening one may block.
            if (new FileInfo(physicalPath).Length == 0)
                return null;
            using FileStream stream =
                new(physicalPath, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, bufferSize: 0);
            Span<byte> head = stackalloc byte[UsualBytes];
            int length = stream.ReadAtLeast(head, UsualBytes, throwOnEndOfStream: false);
            return Find(Encoding.UTF8.GetString(head[..length]))
                ?? (length < UsualBytes ? null : Find(File.ReadAllText(physicalPath)));
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    static string Find(string text)
    {
        const string Key = "\nguid:";
        int start = text.IndexOf(Key, StringComparison.Ordinal);
        if (start < 0)
            return null;
        ReadOnlySpan<char> guid = text.AsSpan(start + Key.Length).TrimStart(' ');
        return guid.Length < GuidDigits ? null : guid[..GuidDigits].ToString().ToLowerInvariant();
    }
}
