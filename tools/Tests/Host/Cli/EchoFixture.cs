using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>A folder with the mesh of a plate, and what glint echo writes about it.</summary>
public abstract class EchoFixture
{
    // Metres and hertz.
    protected const double C = 299792458, Width = 0.3, Height = 0.2, Frequency = 10e9, Wavelength = C / Frequency,
        Range = 2.5;

    string _folder;

    // A plate 2.5 m behind the origin as seen from azimuth 0.
    [SetUp]
    public void MakePlate()
    {
        _folder = Directory.CreateTempSubdirectory("glint-echo-").FullName;
        File.WriteAllText(At("plate.obj"),
            "v -0.15 -0.1 2.5\nv 0.15 -0.1 2.5\nv 0.15 0.1 2.5\nv -0.15 0.1 2.5\nf 1 2 3 4\n");
    }

    [TearDown]
    public void RemovePlate() => Directory.Delete(_folder, true);

    protected List<Dictionary<string, string>> Table(string path)
    {
        var lines = File.ReadAllLines(At(path)).Select(line => line.Split(',')).ToArray();
        return [.. lines.Skip(1).Select(cells =>
            lines[0].Zip(cells).ToDictionary(cell => cell.First, cell => cell.Second))];
    }

    protected static double Number(Dictionary<string, string> row, string column) =>
        double.Parse(row[column], CultureInfo.InvariantCulture);

    /// <summary>The data of a report.</summary>
    protected JObject DataOf(string path)
    {
        string page = File.ReadAllText(At(path));
        const string start = "<script type=\"application/json\" id=\"data\">";
        int from = page.IndexOf(start) + start.Length;
        return JObject.Parse(page[from..page.IndexOf("</script>", from)]);
    }

    protected string At(string name) => Path.Combine(_folder, name);

    protected static string Run(params string[] arguments)
    {
        var (code, output, error) = Execute(arguments);
        Assert.That(code, Is.Zero, error);
        return output;
    }

    /// <summary>The options are refused for the plate, and no folder is made.</summary>
    protected void AssertRefused(int code, string message, string[] options)
    {
        var (actual, _, error) = Execute([At("plate.obj"), .. options, "--out", At("echo")]);
        Assert.That(error, Does.Contain(message));
        Assert.That(actual, Is.EqualTo(code));
        Assert.That(Directory.Exists(At("echo")), Is.False);
    }

    protected static (int code, string output, string error) Execute(params string[] arguments) =>
        TestShell.Run(["echo", .. arguments]);
}
