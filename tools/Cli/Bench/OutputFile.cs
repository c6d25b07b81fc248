using System;
using System.Collections.Generic;
using System.IO;
using Glint.Core;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>
/// A file that is written at the end of the work. Its path is checked before, so that hours of work are not lost.
/// </summary>
sealed class OutputFile
{
    readonly string _flag, _path;

    /// <param name="flag">Option that names it, for messages.</param>
    /// <exception cref="GlintException">It cannot be written.</exception>
    public OutputFile(string flag, string path)
    {
        _flag = flag;
        _path = path;
        Try(() => FileDraft.Check(path));
    }

    /// <summary>The file of an option; null if it is not given.</summary>
    /// <exception cref="UsageException">It is the input.</exception>
    /// <exception cref="GlintException">It cannot be written.</exception>
    public static OutputFile Of(CommandLine line, Option<string> option)
    {
        if (!line.IsGiven(option))
            return null;
        string path = line.Get(option);
        if (line.Input != null && System.IO.Path.GetFullPath(path) == System.IO.Path.GetFullPath(line.Input))
            throw new UsageException($"{option.Flag} {path}: is the input, which it would replace: name another file");
        return new OutputFile(option.Flag, path);
    }

    /// <summary>Files in a folder, which is created if missing.</summary>
    /// <param name="flag">Option that names the folder, for messages.</param>
    /// <exception cref="GlintException">The folder or a file cannot be written.</exception>
    public static OutputFile[] In(string flag, string folder, string[] names)
    {
        Try(flag, folder, () => Directory.CreateDirectory(folder));
        return Array.ConvertAll(names, name => new OutputFile(flag, System.IO.Path.Combine(folder, name)));
    }

    /// <summary>Refuses two options that name one file.</summary>
    /// <param name="files">Null for options not given.</param>
    /// <exception cref="UsageException">Two are one file.</exception>
    public static void RequireDifferent(params OutputFile[] files)
    {
        var seen = new Dictionary<string, OutputFile>();
        foreach (var file in files)
        {
            if (file == null || seen.TryAdd(System.IO.Path.GetFullPath(file._path), file))
                continue;
            throw new UsageException($"{file._flag} {file._path}: is the file of "
                + $"{seen[System.IO.Path.GetFullPath(file._path)]._flag} too: name another file");
        }
    }

    public string Path => _path;

    /// <exception cref="GlintException">It cannot be written.</exception>
    public void Write(Action<Stream> content) => Try(() => FileDraft.Write(_path, content));

    void Try(Action work) => Try(_flag, _path, work);

    static void Try(string flag, string path, Action work)
    {
        try
        {
            work();
        }
        catch (Exception error)
            when (error is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new GlintException(
                $"{flag} {path}: cannot be written: {error.Message.TrimEnd('.')}; name another file", error);
        }
    }
}
