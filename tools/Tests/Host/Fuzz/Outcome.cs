using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Glint.Core;

namespace Glint.Host.Tests;

public enum Verdict
{
    Done,
    Refused,
    Finding
}

/// <summary>Result of a case: done, refused in one clear line, or a finding, described by the text.</summary>
public readonly partial record struct Outcome(Verdict Verdict, string Text)
{
    // Words of .NET that tell nothing about the user's file.
    static readonly string[] ForeignWords = ["Exception", "internal error", "Object reference", "(Parameter '",
        "Index was out", "Unable to cast", "System.", "Arg_"];

    public static Outcome Done => new(Verdict.Done, "");

    public static Outcome Finding(string text) => new(Verdict.Finding, text);

    /// <summary>A refusal if the message is one line and names a subject or a quoted object; else a finding.</summary>
    public static Outcome Refused(string message, IEnumerable<string> subjects) =>
        Unclear(message, subjects) is string why ? Finding($"{why}: {message}") : new Outcome(Verdict.Refused, message);

    /// <summary>Result of a direct call of a reader.</summary>
    public static Outcome Of(Func<Outcome> work, IEnumerable<string> subjects)
    {
        try
        {
            return work();
        }
        catch (GlintException error)
        {
            return Refused(error.Message, subjects);
        }
        catch (Exception error)
        {
            return Finding(error.ToString());
        }
    }

    /// <summary>Result of a command, from its output and exit code.</summary>
    public static Outcome OfCommand(int code, string output, string error, IEnumerable<string> subjects)
    {
        var lines = error.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        if (lines.FirstOrDefault(line => !MessageLine().IsMatch(line)) is not null)
            return Finding($"an unexpected line in messages: {error}");
        var failures = lines.Where(line => line.StartsWith("glint: ")).ToArray();
        if (code == 0)
            return failures.Length > 0 ? Finding($"exit code 0 and a failure: {error}") : NotFinite()
                .IsMatch(output) ? Finding($"numbers that are not finite: {output}") : Done;
        // glint verify reports wrong rays, which a damaged mesh may have; the command itself did not fail.
        if (code == 1 && failures.Length == 0 && output.Contains("wrong: pixel "))
            return Done;
        if (code is not (1 or 2) || failures.Length != 1 || lines[^1] != failures[0])
            return Finding($"exit code {code} and {failures.Length} failures: {error}{output}");
        return Refused(failures[0], subjects);
    }

    static string Unclear(string message, IEnumerable<string> subjects)
    {
        if (ForeignWords.FirstOrDefault(message.Contains) is string foreign)
            return $"'{foreign}' in the message";
        return QuotedName().IsMatch(message) || subjects.Any(message.Contains) ? null : "a message that names nothing";
    }

    // The last line may be progress: "ship: 1 of 1 in 0 s".
    [GeneratedRegex(@"^(glint: |warning: |.*: (\d+ of \d+|\d+ % done))")]
    private static partial Regex MessageLine();

    [GeneratedRegex(@"\b(NaN|Infinity)\b|∞")]
    private static partial Regex NotFinite();

    [GeneratedRegex("'[^']*'|\"[^\"]*\"")]
    private static partial Regex QuotedName();
}
