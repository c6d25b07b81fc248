using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// glint echo of a scene with a sea's clutter and pulses: a tile of 16 m with waves of 2 cm, so that its facets hardly
/// move. The wind blows along -Z, towards a radar at azimuth 0.
/// </summary>
[Category("Slow")]
public sealed class EchoSeaTests : EchoFixture
{
    const double Elevation = 40;

    /// <summary>
    /// The line of Bragg waves of k = 2 (2 pi / lambda) cos(elevation): w^2 = 9.81 k + 7.2e-5 k^3, and the speed
    /// w lambda / (4 pi). Against the wind they approach, along it they recede, across it half of the power goes each way.
    /// The line has a deviation of 0.04 m/s by the coherence time of 80 ms, and the mean over some 60 independent cells
    /// one of 0.005 m/s; waves of the mesh add up to 0.01 m/s.
    /// </summary>
    [Test]
    public void DopplerLine_OfTheSea_IsThatOfTheBraggWaves()
    {
        using var scene = new TemporaryScene(Scene());
        Run(scene.Path, "--azimuth", "0,90,180", "--elevation", $"{Elevation}", "--bandwidth", "30e6",
            "--frequencies", "4", "--pulses", "64", "--prf", "50", "--polarisation", "vv", "--tolerance", "3",
            "--bounces", "1", "--detect", "os", "--false-alarm", "1e-3", "--out", At("sea"));
        double wave = 4 * Math.PI / Wavelength * Math.Cos(Elevation * Math.PI / 180),
            line = Math.Sqrt(9.81 * wave + 7.2e-5 * Math.Pow(wave, 3)) * Wavelength / (4 * Math.PI);
        var table = Table("sea/doppler.csv").ToLookup(row => Number(row, "azimuth_deg"));
        Assert.That(MeanSpeed(table[0]), Is.EqualTo(line).Within(0.02));
        Assert.That(MeanSpeed(table[180]), Is.EqualTo(-line).Within(0.02));
        double all = table[90].Sum(Power);
        foreach (int side in new[] { -1, 1 })
            Assert.That(table[90].Where(row => Math.Abs(Number(row, "speed_mps") - side * line) < 0.1).Sum(Power) / all,
                Is.EqualTo(0.5).Within(0.15), "both ways");
        // Without a radar the detector searches the cross sections with their clutter.
        Assert.That(File.ReadLines(At("sea/detections.csv")).First(), Does.EndWith("speed_mps,level_dbsm"));
    }

    // Facets of 0.5 m, 0.383 m along the line of sight; Bragg waves of 0.2 m/s.
    [Test]
    public void Run_OfFacetsLargerThanARangeBin_AndBlindToTheSea_SaysSo()
    {
        using var scene = new TemporaryScene(Scene());
        var (code, _, error) = Execute(scene.Path, "--azimuth", "0", "--elevation", $"{Elevation}", "--bandwidth", "600e6",
            "--frequencies", "4", "--pulses", "2", "--prf", "5", "--polarisation", "vv", "--tolerance", "3",
            "--bounces", "1", "--out", At("sea"));
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.Contain("a facet of the sea takes 0.383 m along the line of sight and answers from its middle, "
            + "and a range bin is 0.2498 m").And.Contain("at least 50 Cells, or --bandwidth of at most 391e6"));
        Assert.That(error, Does.Match(@"up to 0\.2\d* m/s along the line of sight.* 0\.03747 m/s, are folded"));
    }

    static double MeanSpeed(IEnumerable<Dictionary<string, string>> rows) =>
        rows.Sum(row => Power(row) * Number(row, "speed_mps")) / rows.Sum(Power);

    static double Power(Dictionary<string, string> row) => Math.Pow(10, Number(row, "vv_dbsm") / 10);

    // The Sea of the sample alone, smaller and with other waves.
    static string Scene()
    {
        string root = Project.FindRoot(AppContext.BaseDirectory),
            text = File.ReadAllText(Path.Combine(root, "Scenes/HarbourApproach.unity"));
        int from = text.IndexOf("--- !u!1 &300\n"), to = text.IndexOf("--- !u!1 &400\n");
        string sea = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + text[from..to]
            + "--- !u!1660057539 &9223372036854775807\nSceneRoots:\n  m_ObjectHideFlags: 0\n  m_Roots:\n"
            + "  - {fileID: 301}\n";
        foreach (var (before, after) in new[]
            {
                ("SignificantWaveHeight: 1", "SignificantWaveHeight: 0.02"), ("WindSpeed: 7", "WindSpeed: 5"),
                ("WindDirectionDegrees: 200", "WindDirectionDegrees: 180"), ("TileSize: 256", "TileSize: 16"),
                ("GridSize: 128", "GridSize: 32"), ("Cells: 128", "Cells: 32"), ("    Wind: 0", "    Wind: 5"),
                ("_extent: {x: 1280, y: 1280}", "_extent: {x: 16, y: 16}"), ("_centre: {fileID: 201}", "_centre: {fileID: 0}")
            })
        {
            Assert.That(sea, Does.Contain(before));
            sea = sea.Replace(before, after);
        }
        return sea;
    }
}
