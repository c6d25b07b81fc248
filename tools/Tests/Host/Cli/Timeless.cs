using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace Glint.Host.Tests;

/// <summary>
/// Result files without the values that differ between runs of the same sweep: started_utc and all names ending in
/// _ms.
/// </summary>
static class Timeless
{
    public static string Csv(string folder)
    {
        var lines = File.ReadAllText(Path.Combine(folder, "results.csv")).Split('\n')
            .Select(line => line.Split(',')).ToArray();
        int time = System.Array.IndexOf(lines[0], "trace_ms");
        return string.Join("\n", lines.Select(line => string.Join(",", line.Where((_, i) => i != time))));
    }

    public static string Json(string folder) =>
        Regex.Replace(File.ReadAllText(Path.Combine(folder, "results.json")),
            "\"([a-z_]+_ms|started_utc)\": ?[^\n,}]*", "\"$1\"");
}
