using System;
using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ResultsFolderTests
    {
        const string Header = "angle_deg,amplitude,amplitude_db,in_phase,quadrature,rays_emitted,rays_hit,"
            + "rays_received,ratio,bounces,segments,path_length_m,trace_ms,"
            + "amplitude_normalised,sampling_error,largest_path_step_wavelengths,undersampled,ray_area_m2,snapshot,"
            + "grazing_deg,range_m,frequency_hz\n";

        TemporaryFolder _folder;
        string _path;

        [SetUp]
        public void SetUp()
        {
            _folder = new TemporaryFolder();
            _path = _folder.PathOf("a/b");
        }

        [TearDown]
        public void TearDown() => _folder.Dispose();

        [Test]
        public void Open_NewFolder_LeavesNothing()
        {
            ResultsFolder.Open(_path).Dispose();
            Assert.That(Directory.Exists(_folder.PathOf("a")), Is.False);
        }

        [Test]
        public void Open_EarlierResults_AreLeftUntilTheFirstRow()
        {
            Sweep(SampleRun.Row(0));
            using (var results = ResultsFolder.Open(_path))
            {
                Assert.That(Entries(), Is.EqualTo(new[] { "results.csv", "results.json", "results.lock" }));
                results.Append(SampleRun.Row(7));
                Assert.That(Entries(), Is.EqualTo(new[] { "results.csv", "results.lock" }),
                    "the old JSON would not belong to these rows");
            }
            Assert.That(Entries(), Is.EqualTo(new[] { "results.csv" }));
            Assert.That(Csv().Split('\n')[1], Does.StartWith("7,"));
        }

        // The echo of the first pose may be 0, as of a radar that looks up.
        [Test]
        public void Finish_WithAnEchoAfterTheFirstRow_HasItsColumns()
        {
            var echo = new CrossSectionResult(1, 1);
            echo.S[0, 0] = new ScatteringMatrix { VV = 10 };
            echo.Clutter[0] = default;
            SweepRow With(double angle, CrossSectionResult result)
            {
                var row = SampleRun.Row(angle);
                return new SweepRow(row.Pose, row.Result.With(PoseEcho.Of(result)));
            }
            Sweep(With(0, new CrossSectionResult(1, 1)), With(1, echo));
            var lines = Csv().TrimEnd().Split('\n').Select(line => line.Split(',')).ToArray();
            int column = Array.IndexOf(lines[0], "sigma_vv_dbsm");
            Assert.That(lines.Select(line => line.Length), Is.All.EqualTo(lines[0].Length));
            Assert.That((lines.Length, lines[1][column], lines[2][column]), Is.EqualTo((3, "", "20")));
        }

        [Test]
        public void Append_Row_IsInTheFileAtOnce()
        {
            using (var results = ResultsFolder.Open(_path))
            {
                results.Append(SampleRun.Row(0));
                // 20 log10 5, 300 / 900, 2073600 + 1200 segments, and half of 5 for a picture of twice 2073600 rays.
                string first = "0,5,13.979400086720377,3,-4,2073600,900,300,0.3333333333333333,1200,2074800,41.25,8.5,"
                    + "2.5,0.25,0.125,1,0.0625,,,,\n";
                Assert.That(Csv(), Is.EqualTo(Header + first));
                results.Append(SampleRun.Miss(0.1));
                Assert.That(Csv(), Is.EqualTo(Header + first + "0.1,0,,0,0,100,0,0,0,0,100,0,0,0,0,0,0,,,,,\n"),
                    "no decibels of 0, ratio 0 of no hits, no area of perspective rays, none of the axes left alone");
            }
        }

        [Test]
        public void Append_InForeignCulture_WritesTheSameBytes()
        {
            Sweep(SampleRun.Row(-0.5), SampleRun.Miss(1e-7));
            var csv = File.ReadAllBytes(Path.Combine(_path, "results.csv"));
            var json = File.ReadAllBytes(Path.Combine(_path, "results.json"));
            using (new ForeignCulture())
                Sweep(SampleRun.Row(-0.5), SampleRun.Miss(1e-7));
            Assert.That(File.ReadAllBytes(Path.Combine(_path, "results.csv")), Is.EqualTo(csv));
            Assert.That(File.ReadAllBytes(Path.Combine(_path, "results.json")), Is.EqualTo(json));
        }

        [Test]
        public void Append_NotFinite_IsRefusedAndEarlierRowsStay()
        {
            using (var results = ResultsFolder.Open(_path))
            {
                results.Append(SampleRun.Row(0));
                string before = Csv();
                var error = Assert.Throws<GlintException>(() => results.Append(SampleRun.Row(1, double.NaN)));
                Assert.That(error.Message, Does.Contain("amplitude").And.Contain("at 1 deg"));
                Assert.That(Csv(), Is.EqualTo(before));
            }
        }

        [Test]
        public void Append_AfterFinish_IsRefusedAndFilesStay()
        {
            var results = Sweep(SampleRun.Row(0));
            string before = Csv();
            Assert.Throws<InvalidOperationException>(() => results.Append(SampleRun.Row(1)));
            Assert.Throws<InvalidOperationException>(() => results.Finish(SampleRun.Info()));
            Assert.That(Csv(), Is.EqualTo(before));
        }

        [Test]
        public void Finish_Rows_HaveTheTextsOfTheCsv()
        {
            Sweep(SampleRun.Row(0), SampleRun.Miss(1));
            var names = Header.TrimEnd('\n').Split(',');
            var lines = Csv().Split('\n').Skip(1).Select(line => line.Split(',')).ToArray();
            var rows = Json()["rows"];
            for (int row = 0; row < 2; row++)
                for (int i = 0; i < names.Length; i++)
                    if (lines[row][i] == "")
                        Assert.That(rows[row][names[i]].Type, Is.EqualTo(JTokenType.Null));
                    else
                        Assert.That(Numbers.Format((double)rows[row][names[i]]), Is.EqualTo(lines[row][i]), names[i]);
            Assert.That(rows[0]["phase_histogram"].Count(), Is.EqualTo(Signal.PhaseBins));
            Assert.That(rows[1]["phase_histogram"], Is.Null);
            Assert.That((double)rows[0]["timings"]["gather_ms"], Is.EqualTo(1));
        }

        [Test]
        public void Finish_Rows_TakeALineEachOfTheJson()
        {
            Sweep(SampleRun.Row(0), SampleRun.Miss(1));
            var lines = File.ReadAllLines(Path.Combine(_path, "results.json"))
                .SkipWhile(line => line != "  \"rows\": [").ToArray();
            Assert.That(lines.Length, Is.EqualTo(5), "two rows, their brackets, and the end");
            Assert.That((double)JObject.Parse(lines[1].TrimEnd(','))["angle_deg"], Is.EqualTo(0));
        }

        [Test]
        public void Finish_Run_IsDescribed()
        {
            Sweep(SampleRun.Row(0), SampleRun.Row(1));
            var json = Json();
            Assert.That((string)json["scene"]["path"], Is.EqualTo(SampleRun.Info().ScenePath));
            Assert.That((string)json["scene"]["target"], Is.EqualTo("Corner Reflector"));
            Assert.That((int)json["scene"]["triangles"], Is.EqualTo(36));
            Assert.That((double)json["settings"]["frequency"]["value"], Is.EqualTo(10e9));
            Assert.That((string)json["settings"]["frequency"]["unit"], Is.EqualTo("Hz"));
            Assert.That((string)json["settings"]["receiver_reference"], Is.EqualTo("camera"));
            Assert.That((string)json["device"]["name"], Is.EqualTo("llvmpipe"));
            Assert.That((string)json["versions"]["unity"], Is.EqualTo("6000.0.78f1"));
            Assert.That(json["versions"]["operating_system"].Type, Is.EqualTo(JTokenType.Null), "not known");
            Assert.That((double)json["timings"]["trace_ms"], Is.EqualTo(17), "the sum of two rows");
            Assert.That((int)json["schema"], Is.EqualTo(1));
            var columns = (JObject)json["columns"];
            Assert.That(columns.Properties().Select(column => column.Name),
                Is.EqualTo(Header.TrimEnd('\n').Split(',')));
            Assert.That((string)columns["path_length_m"]["unit"], Is.EqualTo("m"));
            Assert.That((string)columns["ray_area_m2"]["unit"], Is.EqualTo("m2"));
            Assert.That((string)columns["amplitude_normalised"]["error"], Is.EqualTo("sampling_error"));
            Assert.That((string)columns["frequency_hz"]["axis"]["shown_unit"], Is.EqualTo("GHz"));
            Assert.That(File.ReadAllText(Path.Combine(_path, "results.json")),
                Does.Contain("\"2025-03-04T15:06:07Z\"").And.Not.Contain("\r").And.EndsWith("}\n"));
        }

        [Test]
        public void Finish_WithoutRows_WritesTheHeader()
        {
            Sweep();
            Assert.That(Csv(), Is.EqualTo(Header));
            Assert.That(Json()["rows"].Count(), Is.EqualTo(0));
        }

        [Test]
        public void Finish_JsonCannotBeWritten_NamesItAndKeepsTheRows()
        {
            using (var results = ResultsFolder.Open(_path))
            {
                results.Append(SampleRun.Row(0));
                Directory.CreateDirectory(Path.Combine(_path, "results.json"));
                var error = Assert.Throws<GlintException>(() => results.Finish(SampleRun.Info()));
                Assert.That(error.Message, Does.Contain(Path.Combine(_path, "results.json")).And.Not.Contain("\n"));
            }
            Assert.That(Csv().Split('\n').Length, Is.EqualTo(3));
            Assert.That(Entries(), Is.EqualTo(new[] { "results.csv", "results.json" }), "no temporary file");
        }

        [Test]
        public void Open_BelowAFile_IsRefusedByName()
        {
            _folder.Write("a", new byte[1]);
            AssertRefused(_path, $"{_path}: {_folder.PathOf("a")} is a file, not a folder");
            AssertRefused(_folder.PathOf("a"), $"{_folder.PathOf("a")} is a file, not a folder");
            Assert.That(File.ReadAllBytes(_folder.PathOf("a")), Is.EqualTo(new byte[1]));
        }

        [TestCase("results.csv")]
        [TestCase("results.json")]
        [TestCase("results.lock")]
        public void Open_FolderInPlaceOfAFile_IsRefusedByName(string name)
        {
            Directory.CreateDirectory(Path.Combine(_path, name));
            AssertRefused(_path, _path, name, "is a folder");
        }

        [Test]
        public void Open_WhileAnotherRunHasTheFolder_IsRefusedAndHarmsNothing()
        {
            using (var results = ResultsFolder.Open(_path))
            {
                AssertRefused(_path, _path, "another run");
                results.Append(SampleRun.Row(0));
                AssertRefused(_path, _path, "another run");
                results.Append(SampleRun.Row(1));
                Assert.That(Csv().Split('\n').Length, Is.EqualTo(4));
                results.Finish(SampleRun.Info());
                ResultsFolder.Open(_path).Dispose();
            }
            Assert.That(Entries(), Is.EqualTo(new[] { "results.csv", "results.json" }));
        }

        [Test]
        public void Open_LockFileOfAKilledRun_IsTakenOver()
        {
            Directory.CreateDirectory(_path);
            File.WriteAllText(Path.Combine(_path, "results.lock"), "");
            Sweep(SampleRun.Row(0));
            Assert.That(Entries(), Is.EqualTo(new[] { "results.csv", "results.json" }));
        }

        [Test]
        public void Open_InAFolderThatIsThere_LeavesIt()
        {
            Directory.CreateDirectory(_path);
            ResultsFolder.Open(_path).Dispose();
            Assert.That(Entries(), Is.Empty);
        }

        [Test]
        public void Open_EmptyName_IsRefused() => AssertRefused("", "empty name");

        static void AssertRefused(string path, params string[] parts)
        {
            var error = Assert.Throws<GlintException>(() => ResultsFolder.Open(path));
            Assert.That(error.ExitCode, Is.EqualTo(1));
            foreach (string part in parts)
                Assert.That(error.Message, Does.Contain(part).And.Not.Contain("\n"));
        }

        ResultsFolder Sweep(params SweepRow[] rows)
        {
            using (var results = ResultsFolder.Open(_path))
            {
                foreach (var row in rows)
                    results.Append(row);
                results.Finish(SampleRun.Info());
                return results;
            }
        }

        string[] Entries() => Directory.GetFileSystemEntries(_path).Select(Path.GetFileName)
            .OrderBy(name => name, StringComparer.Ordinal).ToArray();

        string Csv()
        {
            using (var file = new FileStream(Path.Combine(_path, "results.csv"), FileMode.Open,
                FileAccess.Read, FileShare.ReadWrite))
            using (var reader = new StreamReader(file, Encoding.UTF8))
                return reader.ReadToEnd();
        }

        JObject Json() => JObject.Parse(File.ReadAllText(Path.Combine(_path, "results.json")));
    }
}
