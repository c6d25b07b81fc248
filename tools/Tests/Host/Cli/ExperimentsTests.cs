using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Glint.Cli;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Parts of glint experiments; the whole takes minutes.</summary>
[Category("Slow")]
public sealed class ExperimentsTests
{
    static readonly Experiment s_odd =
        new("odd", "a <b> & | c", "none", "Scenes/Odd.unity", "--target", "Odd", "--angles", "0:30:15");

    string _folder;

    [SetUp] public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("glint-experiments-").FullName;

    [TearDown] public void RemoveFolder() => Directory.Delete(_folder, true);

    static string Root => Engine.Assets.ProjectRoot;

    static IEnumerable<Experiment> Tabled => Experiment.All.Where(experiment => experiment.Published != null);

    [TestCaseSource(nameof(Tabled))]
    public void PublishedTable_OfAnExperiment_HasARowForEachPose(object experiment)
    {
        var rows = PublishedTable.Read(((Experiment)experiment).Published);
        var line = ((Experiment)experiment).Line;
        var plan = new SweepPlan(axis => line.Get(Options.Of(axis)));
        Assert.That(rows.Select(row => row.Step),
            Is.EqualTo(Enumerable.Range(0, plan.Count).Select(pose => SweepResult.StepOf(plan[pose]))));
        // The publication's own ratio, to its last digit.
        var ratios =
            File.ReadLines(Path.Combine(Root, $"{PublishedTable.Folder}/{((Experiment)experiment).Published}.csv"))
                .Skip(1).Select(row => double.Parse(row.Split(',')[4], CultureInfo.InvariantCulture));
        Assert.That(rows.Zip(ratios, (row, ratio) => Math.Abs(row.Ratio - ratio)).Max(), Is.LessThan(1e-8));
    }

    [Test]
    public void PublishedTable_OfTheSea_IsThePublishedOne()
    {
        var rows = PublishedTable.Read(Experiment.Seas[1].Sea.Published);
        Assert.That(rows.Select(row => row.RaysReceived), Is.EqualTo(new[] { 387, 0, 0, 7, 0, 1240, 0, 0, 1, 0 }));
        Assert.That(rows.Min(row => row.RaysHit), Is.EqualTo(1257377));
        Assert.That(rows[0].Amplitude, Is.EqualTo(48.20876));
    }

    [TestCase("0,1,2,3")]
    [TestCase("0,nan,2,3,0.5")]
    [TestCase("0,1,2.5,3,0.5")]
    [TestCase("0,1,-2,3,0.5")]
    [TestCase("")]
    public void PublishedTable_WithABadRow_IsRefusedByItsLine(string row)
    {
        string text = $"step,amplitude,rays_received,rays_hit,ratio\n0,1,2,3,0.5\n{row}\n1,1,2,3,0.5\n";
        Assert.That(() => PublishedTable.Parse(text, "t.csv"),
            Throws.TypeOf<GlintException>().With.Message.Contains("t.csv: line 3 "));
    }

    [Test]
    public void PublishedTable_ThatIsNotThere_IsNamed() =>
        Assert.That(() => PublishedTable.Read("table_z"),
            Throws.TypeOf<GlintException>().With.Message.Contains("table_z.csv: the published table is missing"));

    // In the second pose neither receives rays.
    [Test]
    public void Agreement_OfTwiceAsMuch_IsSixDecibelsMore()
    {
        var agreement = new Agreement(Odd((10, 4), (0, 0), (6, 2)));
        Assert.That(agreement.Hit.Median, Is.EqualTo(2));
        Assert.That(agreement.Received.Lowest, Is.EqualTo(2));
        Assert.That(agreement.Received.Highest, Is.EqualTo(2));
        Assert.That(agreement.AmplitudeDb.Median, Is.EqualTo(20 * Math.Log10(2)).Within(1e-12));
        Assert.That(agreement.HitDifferencePercent.Mean, Is.EqualTo(100));
        Assert.That((agreement.ReceivedDifference.Mean, agreement.ReceivedDifference.Highest), Is.EqualTo((2, 4)));
        Assert.That(agreement.AmplitudeDifferenceDb.Highest, Is.EqualTo(20 * Math.Log10(2)).Within(1e-12));
        Assert.That((agreement.Both, agreement.Neither), Is.EqualTo((2, 1)));
        Assert.That(agreement.AmplitudeCorrelation, Is.EqualTo(1).Within(1e-12));
    }

    [Test]
    public void Table_OfASweep_HasTheirsBesideOurs()
    {
        var rows = Cells(ExperimentTables.Of(Odd((10, 4), (0, 0), (6, 2))));
        Assert.That(rows.Length, Is.EqualTo(3));
        Assert.That(rows[0],
            Is.EqualTo(new[] { "0", "10.00", "20.00", "4", "8", "1,000", "2,000", "0.4000", "0.4000", "+6.0" }));
        Assert.That(rows[1],
            Is.EqualTo(new[] { "15", "0.00", "0.00", "0", "0", "1,000", "2,000", "0.0000", "0.0000", "-" }));
    }

    [Test]
    public void Table_WithoutAPublishedOne_HasOurs()
    {
        var sweep = Odd((10, 4), (0, 0), (6, 2)) with { Published = null };
        Assert.That(Cells(ExperimentTables.Of(sweep))[2], Is.EqualTo(new[] { "30", "12.00", "4", "2,000", "0.2000" }));
    }

    // Received 0, 10, 20 at the first angle and twice that at the second.
    [Test]
    public void Table_OverSnapshots_HasMedianAndRange()
    {
        var rows = Cells(ExperimentTables.Of(OddShips()));
        Assert.That(rows[0],
            Is.EqualTo(new[] { "0", "5.00", "10.00", "0.00", "20.00", "7", "10", "0", "20", "900", "1,000" }));
        Assert.That(rows[1],
            Is.EqualTo(new[] { "15", "5.00", "20.00", "0.00", "40.00", "7", "20", "0", "40", "900", "1,000" }));
    }

    [Test]
    public void Tables_OfSeas_TellWhereTheStoredSeedStands()
    {
        var result = OddResult();
        string text = ExperimentTables.OfSeas(result);
        // 1 of 2 snapshots returns, then 2, 0 and 1.
        Assert.That(Cells(text)[0], Is.EqualTo(
            new[] { "Odd, as stored", "9", "1", "4 of 8", "50.0", "1 (0 to 2)", "1 of 4", "1 of 2", "1, 1, 1" }));
        Assert.That(text, Does.Contain("| 7 (stored) | 1 | 0 5 |"));
    }

    [Test]
    public void Summary_ComparesEachSweepThatHasATable()
    {
        var result = OddResult();
        result.Sweeps.Add(result.Sweeps[0] with { Published = null });
        string text = ExperimentTables.Summary(result);
        Assert.That(Cells(text).Single(), Is.EqualTo(new[] { @"a &lt;b> & \| c", "3", "2.000 (2.000 to 2.000)", "2, 1",
            "2.00 (2.00 to 2.00)", "+6.0 (+6.0 to +6.0)", "1.000" }));
        Assert.That(text, Does.Contain(result.Device.Name));
    }

    [Test]
    public void Plots_AreWithinThePicture_AndNameWhatTheyShow()
    {
        var (result, ships) = (OddResult(), OddShips());
        var plots = new (Action<Stream> write, int lines)[]
        {
            // Amplitude 0 breaks the line, so none of the three poses has a neighbour.
            (stream => ExperimentPlots.Write(stream, result.Sweeps[0]), 4),
            (stream => ExperimentPlots.Write(stream, result.Sweeps[0] with { Published = null }), 2),
            (stream => ExperimentPlots.Write(stream, ships), 6),
            (stream => ReflectorPicture.Write(stream, OddViews(), result.Sweeps[0]), 2),
            (stream => SeaPlot.Write(stream, result.Seas, _ => (4, 10)), 0),
        };
        foreach (var (write, lines) in plots)
        {
            var stream = new MemoryStream();
            write(stream);
            var svg = XDocument.Parse(Encoding.UTF8.GetString(stream.ToArray())).Root;
            Assert.That(svg.Elements().Count(element => element.Name.LocalName == "polyline"), Is.EqualTo(lines));
            Assert.That(svg.Value, Does.Contain("a <b> & | c").Or.Contain("received").Or.Contain("return rays"));
            foreach (var (x, y) in Points(svg))
            {
                Assert.That(x, Is.InRange(0, (double)svg.Attribute("width")));
                Assert.That(y, Is.InRange(0, (double)svg.Attribute("height")));
            }
        }
    }

    [Test]
    public void Scales_ShowWhatIsMarkedWhereItIsMarked()
    {
        foreach (var (scale, value, position) in new (ValueScale, double, double)[]
        {
            (ValueScale.Linear(1_400_000), 700_000, 0.5), (ValueScale.Linear(0), 0, 0), (ValueScale.Counts(1000), 0, 0),
            (ValueScale.Counts(1000), 1, 0.25), (ValueScale.Counts(1000), 1000, 1),
            (ValueScale.Decibels(100), 100, 1), (ValueScale.Decibels(100), 1, 1 / 3.0),
            (ValueScale.Decibels(100), 1e-9, 0),
            (ValueScale.Decibels(100), 0, double.NaN), (ValueScale.Decibels(0), 1, 1),
        })
        {
            Assert.That(scale.Of(value), Is.EqualTo(position).Within(1e-12));
            Assert.That(scale.Marks.Count, Is.InRange(2, 8));
            Assert.That(scale.Marks.Select(mark => mark.Position), Is.Ordered);
            Assert.That(scale.Marks[0].Position, Is.Zero);
            Assert.That(scale.Marks[^1].Position, Is.EqualTo(1).Within(1e-12));
        }
    }

    [Test]
    public void Json_HasEveryPoseAndEverySeed()
    {
        var result = OddResult();
        result.Ships.Add(OddShips());
        var stream = new MemoryStream();
        ExperimentsJson.Write(stream, result);
        var json = JObject.Parse(Encoding.UTF8.GetString(stream.ToArray()));
        Assert.That(json["sweeps"][0]["rows"].Count(), Is.EqualTo(3));
        Assert.That(json["sweeps"][0]["published"][2]["amplitude"].ToObject<double>(), Is.EqualTo(6));
        Assert.That(json["ships"][0]["rows"].Count(), Is.EqualTo(6));
        Assert.That(json["ships"][0]["rows"][5]["snapshot"].ToObject<int>(), Is.EqualTo(3));
        Assert.That(json["seas"][0]["seeds"].Select(seed => seed["returning"].ToObject<int>()),
            Is.EqualTo(new[] { 1, 2, 0, 1 }));
        Assert.That(json["seas"][0]["seeds"][1]["rays_received"].ToObject<long[]>(), Is.EqualTo(new[] { 3, 4 }));
    }

    [Test]
    public void Page_KeepsWhatStandsAroundTheMarkers()
    {
        var page = new MarkedPage("page.md", "words\n<!-- measured: a -->\nold\n<!-- end of a -->\nmore\n");
        page.Put("a", "A", "new\n");
        page.Put("b", "B", "first\n");
        Assert.That(page.Text, Is.EqualTo("words\n<!-- measured: a -->\nnew\n<!-- end of a -->\nmore\n\n## B\n\n"
            + "<!-- measured: b -->\nfirst\n<!-- end of b -->\n"));
    }

    [TestCase("<!-- measured: seas -->\n")]
    [TestCase("<!-- end of seas -->\n")]
    [TestCase("<!-- end of seas -->\n<!-- measured: seas -->\n")]
    public void Experiments_IntoAPageWithHalfAMarker_AreRefusedBeforeAnyWork(string page)
    {
        File.WriteAllText(Path.Combine(_folder, "experiments.md"), page);
        var (code, output, error) = Run("experiments", "--out", _folder);
        Assert.That((code, output), Is.EqualTo((1, "")));
        Assert.That(error, Does.StartWith("glint: ").And.Contain("measured: seas").And.Not.Contain("internal error"));
    }

    [Test]
    public void Experiments_IntoAFile_AreRefusedBeforeAnyWork()
    {
        string file = Path.Combine(_folder, "file");
        File.WriteAllText(file, "");
        var (code, output, error) = Run("experiments", "--out", file);
        Assert.That((code, output), Is.EqualTo((1, "")));
        Assert.That(error.Split('\n', StringSplitOptions.RemoveEmptyEntries).Single(),
            Does.StartWith($"glint: --out {file}: "));
    }

    [Test]
    public void Experiments_WhosePlotCannotBeWritten_AreRefusedBeforeAnyWork()
    {
        Directory.CreateDirectory(Path.Combine(_folder, "images/experiments-seas.svg"));
        var (code, output, error) = Run("experiments", "--out", _folder);
        Assert.That((code, output), Is.EqualTo((1, "")));
        Assert.That(error, Does.Contain("experiments-seas.svg").And.Contain("cannot be written"));
    }

    [TestCase("x.unity", "one argument too many", "experiments", "x.unity")]
    [TestCase("--seeds 0", "must be from 1 to 1000", "experiments", "--seeds", "0")]
    [TestCase("--seeds 2.5", "whole number", "experiments", "--seeds", "2.5")]
    [TestCase("--angles", "no such option", "experiments", "--angles", "0:1:1")]
    [TestCase("--out", "needs a value", "experiments", "--out")]
    public void Experiments_WrongCall_IsOneLineAndExitCode2(string what, string why, params string[] arguments)
    {
        var (code, output, error) = Run(arguments);
        Assert.That((code, output), Is.EqualTo((2, "")));
        Assert.That(error.Split('\n', StringSplitOptions.RemoveEmptyEntries).Single(),
            Does.StartWith("glint: ").And.Contain(what).And.Contain(why));
    }

    [Test]
    public void Seeds_BeginWithTheStoredOne_AndAreAllDifferent()
    {
        Assert.That(SeaStudy.Seeds(3, 5), Is.EqualTo(new[] { 3, 1, 2, 4, 5 }));
        Assert.That(SeaStudy.Seeds(9, 4), Is.EqualTo(new[] { 9, 1, 2, 3 }));
        Assert.That(SeaStudy.Seeds(9, 1), Is.EqualTo(new[] { 9 }));
    }

    // Two of its poses with all rays.
    [Test]
    public void Sweep_OfTheCornerReflector_HitsAsPublished()
    {
        var sweep = new ExperimentRuns(new LogProgress())
            .Sweep(Experiment.CornerReflector with { Options = ["--target", "Corner Reflector", "--angles", "0,45"] });
        var agreement = new Agreement(sweep);
        Assert.That(agreement.Poses, Is.EqualTo(2));
        Assert.That(agreement.HitDifferencePercent.Highest, Is.LessThan(0.03));
        Assert.That(agreement.AmplitudeDifferenceDb.Highest, Is.LessThan(1), "at 0 degrees; at 45 nothing returns");
        Assert.That(sweep.Poses.Select(pose => pose.Ours.RaysReceived), Is.EqualTo(new[] { 676, 0 }));
    }

    // The stored meshes are the sea of the stored seed. A hundredth of the rays.
    [Test]
    public void Study_OfTheStoredSeed_IsTheStoredSea()
    {
        var sea = WithSmallPicture(Experiment.Seas[1].Sea);
        var runs = new ExperimentRuns(new LogProgress());
        var stored = runs.Sweep(sea).Rows.Select(row => row.Result).ToArray();
        var families = runs.Study(sea, StoredSeas.All.Single(recipe => recipe.Name == "SeaState6"), 1);

        Assert.That(families.Count(family => family.IsStored), Is.EqualTo(1));
        Assert.That(families[0].IsStored);
        Assert.That(families[0].First.Snapshots.Select(snapshot => (snapshot.RaysHit, snapshot.Bounces)),
            Is.EqualTo(stored.Select(snapshot => (snapshot.RaysHit, snapshot.Bounces))));
        Assert.That(
            families.Select(family => (family.First.Waves.WindSpeed, family.First.Waves.Choppiness)), Is.Unique);
        foreach (var waves in families.Select(family => family.First.Waves))
            Assert.That(Math.Sqrt(StoredSeas.All[0]
                    .Times.Average(time => Math.Pow(new SeaSurface(waves).MeasuredWaveHeight(time), 2))),
                Is.EqualTo(waves.SignificantWaveHeight).Within(1e-9));
    }

    // The ship's own scene shows one of the snapshots.
    [Test]
    public void ShipOnAllSnapshots_HasThatOfItsScene()
    {
        var (sea, ship) = (Experiment.Seas[1].Sea, Experiment.Seas[1].Ship);
        var runs = new ExperimentRuns(new LogProgress());
        ship = WithSmallPicture(ship with { Options = ["--target", "Ship", "--angles", "60"] });
        var all = runs.SweepAllSnapshots(sea, ship).Rows;
        var alone = runs.Sweep(ship).Rows;

        Assert.That(all.Count, Is.EqualTo(10));
        Assert.That(all.Select(row => (row.Result.RaysHit, row.Result.Bounces)),
            Does.Contain((alone[0].Result.RaysHit, alone[0].Result.Bounces)));
    }

    // The page's published numbers are those of the tables.
    [TestCaseSource(nameof(Tabled))]
    public void PageOfTheDocumentation_HasEveryPublishedRow(object experiment)
    {
        string page = File.ReadAllText(Path.Combine(Root, "Packages/com.glint.radar/Documentation~/experiments.md")),
            name = ((Experiment)experiment).Name;
        string measured = Between(page, name);
        var published = PublishedTable.Read(((Experiment)experiment).Published);
        Assert.That(Cells(measured).Select(cells => $"{cells[0]} {cells[1]} {cells[3]} {cells[5]}"),
            Is.EqualTo(published.Select(row => FormattableString.Invariant(
                $"{row.Step} {row.Amplitude:0.00} {row.RaysReceived:#,0} {row.RaysHit:#,0}"))));
        Assert.That(File.Exists(Path.Combine(Root, "Packages/com.glint.radar/Documentation~",
            Regex.Match(measured, @"\]\(([^)]*)\)").Groups[1].Value)));
    }

    [Test]
    public void PageOfTheDocumentation_HasTheShipOnEverySnapshot_AndTheSeas()
    {
        string page = File.ReadAllText(Path.Combine(Root, "Packages/com.glint.radar/Documentation~/experiments.md"));
        foreach (var (_, ship) in Experiment.Seas)
            Assert.That(Cells(Between(page, SnapshotsResult.NameOf(ship))).Length, Is.EqualTo(25));
        string seas = Between(page, "seas");
        foreach (var stored in StoredSeas.All)
        {
            Assert.That(seas, Does.Contain($"| {stored.Name}, as stored | {Numbers.Format(stored.Settings.WindSpeed)} "
                + $"| {Numbers.Format(stored.Settings.Choppiness)} |"));
            Assert.That(seas, Does.Contain($"| {stored.Settings.Seed} (stored) |"));
        }
    }

    static Experiment WithSmallPicture(Experiment experiment) =>
        experiment with { Options = [.. experiment.Options, "--size", "192x108"] };

    static string Between(string page, string name)
    {
        string begin = $"<!-- measured: {name} -->", end = $"<!-- end of {name} -->";
        Assert.That(page, Does.Contain(begin).And.Contain(end));
        return page[(page.IndexOf(begin) + begin.Length)..page.IndexOf(end)];
    }

    // Rows of the first table of a text.
    static string[][] Cells(string markdown) => [.. markdown.Split('\n').SkipWhile(line => !line.StartsWith("| ---"))
        .Skip(1).TakeWhile(line => line.StartsWith('|'))
        .Select(line => Regex.Split(line, @"(?<!\\)\|")[1..^1].Select(cell => cell.Trim()).ToArray())];

    static IEnumerable<(double x, double y)> Points(XElement svg)
    {
        double Number(XElement element, string name) =>
            double.Parse(element.Attribute(name).Value, CultureInfo.InvariantCulture);
        foreach (var element in svg.Elements())
        {
            if (element.Attribute("points") is { } points)
                foreach (string location in points.Value.Split(' '))
                    yield return (double.Parse(location.Split(',')[0], CultureInfo.InvariantCulture),
                        double.Parse(location.Split(',')[1], CultureInfo.InvariantCulture));
            foreach (var (x, y) in new[] { ("x", "y"), ("cx", "cy"), ("x1", "y1"), ("x2", "y2") })
                if (element.Attribute(x) != null)
                    yield return (Number(element, x), Number(element, y));
        }
    }

    // Each pose has the published amplitude and rays received; ours are twice as large.
    static SweepResult Odd(params (double amplitude, long received)[] poses) => new(s_odd,
        [.. poses.Select((pose, i) => new PublishedRow(15 * i, pose.amplitude, pose.received, 1000))],
        [.. poses.Select(
            (pose, i) => new SweepRow(new SweepPose(15 * i), Received(2 * pose.amplitude, 2 * pose.received)))]);

    static SnapshotsResult OddShips() =>
        new("odd-all", s_odd.Title, [new PublishedRow(0, 5, 7, 900), new PublishedRow(15, 5, 7, 900)],
            [.. from snapshot in new[] { 1, 2, 3 } from angle in new[] { 0, 15 } let much = 10
                * (snapshot - 1) * (1 + angle / 15)
                select new SweepRow(new SweepPose(angle, snapshot), Received(much, much, 1000))]);

    // Two pixels with one bounce, received, in a picture of 4 x 3.
    static RadarPreviewImage[] OddViews() => [.. ReflectorPicture.Angles.Select(_ =>
    {
        var picture = new RadarPreviewImage(4, 3, new RayRegion { Width = 4, Height = 3 });
        var hits = new[] { new PathHit { Position = new(0, 0, 1), Direction = new(0, 0, -1) } };
        foreach (uint pixel in new uint[] { 5, 6 })
            picture.Set(new RayPath { Pixel = pixel, Hits = hits, End = default(Unity.Mathematics.double3) });
        return picture;
    })];

    static ExperimentsResult OddResult()
    {
        SeaTrial Trial(int seed, params long[] received) =>
            new(SeaSettings.Default with { WindSpeed = 9, Seed = seed },
                [.. received.Select(count => Received(count, count))]);
        var result = new ExperimentsResult { Device = GraphicsDevice.Current.Info };
        result.Sweeps.Add(Odd((10, 4), (0, 0), (6, 2)));
        result.Seas.Add(new SeaFamily("Odd", true, [Trial(7, 0, 5), Trial(1, 3, 4), Trial(2, 0, 0), Trial(3, 1, 0)]));
        return result;
    }

    static RadarResult Received(double amplitude, long received, long hit = 2000) =>
        new(new RadarSums { InPhase = amplitude, RaysReceived = received, RaysHit = hit });

    static (int code, string output, string error) Run(params string[] arguments)
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        int code =
            new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100, SharesScreen = false })
                .Run(arguments);
        return (code, output.ToString(), error.ToString());
    }
}
