using System.IO;
using System.Linq;
using Glint.Cli;
using Glint.Core;
using Glint.Tests;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint verify with few rays.</summary>
public sealed class VerifyTests
{
    // A 1 m plate before the radar, 50 m away, in a picture of 2 m: half of the rays across and down hit it and
    // return.
    const string PlateText = "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3 4\n";

    string _folder, _plate, _json;

    [SetUp]
    public void MakeFiles()
    {
        _folder = Directory.CreateTempSubdirectory("glint-verify-").FullName;
        (_plate, _json) = (Path.Combine(_folder, "plate.obj"), Path.Combine(_folder, "figures.json"));
        File.WriteAllText(_plate, PlateText);
    }

    [TearDown] public void RemoveFolder() => Directory.Delete(_folder, true);

    [Test]
    public void Verify_OfAPlate_ComparesEveryRayWhenTheyAreFew()
    {
        var (code, output, error) =
            Run("verify", _plate, "--grazing", "0", "--fov", "2.29153", "--size", "64x64", "--json", _json);

        Assert.That(code, Is.EqualTo(0), error);
        var figures = JObject.Parse(File.ReadAllText(_json));
        Assert.That(figures["rays_compared"].ToObject<int>(), Is.EqualTo(64 * 64));
        Assert.That(figures["rays_same"].ToObject<int>() + figures["rays_at_edges"].ToObject<int>(),
            Is.EqualTo(64 * 64));
        Assert.That(figures["rays_wrong"].ToObject<int>(), Is.Zero);
        Assert.That(figures["received_compared"].ToObject<int>(), Is.EqualTo(1024));
        Assert.That(figures["length_difference_m"].ToObject<double>(), Is.InRange(0, VerifyCommand.LengthTolerance));
        Assert.That(figures["amplitude"].ToObject<double>(),
            Is.EqualTo(figures["amplitude_judge"].ToObject<double>()).Within(1e-3 * 32));
        Assert.That(output, Does.Contain("4,096").And.Contain("Fine").And.Contain($"written: {_json}"));
    }

    // Parallel rays 25 mm apart on a plate of 1 m: all 40 x 40 return. The picture is fitted as in glint run.
    [Test]
    public void Verify_WithSpacing_TracesThePictureThatRunTraces()
    {
        string[] radar = [_plate, "--grazing", "0", "--spacing", "0.025"];
        var (code, _, error) = Run(["verify", .. radar, "--json", _json]);
        Assert.That(code, Is.EqualTo(0), error);
        var figures = JObject.Parse(File.ReadAllText(_json));
        string folder = Path.Combine(_folder, "run");
        (code, _, error) = Run(["run", .. radar, "--out", folder]);
        Assert.That(code, Is.EqualTo(0), error);
        var row = JObject.Parse(File.ReadAllText(Path.Combine(folder, "results.json")))["rows"][0];

        Assert.That(figures["rays_emitted"].ToObject<int>(), Is.EqualTo(40 * 40));
        Assert.That(figures["rays_emitted"].ToObject<int>(), Is.EqualTo(row["rays_emitted"].ToObject<int>()));
        Assert.That(figures["rays_received"].ToObject<int>(), Is.EqualTo(row["rays_received"].ToObject<int>()));
        Assert.That(figures["amplitude"].ToObject<double>(),
            Is.EqualTo(row["amplitude"].ToObject<double>()).Within(1e-4));
    }

    [Test]
    public void Verify_OfMoreRaysThanAsked_ComparesAboutSoManyOfAllAndOfThoseReceived()
    {
        var (code, _, error) = Run("verify", _plate, "--grazing", "0", "--fov", "2.29153", "--size", "640x640",
            "--rays", "2000", "--json", _json);

        Assert.That(code, Is.EqualTo(0), error);
        var figures = JObject.Parse(File.ReadAllText(_json));
        Assert.That(figures["rays_emitted"].ToObject<int>(), Is.EqualTo(640 * 640));
        Assert.That(figures["rays_compared"].ToObject<int>(), Is.InRange(3000, 4000));
        Assert.That(figures["received_compared"].ToObject<int>(), Is.InRange(2000, 3000));
    }

    [Test]
    public void Verify_OfNoRays_IsRefused() =>
        Assert.That(Run("verify", _plate, "--rays", "0"), Is.EqualTo(
            (2, "", $"glint: --rays 0: must be from 1 to 1e9 (see glint verify --help){System.Environment.NewLine}")));

    [Test]
    public void Sample_OfAPicture_TakesAsManyOfEveryColumnAndRow()
    {
        var settings = TestRadar.Settings(120, 90);
        var rays = Enumerable.Range(0, 120 * 90).Select(pixel => new RayData { Pixel = (uint)pixel }).ToArray();
        var taken = new RaySample(settings, 0, 1000).Of(rays);
        Assert.That(taken.Length, Is.InRange(700, 1000));
        foreach (var (lines, count) in new[]
        {
            (taken.GroupBy(ray => ray.Pixel % 120), 120), (taken.GroupBy(ray => ray.Pixel / 120), 90)
        })
        {
            Assert.That(lines.Count(), Is.EqualTo(count));
            Assert.That(lines.Max(line => line.Count()) - lines.Min(line => line.Count()), Is.LessThanOrEqualTo(2));
        }
    }

    static (int code, string output, string error) Run(params string[] arguments)
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        int code =
            new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100, SharesScreen = false })
                .Run(arguments);
        return (code, output.ToString(), error.ToString());
    }
}
