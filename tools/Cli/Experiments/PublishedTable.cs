using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Glint.Core;

namespace Glint.Cli;

/// <summary>Reads the tables of the published experiment, which this project stores beside the tests that hold it to them.</summary>
static class PublishedTable
{
    const string Folder = "Packages/com.glint.tests/PlayMode/Data";
    const int Columns = 5;

    /// <param name="project">Folder of the project that holds it.</param>
    /// <param name="name">Of the file, without its extension.</param>
    /// <returns>The rows in the order of the table.</returns>
    /// <exception cref="GlintException">It is not there, or malformed.</exception>
    public static IReadOnlyList<PublishedRow> Read(string project, string name)
    {
        string path = new ProjectPaths(project).ToPhysicalPath($"{Folder}/{name}.csv");
        string[] lines;
        try
        {
            lines = File.ReadAllLines(path);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            throw new GlintException($"{path}: the published table cannot be read: {error.Message.TrimEnd('.')}; work in the whole Glint project, Tests included", error);
        }
        return [.. lines.Skip(1).Select((line, i) => ReadRow(line) ?? throw new GlintException(
            $"{path}: line {i + 2} is not a step, an amplitude, rays received, rays hit and their ratio: restore the file from the project's repository"))];
    }

    static PublishedRow ReadRow(string line)
    {
        var cells = line.Split(',');
        return cells.Length == Columns && TryReal(cells[0], out double step) && TryReal(cells[1], out double amplitude) && TryCount(cells[2], out long received) && TryCount(cells[3], out long hit)
            ? new PublishedRow(step, amplitude, received, hit)
            : null;
    }

    static bool TryReal(string cell, out double value) => double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    static bool TryCount(string cell, out long value) => long.TryParse(cell, NumberStyles.None, CultureInfo.InvariantCulture, out value);
}
