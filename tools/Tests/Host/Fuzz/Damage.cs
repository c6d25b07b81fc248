using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Glint.Host.Tests;

/// <summary>Ways to damage a file: random bytes, and changes of lines, numbers, references and YAML.</summary>
static partial class Damage
{
    const int LongestRepetition = 100_000;

    static readonly string[] Numbers =
    [
        "nan", "NaN", ".nan", "inf", "-inf", "Infinity", "-1", "0", "-0", "1", "2", "3", "5", "1e-45", "-1e-40",
        "1e-320", "1e38", "-3.5e38", "1e308", "1e999", "0.1", "1e7", "10000001", "255", "65536",
        "2147483647", "-2147483648", "4294967295", "4294967296", "9223372036854775807", "-9223372036854775808",
        "99999999999999999999", "340282366920938463463374607431768211456", "0x10", "1_000", "1,5", "١", ""
    ];

    static readonly string[] Values =
    [
        "", "[]", "{}", "{a: b}", "[a, b]", "{fileID: 0}", "{fileID: -1}", "{fileID: x}",
        "{fileID: 1, guid: 0, type: 3}", "{fileID: 4300000, guid: 0000000000000000e000000000000000, type: 0}",
        "{fileID: 1, guid: \"a\\nb\", type: 3}", "{instanceID: 0}", "{x: 1}", "{x: {y: z}}", "{? x : 1}", "{{}: 1}",
        "\"a\\nb\"", "\"\\0\"", "\"\\x\"", "'", "\"", "|", ">", "|9", "&a b", "*a", "!!binary x", "!u!1 x", "? x",
        "- x", "a: b", "#", "@", "%", "`", "\t", "~", "null", "true", "<hex>", "{<hex>: 00}", "{<hex>: []}",
        "{<hex>: 00, <edits>: [[size, 3]]}", "a.Array.size", "a.Array.data[2147483647]",
        "m_Children.Array.size", "..", "a'b", "\ud83d"
    ];

    static readonly string[] Splinters =
    [
        "nan", "-", "1e999", "-1e-999", "99999999999999999999", "\0", "\\\n", "\\", "\r", "\n", "\r\n", "#",
        "/", "//", "-1", "0", "\u00ef\u00bb\u00bf", "\u00ff\u00fe", "\u00ff\u00ff", " ", "\t", "{",
        "}", "[", "]", ": ", "- ", "---", "--- !u!1 &1\n",
        "...\n", "%YAML 1.1\n", "<<<<<<< HEAD\n", "f 1 2 3 4 5\n", "f -1 -2 -3\n", "v 1 2 3\n", "solid ", "endsolid",
        "facet normal 0 0 0", "guid: 0\n", "version https://git-lfs.github.com/spec/v1\n"
    ];

    /// <summary>The content with one to three changes.</summary>
    /// <param name="others">Files to take lines from.</param>
    public static byte[] Of(byte[] content, Random random, IReadOnlyList<byte[]> others)
    {
        // One character a byte, so that nothing is lost in the conversion.
        string text = Encoding.Latin1.GetString(content);
        for (int count = random.Next(1, 4); count > 0; count--)
            text = random.Next(3) == 0 ? OfBytes(text, random) : OfLines(text, random, others);
        return Encoding.Latin1.GetBytes(text);
    }

    static string OfBytes(string text, Random random)
    {
        int at = random.Next(text.Length + 1), length = random.Next(Math.Min(60, text.Length - at) + 1);
        string before = text[..at], part = text.Substring(at, length), after = text[(at + length)..];
        return random.Next(6) switch
        {
            0 => before + string.Concat(
                part.Select(letter => random.Next(20) == 0 ? (char)(letter ^ 1 << random.Next(8)) : letter)) + after,
            1 => before,
            2 => before + after,
            3 => before + part + part + after,
            4 => before + Pick(Splinters, random) + part + after,
            _ => before + string.Concat(part.Select(_ => (char)random.Next(256))) + after
        };
    }

    static string OfLines(string text, Random random, IReadOnlyList<byte[]> others)
    {
        switch (random.Next(12))
        {
            case 0: return Replace(text, Number(), random, _ => Latin(Pick(Numbers, random)));
            case 1: return Replace(text, Number(), random, _ => Latin(Pick(Numbers, random)));
            case 2: return Replace(text, FileId(), random, old => Other(text, FileId(), old, random));
            case 3:
                return Replace(text, Guid(), random,
                old => Other(text + Encoding.Latin1.GetString(Pick(others, random)), Guid(), old, random));
            case 4: return Replace(text, Value(), random, _ => Latin(Pick(Values, random)));
            case 5: return Replace(text, Key(), random, old => Other(text, Key(), old, random));
            case 6:
                return Replace(text, Indent(), random,
                old => new string(' ', Math.Max(0, old.Length + random.Next(-2, 3))));
            case 7:
                return Replace(text, Document(), random,
                old => random.Next(2) == 0 ? "" : old + Replace(old, FileId(), random, _ => Pick(Numbers, random)));
            case 8:
                return Replace(text, Value(), random,
                old => Repeated(random.Next(2) == 0 ? old : Pick(Splinters, random), random));
            case 9: return Lines(text, random, Encoding.Latin1.GetString(Pick(others, random)).Split('\n'));
            default: return Lines(text, random, text.Split('\n'));
        }
    }

    // Removes lines, or inserts copies of lines elsewhere.
    static string Lines(string text, Random random, string[] source)
    {
        var lines = text.Split('\n').ToList();
        int first = random.Next(source.Length), count = Math.Min(random.Next(1, 12), source.Length - first);
        if (random.Next(2) == 0)
            lines.InsertRange(random.Next(lines.Count + 1), source.Skip(first).Take(count));
        else
            lines.RemoveRange(first = random.Next(lines.Count), Math.Min(count, lines.Count - first));
        return string.Join('\n', lines);
    }

    static string Replace(string text, Regex what, Random random, Func<string, string> by)
    {
        var found = what.Matches(text);
        if (found.Count == 0)
            return OfBytes(text, random);
        var match = found[random.Next(found.Count)];
        return text[..match.Index] + by(match.Value) + text[(match.Index + match.Length)..];
    }

    static string Repeated(string text, Random random) =>
        string.Concat(Enumerable.Repeat(text, Math.Min(random.Next(1, 2000), LongestRepetition / (text.Length + 1))));

    static string Other(string text, Regex what, string old, Random random)
    {
        var found = what.Matches(text);
        return found.Count == 0 ? old : found[random.Next(found.Count)].Value;
    }

    static T Pick<T>(IReadOnlyList<T> items, Random random) => items[random.Next(items.Count)];

    static string Latin(string text) => Encoding.Latin1.GetString(Encoding.UTF8.GetBytes(text));

    [GeneratedRegex(@"(?<![\w.])-?\d[\d.]*(e[+-]?\d+)?(?![\w.])")]
    private static partial Regex Number();

    [GeneratedRegex(@"(?<=fileID: |&)-?\d+")]
    private static partial Regex FileId();

    [GeneratedRegex(@"(?<=guid: )\w+")]
    private static partial Regex Guid();

    [GeneratedRegex(@"(?<=: |- )[^\r\n]*")]
    private static partial Regex Value();

    [GeneratedRegex(@"[\w<>]+(?=:)")]
    private static partial Regex Key();

    [GeneratedRegex(@"(?<=\n) *")]
    private static partial Regex Indent();

    [GeneratedRegex(@"(?<=\n)--- !u![^\n]*\n([^-\n][^\n]*\n)*")]
    private static partial Regex Document();
}
