using System;
using System.IO;
using System.Text;
using Glint.Core;

namespace Glint.Host;

/// <summary>Reads the content of a project file and refuses unreadable files by name.</summary>
internal static class AssetText
{
    const int ProbeBytes = 4096;

    internal static string Read(string physicalPath, string shownPath)
    {
        byte[] bytes = ReadBytes(physicalPath, shownPath);
        return Encoding.UTF8.GetString(bytes.AsSpan().StartsWith(Encoding.UTF8.Preamble) ? bytes.AsSpan(3) : bytes);
    }

    /// <summary>Text of a scene, prefab or asset; the file must begin like Unity's YAML.</summary>
    internal static string ReadYaml(string physicalPath, string shownPath)
    {
        string text = Read(physicalPath, shownPath);
        if (text.Length == 0)
            throw new GlintException($"{shownPath}: is empty, or a pipe or device instead of a file: restore the file");
        if (text.AsSpan(0, Math.Min(text.Length, ProbeBytes)).Contains('\0'))
            throw new GlintException(
                $"{shownPath}: is serialized as binary: set Asset Serialization to Force Text (Edit, Project Settings, "
                + "Editor) and save it again");
        if (!text.StartsWith("%YAML ", StringComparison.Ordinal))
            throw new GlintException($"{shownPath}: is not a Unity YAML file, "
                + "it does not begin with '%YAML 1.1': restore the file");
        return text;
    }

    internal static byte[] ReadBytes(string physicalPath, string shownPath)
    {
        try
        {
            // Pipes and devices have length 0 too, and opening one may block.
            if (new FileInfo(physicalPath).Length == 0)
                return [];
            byte[] bytes = File.ReadAllBytes(physicalPath);
            if (bytes.AsSpan().StartsWith("version https://git-lfs"u8))
                throw new GlintException($"{shownPath}: is a git-lfs pointer, "
                    + "not the file's content: run 'git lfs pull'");
            return bytes;
        }
        catch (Exception error) when (error is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new GlintException($"{shownPath}: no such file", error);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            throw new GlintException($"{shownPath}: cannot be read: {error.Message}", error);
        }
    }
}
