using System;
using System.Collections.Generic;
using System.Globalization;
using Glint.Core;

namespace Glint.Host;

/// <summary>
/// The objects of a scene, prefab or asset file. The headers are parsed here, since they are not standard YAML.
/// </summary>
internal sealed class UnityFile
{
    const string HeaderStart = "--- ";
    const int ShownCharacters = 60;

    readonly List<UnityDocument> _documents = new();

    UnityFile(string shownPath) => ShownPath = shownPath;

    /// <summary>Path for messages, relative to the project.</summary>
    internal string ShownPath { get; }

    internal IReadOnlyList<UnityDocument> Documents => _documents;

    /// <exception cref="GlintException">A header is malformed, or two objects have the same id.</exception>
    internal static UnityFile Parse(string text, string shownPath)
    {
        UnityFile file = new(shownPath);
        HashSet<long> ids = new();
        int start = 0, line = 0;
        Header open = default;
        while (start < text.Length)
        {
            line++;
            int end = text.IndexOf('\n', start);
            end = end < 0 ? text.Length : end;
            if (string.CompareOrdinal(text, start, HeaderStart, 0, HeaderStart.Length) == 0)
            {
                file.Close(open, text, start);
                open = file.ReadHeader(text.AsSpan(start, end - start).TrimEnd('\r'), line, end + 1);
                if (!ids.Add(open.Id))
                    throw file.Damaged(line, $"a second object &{open.Id}");
            }
            else if (string.CompareOrdinal(text, start, "<<<<<<<", 0, 7) == 0)
            {
                throw new GlintException($"{shownPath}:{line}: has an unresolved merge conflict: resolve it");
            }
            start = end + 1;
        }
        file.Close(open, text, text.Length);
        if (file._documents.Count == 0)
            throw new GlintException($"{shownPath}: holds no object: restore the file");
        return file;
    }

    void Close(Header open, string text, int end)
    {
        if (open.Line > 0)
            _documents.Add(new UnityDocument(ShownPath, open.ClassId, open.Id, open.IsStripped, text,
                Math.Min(open.Content, end)..end, open.Line + 1));
    }

    Header ReadHeader(ReadOnlySpan<char> header, int line, int content)
    {
        const string ClassMark = "!u!", IdMark = " &", Stripped = " stripped";
        ReadOnlySpan<char> rest = header[HeaderStart.Length..];
        bool isStripped = rest.EndsWith(Stripped, StringComparison.Ordinal);
        if (isStripped)
            rest = rest[..^Stripped.Length];
        int gap = rest.IndexOf(IdMark, StringComparison.Ordinal);
        if (gap > 0 && rest.StartsWith(ClassMark, StringComparison.Ordinal)
            && int.TryParse(rest[ClassMark.Length..gap], NumberStyles.None,
                CultureInfo.InvariantCulture, out int classId)
            && long.TryParse(rest[(gap + IdMark.Length)..], NumberStyles.AllowLeadingSign,
                CultureInfo.InvariantCulture, out long id) && id != 0)
            return new Header(classId, id, isStripped, content, line);
        ReadOnlySpan<char> shown = header[..Math.Min(header.Length, ShownCharacters)];
        throw Damaged(line, $"'{shown}' is not a header of the form '--- !u!CLASS &ID'");
    }

    GlintException Damaged(int line, string what) => new($"{ShownPath}:{line}: damaged: {what}: restore the file");

    readonly record struct Header(int ClassId, long Id, bool IsStripped, int Content, int Line);
}
