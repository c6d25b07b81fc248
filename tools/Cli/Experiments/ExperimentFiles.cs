using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;

namespace Glint.Cli;

/// <summary>The files of glint experiments: a page of tables and plots, the plots, and all figures.</summary>
sealed class ExperimentFiles
{
    const string PageName = "experiments.md", JsonName = "experiments.json", Summary = "summary", Seas = "seas",
        Reflector = "images/corner-reflector.svg";

    static readonly string[] s_plots = [.. Experiment.All.Select(experiment => experiment.Name),
        .. Experiment.Seas.Select(pair => SnapshotsResult.NameOf(pair.Ship)), Seas];

    readonly string _path;
    readonly OutputFile _page, _json, _reflector;
    readonly Dictionary<string, OutputFile> _plots;
    readonly MarkedPage _text;

    /// <summary>Checks, before any work, that all files can be written.</summary>
    /// <param name="flag">Option that names the folder, for messages.</param>
    /// <exception cref="GlintException">
    /// The folder or a file cannot be written, or the existing page lacks a marker.
    /// </exception>
    public ExperimentFiles(string flag, string path)
    {
        if (File.Exists(path))
            throw new GlintException($"{flag} {path}: is a file, not a folder: name another folder");
        _path = path;
        string page = Path.Combine(path, PageName);
        try
        {
            Directory.CreateDirectory(Path.Combine(path, Path.GetDirectoryName(PlotName(Seas))));
            _text = new MarkedPage(page, File.Exists(page) ? File.ReadAllText(page) : "");
        }
        catch (Exception error)
            when (error is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new GlintException(
                $"{flag} {path}: cannot be used: {error.Message.TrimEnd('.')}; name another folder", error);
        }
        _page = new OutputFile(flag, page);
        _json = new OutputFile(flag, Path.Combine(path, JsonName));
        _reflector = new OutputFile(flag, Path.Combine(path, Reflector));
        _plots = s_plots.ToDictionary(name => name, name => new OutputFile(flag, Path.Combine(path, PlotName(name))));
        foreach (string name in s_plots.Append(Summary).Concat(Experiment.Seas.Select(pair => ShareOf(pair.Ship))))
            _text.Check(name);
    }

    /// <returns>The files written, for the report.</returns>
    /// <exception cref="GlintException">A file cannot be written.</exception>
    public string Write(ExperimentsResult result)
    {
        _json.Write(stream => ExperimentsJson.Write(stream, result));
        _text.Put(Summary, "How far they agree", ExperimentTables.Summary(result));
        foreach (var sweep in result.Sweeps)
            Add(sweep.Experiment.Name, sweep.Experiment.Title, ExperimentTables.Of(sweep),
                stream => ExperimentPlots.Write(stream, sweep));
        _reflector.Write(stream => ReflectorPicture.Write(stream, result.Reflector,
            result.Sweeps.Single(sweep => sweep.Experiment == Experiment.CornerReflector)));
        foreach (var (ship, angles) in result.Shares)
            _text.Put(ShareOf(ship), $"{ship.Title}: what the sea adds", ExperimentTables.Of(angles));
        foreach (var ship in result.Ships)
            Add(ship.Name, ship.Title, ExperimentTables.Of(ship), stream => ExperimentPlots.Write(stream, ship));
        Add(Seas, "Other seas", ExperimentTables.OfSeas(result),
            stream => SeaPlot.Write(stream, result.Seas, result.PublishedReturns));
        _page.Write(stream => stream.Write(Encoding.UTF8.GetBytes(_text.Text)));
        return $"{_page.Path}, {_json.Path}, "
            + $"{_plots.Count + 1} plots in {Path.Combine(_path, Path.GetDirectoryName(PlotName(Seas)))}";
    }

    void Add(string name, string title, string tables, Action<Stream> plot)
    {
        _plots[name].Write(plot);
        _text.Put(name, title, $"![{title}]({PlotName(name)})\n\n{tables}");
    }

    static string ShareOf(Experiment ship) => $"{ship.Name}-share";

    // A Markdown link, relative to the folder.
    static string PlotName(string name) => $"images/experiments-{name}.svg";
}
