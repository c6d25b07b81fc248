using System;
using System.IO;
using System.Text;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Writes a file completely or not at all: first beside its place, under a name that Unity does not import, then moved
/// there.
/// </summary>
internal static class WholeFile
{
    static readonly UTF8Encoding _encoding = new(encoderShouldEmitUTF8Identifier: false);

    /// <param name="shownPath">Path for messages.</param>
    /// <exception cref="UnityException">The file cannot be written.</exception>
    internal static void Write(string physicalPath, string shownPath, Action<TextWriter> write)
    {
        string draft = Path.Combine(Path.GetDirectoryName(physicalPath),
            $".{Path.GetFileName(physicalPath)}.{Environment.ProcessId}.tmp");
        try
        {
            try
            {
                using (StreamWriter text = new(draft, append: false, _encoding))
                    write(text);
                File.Move(draft, physicalPath, overwrite: true);
            }
            finally
            {
                File.Delete(draft);
            }
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            throw new UnityException($"{shownPath}: cannot be written: {error.Message}", error);
        }
    }
}
