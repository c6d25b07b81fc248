using System.Collections.Generic;
using System.Diagnostics;
using System.Text;
using System.Threading;
using Glint.Core;
using Glint.Editor;

namespace Glint.Cli;

/// <summary>Another program that is timed in turns with Glint's poses. The shell starts it once a round.</summary>
sealed class Peer(PeerCommand command)
{
    /// <summary>Placeholder in a command for the path of the scene.</summary>
    public const string ScenePlaceholder = "{scene}";

    readonly Dictionary<string, Series> _series = [];

    public string Name => command.Name;

    public string Command => command.Command;

    /// <summary>True if the command needs the scene as a file.</summary>
    public bool WantsScene => Command.Contains(ScenePlaceholder);

    /// <summary>Times that it prints, in its order.</summary>
    public IReadOnlyList<string> Labels { get; private set; } = [];

    /// <summary>The last line that it printed, usually its sums.</summary>
    public string LastLine { get; private set; }

    /// <summary>Median of a time in each start.</summary>
    public Series SeriesOf(string label) => _series[label];

    /// <summary>Runs the program to its end.</summary>
    /// <param name="scene">Path that replaces {scene}.</param>
    /// <param name="counts">False for a warm-up.</param>
    /// <exception cref="GlintException">It failed, or printed no time.</exception>
    /// <exception cref="System.OperationCanceledException">Cancelled; the program was ended.</exception>
    public void Run(string scene, bool counts, CancellationToken cancel)
    {
        var output = new PeerOutput(Execute(Command.Replace(ScenePlaceholder, Quoted(scene)), cancel));
        if (output.Labels.Count == 0)
            throw new GlintException($"--peer {Name}: printed no time, which is a number before \" ms\" as in \"frame "
                + $"81.3 ms\"; its last line: {output.LastLine ?? "none"}");
        LastLine = output.LastLine;
        if (!counts)
            return;
        foreach (string label in output.Labels)
        {
            if (!_series.ContainsKey(label))
                Labels = [.. Labels, label];
            _series.TryAdd(label, new Series());
            _series[label].Add(output.Median(label));
        }
    }

    string Execute(string line, CancellationToken cancel)
    {
        cancel.ThrowIfCancellationRequested();
        var start = new ProcessStartInfo("/bin/sh")
        {
            RedirectStandardOutput = true, RedirectStandardError = true, RedirectStandardInput = true,
            UseShellExecute = false
        };
        start.ArgumentList.Add("-c");
        start.ArgumentList.Add(line);
        var text = new StringBuilder();
        using var process = new Process { StartInfo = start };
        process.OutputDataReceived += (_, data) => Append(text, data.Data);
        process.ErrorDataReceived += (_, data) => Append(text, data.Data);
        process.Start();
        using (cancel.Register(() => process.Kill(entireProcessTree: true)))
        {
            process.StandardInput.Close();
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            process.WaitForExit();
        }
        cancel.ThrowIfCancellationRequested();
        if (process.ExitCode != 0)
            throw new GlintException($"--peer {Name}: ended with exit code {process.ExitCode}: "
                + $"{new PeerOutput(text.ToString()).LastLine ?? "without a word"}");
        return text.ToString();
    }

    // A thread for each stream.
    static void Append(StringBuilder text, string line)
    {
        lock (text)
            text.Append(line).Append('\n');
    }

    // Quotes for the shell: within single quotes only the closing quote is special.
    static string Quoted(string path) => path == null ? "" : "'" + path.Replace("'", "'\\''") + "'";
}
