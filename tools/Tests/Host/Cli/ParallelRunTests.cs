using System.IO;
using System.Linq;
using Glint.Cli;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// glint run and sweep with parallel rays and a 1 x 1 m plate: coverage, received rays, and the files.
/// </summary>
public sealed class ParallelRunTests
{
    string _folder;

    [SetUp]
    public void MakePlate()
    {
        _folder = Directory.CreateTempSubdirectory("glint-parallel-").FullName;
        File.WriteAllText(Plate, "v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3 4\n");
    }

    [TearDown]
    public void RemovePlate() => Directory.Delete(_folder, true);

    // All paths have the same length, so the sum is the number of rays, and the rays' area is the plate's.
    [TestCase("50")]
    [TestCase("100000")]
    public void Run_OfAPlateSeenHeadOn_ReceivesEveryRayInPhase(string distance)
    {
        var (code, output, error) =
            Run("run", Plate, "--grazing", "0", "--distance", distance, "--spacing", "0.03125", "--out", Results);

        Assert.That(code, Is.EqualTo(0), error);
        Assert.That(output, Does.Contain("0.000976562 m2 a ray"));
        var row = Json["rows"].Single();
        Assert.That(new[] { "rays_emitted", "rays_hit", "rays_received" }.Select(name => row[name].ToObject<int>()),
            Is.EqualTo(new[] { 1024, 1024, 1024 }));
        Assert.That(row["amplitude"].ToObject<double>(), Is.EqualTo(1024).Within(1e-3));
        Assert.That(row["ray_area_m2"].ToObject<double>(), Is.EqualTo(1 / 1024.0).Within(1e-12));
        Assert.That(row["largest_path_step_wavelengths"].ToObject<double>(), Is.EqualTo(0).Within(1e-4));
    }

    [Test]
    public void Run_OverAnAperture_MissesBesideThePlate()
    {
        var (code, _, error) = Run("run", Plate, "--grazing", "0", "--spacing", "0.0625", "--aperture", "3x2",
            "--receiver", "5", "--out", Results);

        Assert.That(code, Is.EqualTo(0), error);
        var row = Json["rows"].Single();
        Assert.That(new[] { "rays_emitted", "rays_hit", "rays_received" }.Select(name => row[name].ToObject<int>()),
            Is.EqualTo(new[] { 48 * 32, 256, 256 }));
        Assert.That(Text("projection") + " " + Text("aperture"), Is.EqualTo("parallel given"));
        Assert.That(
            Numbers("rays_across", "rays_down", "aperture_width", "aperture_height", "ray_spacing", "receiver_width"),
            Is.EqualTo(new[] { 48, 32, 3, 2, 0.0625, 5 }).Within(1e-12));
        Assert.That(Json["settings"]["vertical_fov"], Is.Null);
    }

    [Test]
    public void Sweep_OfAPlate_IsFittedAtEachAngle()
    {
        var (code, _, error) =
            Run("sweep", Plate, "--angles", "0,60", "--grazing", "0", "--spacing", "0.03125", "--out", Results);

        Assert.That(code, Is.EqualTo(0), error);
        Assert.That(Json["rows"].Select(row => row["rays_emitted"].ToObject<int>()),
            Is.EqualTo(new[] { 32 * 32, 16 * 32 }), "half as wide at 60 deg");
        Assert.That(Text("projection") + " " + Text("aperture"), Is.EqualTo("parallel fitted"));
        Assert.That(Numbers("aperture_width", "aperture_height", "receiver_width", "receiver_height"),
            Is.EqualTo(new[] { 0.5, 1, 0.5, 1 }).Within(1e-12), "those of the last angle");
    }

    [Test]
    public void Run_InPerspective_SaysSoAndStatesNoArea()
    {
        Run("run", Plate, "--grazing", "0", "--size", "64x64", "--fov", "2", "--out", Results);

        Assert.That(Text("projection"), Is.EqualTo("perspective"));
        Assert.That(Numbers("vertical_fov").Single(), Is.EqualTo(2));
        Assert.That(Json["rows"][0]["ray_area_m2"].Type, Is.EqualTo(JTokenType.Null));
    }

    string Plate => Path.Combine(_folder, "plate.obj");

    string Results => Path.Combine(_folder, "results");

    JObject Json => JObject.Parse(File.ReadAllText(Path.Combine(Results, "results.json")));

    string Text(string setting) => Json["settings"][setting].ToString();

    double[] Numbers(params string[] settings) =>
        settings.Select(name => Json["settings"][name]["value"].ToObject<double>()).ToArray();

    static (int code, string output, string error) Run(params string[] arguments)
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        int code = new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100 }).Run(arguments);
        return (code, output.ToString(), error.ToString());
    }
}
