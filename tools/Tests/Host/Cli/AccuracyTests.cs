using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using System.Xml.Linq;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using Glint.Reference;
using Newtonsoft.Json.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Host.Tests;

/// <summary>Parts of glint bench --accuracy and --tubes; the whole takes minutes.</summary>
public sealed class AccuracyTests
{
    static readonly IProgress<double> s_deaf = new Progress<double>();

    // Parallel rays return in phase, so hits and sum equal the plate's share of the picture.
    [Test]
    public void Reference_OfAPlateAcrossParallelRays_IsItsShareOfThePicture()
    {
        var view = AccuracyScene.PublishedView(50, 0);
        view.ApertureHeight = 4.5; // 8 m wide
        view.ReceiverSize = 20;
        const double width = 3.21, height = 2.34;
        var reference = AccuracyReference.Of(Plate(width, height, view), RadarSettings.Default, s_deaf,
            CancellationToken.None, across: 320);

        double share = RadarResult.NormalRays * width * height / (8 * 4.5);
        Assert.That(reference.Hits, Is.EqualTo(share).Within(0.2).Percent);
        Assert.That(reference.Sum.Magnitude, Is.EqualTo(share).Within(0.2).Percent);
        Assert.That(reference.Uncertainty, Is.LessThan(0.01 * share));
    }

    [Test]
    public void Scenes_AllReturnSomething()
    {
        var settings = RadarSettings.Default;
        (settings.RaysAcross, settings.RaysDown) = (480, 270);
        foreach (var scene in AccuracyScene.All())
        {
            var referenceTracer = new ReferenceTracer(new RadarPose(scene.Scene, settings, scene.View));
            Assert.That(referenceTracer.Sum(referenceTracer.TraceAll()).RaysReceived, Is.GreaterThan(10), scene.Name);
        }
    }

    [Test]
    public void Plot_HasALineAScene_WithinThePicture()
    {
        var result = Sample();
        var stream = new MemoryStream();
        AccuracyPlot.Write(stream, result);

        var svg = XDocument.Parse(Encoding.UTF8.GetString(stream.ToArray())).Root;
        double width = (double)svg.Attribute("width"), height = (double)svg.Attribute("height");
        var lines = svg.Elements().Where(element => element.Name.LocalName == "polyline").ToArray();
        Assert.That(lines.Length, Is.EqualTo(2));
        foreach (string location in lines.SelectMany(line => line.Attribute("points").Value.Split(' ')))
        {
            var numbers = location.Split(',')
                .Select(number => double.Parse(number, System.Globalization.CultureInfo.InvariantCulture)).ToArray();
            Assert.That(numbers[0], Is.InRange(0, width));
            Assert.That(numbers[1], Is.InRange(0, height));
        }
        Assert.That(svg.Value, Does.Contain("near <1> & far").And.Contain("time of a pose"));
    }

    [Test]
    public void Json_HasErrorAndEstimateOfEachPose()
    {
        var stream = new MemoryStream();
        AccuracyJson.Write(stream, Sample());

        var pose = JObject.Parse(Encoding.UTF8.GetString(stream.ToArray()))["scenes"][0]["poses"][1];
        Assert.That(pose["rays_across"].ToObject<int>(), Is.EqualTo(960));
        // 12 rays of 960 x 540 against 40 of 1920 x 1080.
        Assert.That(pose["normalised_amplitude_error"].ToObject<double>(), Is.EqualTo(4 * 12 - 40).Within(1e-9));
        Assert.That(pose["sampling_error"].ToObject<double>(), Is.EqualTo(7));
        Assert.That(pose["trace_ms"].ToObject<double>(), Is.EqualTo(20));
    }

    [Test]
    public void Tables_NameScenesAndFlags()
    {
        var terminal = new Terminal
        {
            Out = TextWriter.Null, Error = TextWriter.Null, Live = null, Width = 100, SharesScreen = false
        };
        string text = string.Join("\n", new AccuracyTables(terminal).Lines(Sample()));
        foreach (string part in new[] { "near <1> & far", "480 x 270 *", "960 x 540 ", "same" })
            Assert.That(text, Does.Contain(part));
    }

    // Of 480 to 7680 rays across, 960 are within 1 % by chance, 3840 and 7680 stay so.
    [Test]
    public void Tubes_StandBesideFewestUniformRays_FromWhichOnAllAreWithinOnePercent()
    {
        TubeRow[] rows = [.. new[] { 1.5, 1, 1.2, 1.005, 0.995 }.Select((amplitude, i) => Row(amplitude, 480 << i))];
        Assert.That(TubeSceneOf("any", [], rows).FewestUniform?.Settings.RaysAcross, Is.EqualTo(3840));
        Assert.That(TubeSceneOf("any", [], rows[..3]).FewestUniform, Is.Null);
    }

    // Errors of -1 and 4 %, 100 and 400 rays.
    [Test]
    public void TubeMeans_AreGeometricOfRaysAndMediansOfErrors()
    {
        var result = new TubeResult { Device = GraphicsDevice.Current.Info, Rounds = 1 };
        result.Scenes.Add(TubeSceneOf("few", [Row(0.99, 10)], []));
        result.Scenes.Add(TubeSceneOf("many", [Row(1.04, 40)], []));
        var mean = result.TubeMeans.Single();
        Assert.That(mean.Rays, Is.EqualTo(10 * 20).Within(1e-9).Percent);
        Assert.That(mean.Error, Is.EqualTo(0.025).Within(1e-9));
        Assert.That(mean.LargestError, Is.EqualTo(0.04).Within(1e-9));
    }

    // An error of 0 is drawn too, though the axis is logarithmic.
    [Test]
    public void TubePlot_HasALineAMethodAndPanel_WithinThePicture()
    {
        var result = new TubeResult { Device = GraphicsDevice.Current.Info, Rounds = 1 };
        result.Scenes.Add(TubeSceneOf("<odd>", [Row(1.1, 10), Row(1, 20)], [Row(3, 30), Row(1.2, 60)]));
        var stream = new MemoryStream();
        TubePlot.Write(stream, result);

        var svg = XDocument.Parse(Encoding.UTF8.GetString(stream.ToArray())).Root;
        double width = (double)svg.Attribute("width"), height = (double)svg.Attribute("height");
        Assert.That(svg.Elements().Count(element => element.Name.LocalName == "polyline"), Is.EqualTo(4));
        foreach (var dot in svg.Elements().Where(element => element.Name.LocalName == "circle"))
        {
            Assert.That((double)dot.Attribute("cx"), Is.InRange(0, width));
            Assert.That((double)dot.Attribute("cy"), Is.InRange(0, height));
        }
        Assert.That(svg.Value, Does.Contain("rays of a pose").And.Contain("milliseconds"));
    }

    // Tubes of the fourth tolerance are asked for the goal.
    [Test]
    public void RatioAtGoal_IsTheMeanOverTheScenesThatUniformRaysReach()
    {
        TubeRow[] tubes = [Row(1, 1), Row(1, 1), Row(1, 1), Row(1, 10), Row(1, 1)];
        var result = new TubeResult { Device = GraphicsDevice.Current.Info, Rounds = 1 };
        result.Scenes.Add(TubeSceneOf("four times", tubes, [Row(3, 20), Row(1.001, 40)]));
        result.Scenes.Add(TubeSceneOf("nine times", tubes, [Row(1.002, 90), Row(1.001, 180)]));
        Assert.That(result.RatioAtGoal(scene => scene.TubesAtGoal, row => row.Rays), Is.EqualTo(6).Within(1e-9).Percent);
        Assert.That(result.RatioAtGoal(scene => scene.TubesAtGoal, row => row.KernelTimes.Median), Is.EqualTo(6).Within(1e-9).Percent);
        result.Scenes.Add(TubeSceneOf("never", tubes, [Row(3, 20)]));
        Assert.That(result.RatioAtGoal(scene => scene.TubesAtGoal, row => row.Rays), Is.EqualTo(6).Within(1e-9).Percent);
    }

    [Test]
    public void TubeJson_HasErrorAndRaysOfEachMethod()
    {
        var result = new TubeResult { Device = GraphicsDevice.Current.Info, Rounds = 1 };
        result.Scenes.Add(TubeSceneOf("any", [Row(1.1, 10)], [Row(3, 30)]));
        var stream = new MemoryStream();
        TubeJson.Write(stream, result);

        var scene = JObject.Parse(Encoding.UTF8.GetString(stream.ToArray()))["scenes"][0];
        Assert.That(scene["tubes"][0]["amplitude_error_relative"].ToObject<double>(), Is.EqualTo(0.1).Within(1e-9));
        Assert.That(scene["uniform"][0]["rays"].ToObject<long>(), Is.EqualTo(300));
        Assert.That(scene["uniform"][0]["kernels_ms"].ToObject<double>(), Is.EqualTo(15));
        Assert.That(scene["uniform"][0]["rays_across"].ToObject<int>(), Is.EqualTo(30));
    }

    [Test]
    public void Accuracy_WithoutAFile_NamesOne()
    {
        Assert.That(CommandLine.Parse(Commands.Bench, ["--accuracy"]).Get(Options.Accuracy),
            Is.EqualTo("accuracy.svg"));
        Assert.That(CommandLine.Parse(Commands.Bench, ["--accuracy", "--json", "x.json"]).Get(Options.Accuracy),
            Is.EqualTo("accuracy.svg"));
        Assert.That(CommandLine.Parse(Commands.Bench, ["--accuracy", "plot.svg"]).Get(Options.Accuracy),
            Is.EqualTo("plot.svg"));
    }

    [Test]
    public void Accuracy_OfAnInput_IsRefused() =>
        Assert.That(() => CommandLine.Parse(Commands.Bench, ["boat.obj", "--accuracy", "plot.svg"]),
            Throws.TypeOf<UsageException>().With.Message.StartsWith("--accuracy: "));

    [Test]
    public void Accuracy_WithRaysOfTheUsersOwn_IsRefused() =>
        Assert.That(() => CommandLine.Parse(Commands.Bench, ["--accuracy", "plot.svg", "--size", "64x36"]),
            Throws.TypeOf<UsageException>().With.Message.Contains("--size"));

    [TestCase("--tubes", "--accuracy")]
    [TestCase("--rcs-plots", "--accuracy")]
    [TestCase("--rcs-plots", "--tubes")]
    [TestCase("--rcs-plots", "--json", "x.json")]
    public void Benchmarks_WithScenesOfTheirOwn_RefuseWhatTheyDoNotTake(params string[] line) =>
        Assert.That(() => CommandLine.Parse(Commands.Bench, line),
            Throws.TypeOf<UsageException>().With.Message.Contains($"not with {line[1]}"));

    static AccuracyScene Plate(double width, double height, RadarView view)
    {
        float x = (float)(width / 2), y = (float)(height / 2);
        return new AccuracyScene("plate", new RadarScene(new TriangleMesh([new float3(-x, -y, 0), new float3(x, -y, 0),
            new float3(x, y, 0), new float3(-x, y, 0)], [0, 1, 2, 0, 2, 3])), view);
    }

    // An amplitude of a picture ten rays high.
    static TubeRow Row(double amplitude, int across)
    {
        var settings = RadarSettings.Default;
        (settings.RaysAcross, settings.RaysDown) = (across, 10);
        var sums = new RadarSums { RaysOfPicture = settings.RayCount, RaysEmitted = settings.RayCount };
        return new TubeRow(settings, new RadarResult(sums), new Series(across), new Series(0.5 * across), amplitude - 1);
    }

    static TubeScene TubeSceneOf(string name, TubeRow[] tubes, TubeRow[] uniform)
    {
        var scene = new TubeScene(new AccuracyScene(name, new RadarScene(), default), 1, 0);
        scene.Tubes.AddRange(tubes);
        scene.Uniform.AddRange(uniform);
        return scene;
    }

    // Two made-up scenes of two poses each.
    static AccuracyResult Sample()
    {
        var result = new AccuracyResult { Device = GraphicsDevice.Current.Info, Rounds = 3 };
        foreach (string name in new[] { "near <1> & far", "other" })
        {
            var scene = new AccuracyScene(name, new RadarScene(), default);
            var converged = new AccuracyReference(40, 0.5, 1000);
            foreach (int across in new[] { 480, 960 })
            {
                var settings = RadarSettings.Default;
                (settings.RaysAcross, settings.RaysDown) = (across, across * 9 / 16);
                var sums = new RadarResult(
                    new RadarSums { InPhase = 12, RaysOfPicture = settings.RayCount, RaysHit = 200 },
                    new SamplingReport(7, 0, across == 480));
                result.Rows.Add(new AccuracyRow(scene, settings, sums, new Series(across / 48.0), converged));
            }
            result.CostScene = scene;
        }
        var usual = new RadarResult(new RadarSums { InPhase = 1 });
        result.Costs.Add(new AccuracyCost("a pose as it is", new Series(5), usual, usual));
        return result;
    }
}
