using System;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ReportFileTests
    {
        const string Before = "<script type=\"application/json\">", After = "</script>";

        string _path;

        [SetUp]
        public void Choose() =>
            _path = Path.Combine(Path.GetTempPath(), "glint-report-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void Remove()
        {
            if (Directory.Exists(_path))
                Directory.Delete(_path, true);
        }

        [Test]
        public void Fill_WithNamesThatLookLikeMarkup_KeepsThemInsideTheScript()
        {
            const string evil = "</script><script>alert(1)</script><!-- & \u2028 'x' \"y\"";
            var info = SampleRun.Info();
            info.TargetName = evil;
            Write(info);
            string page =
                ReportFile.Fill($"{Before}@GLINT_REPORT_DATA@{After}", StoredRun.Read(_path), null, "no " + evil);

            string json = page.Substring(Before.Length, page.Length - Before.Length - After.Length);
            Assert.That(json, Does.Not.Contain("<"));
            var data = JObject.Parse(json);
            Assert.That((string)data["run"]["scene"]["target"], Is.EqualTo(evil));
            Assert.That((string)data["no_scene"], Is.EqualTo("no " + evil));
            Assert.That(json, Does.Contain("\"2025-03-04T15:06:07Z\""), "the text that was stored");
        }

        [TestCase("no place")]
        [TestCase("@GLINT_REPORT_DATA@ and @GLINT_REPORT_DATA@")]
        public void Fill_OfADamagedTemplate_IsRefused(string template)
        {
            Write(SampleRun.Info());
            Assert.That(() => ReportFile.Fill(template, StoredRun.Read(_path), null, ""),
                Throws.TypeOf<GlintException>().With.Message.Contain("template"));
        }

        [Test]
        public void Run_ThatWasStored_IsReadWithItsPosesAndCommand()
        {
            var info = SampleRun.Info();
            info.Command = new[] { "sweep", "--angles=0,1,2", "--", "a b.obj" };
            Write(info);
            var run = StoredRun.Read(_path);

            Assert.That(run.Count, Is.EqualTo(3));
            Assert.That(run.Strongest(), Is.EqualTo(1));
            Assert.That(run.Amplitude(1), Is.EqualTo(10));
            Assert.That(run.Value(2, SweepAxis.Angle), Is.EqualTo(2));
            Assert.That(run.Value(0, SweepAxis.Snapshot), Is.Null);
            Assert.That(run.Info.Command, Is.EqualTo(info.Command));
            Assert.That(run.Info.ScenePath, Is.EqualTo(info.ScenePath));
        }

        [TestCase("{\"versions\"", "is damaged")]
        [TestCase("", "is damaged")]
        [TestCase("[]", "is damaged")]
        [TestCase("{}", "it has no started_utc")]
        [TestCase("{\"started_utc\":\"2025-03-04T15:06:07Z\",\"elapsed_ms\":NaN}", "not finite")]
        public void Run_OfADamagedFile_IsRefusedByNameInOneLine(string json, string expected)
        {
            Directory.CreateDirectory(_path);
            File.WriteAllText(Path.Combine(_path, "results.json"), json);
            var problem = Assert.Throws<GlintException>(() => StoredRun.Read(_path));
            Assert.That(problem.Message,
                Does.Contain(Path.Combine(_path, "results.json")).And.Contain(expected).And.Not.Contain("\n"));
        }

        [TestCase("\"angle_deg\":0", "\"angle_deg\": \"x\"", "angle_deg of a row is not a number")]
        [TestCase("\"amplitude\":5", "\"amplitude\": null", "amplitude of a row is not a number")]
        [TestCase("\"amplitude\":5", "\"amplitude\": Infinity", "not finite")]
        [TestCase("\"phase_histogram\":[0,", "\"phase_histogram\": [NaN,", "not finite")]
        [TestCase("\"phase_histogram\":[0,", "\"phase_histogram\": 5, \"others\": [0,", "phase_histogram of a row is no list")]
        [TestCase("\"phase_histogram\":[0,", "\"phase_histogram\": [[],", "results.json")]
        [TestCase("\"versions\": {", "\"versions\": 7, \"others\": {", "it has no glint")]
        public void Run_OfADamagedRow_IsRefusedByName(string before, string after, string expected)
        {
            Write(SampleRun.Info());
            string path = Path.Combine(_path, "results.json"), text = File.ReadAllText(path);
            Assert.That(text, Does.Contain(before));
            File.WriteAllText(path, text.Replace(before, after));
            Assert.That(() => StoredRun.Read(_path),
                Throws.TypeOf<GlintException>().With.Message.Contain(path).And.Message.Contain(expected));
        }

        [Test]
        public void Run_ThatIsNotThere_IsRefusedWithTheRemedy()
        {
            Assert.That(() => StoredRun.Read(_path),
                Throws.TypeOf<GlintException>().With.Message.Contain("no such folder"));
            Directory.CreateDirectory(_path);
            Assert.That(() => StoredRun.Read(_path),
                Throws.TypeOf<GlintException>().With.Message.Contain("holds no results"));
            File.WriteAllText(Path.Combine(_path, "results.csv"), "");
            Assert.That(() => StoredRun.Read(_path),
                Throws.TypeOf<GlintException>().With.Message.Contain("not finished"));
            Assert.That(() => StoredRun.Read(Path.Combine(_path, "results.csv")),
                Throws.TypeOf<GlintException>().With.Message.Contain("is a file"));
        }

        [Test]
        public void Write_OverAnOlderReport_LeavesOneFile()
        {
            Directory.CreateDirectory(_path);
            string file = Path.Combine(_path, "report.html");
            ReportFile.Write(file, "<!DOCTYPE html>old");
            ReportFile.Write(file, "<!DOCTYPE html>new");
            Assert.That(File.ReadAllText(file), Is.EqualTo("<!DOCTYPE html>new"));
            Assert.That(Directory.GetFiles(_path), Is.EqualTo(new[] { file }));
        }

        [Test]
        public void Write_IntoAFolderThatIsNotThere_IsRefusedByName()
        {
            string file = Path.Combine(_path, "report.html");
            Assert.That(() => ReportFile.Write(file, "x"),
                Throws.TypeOf<GlintException>().With.Message.Contain(file).And.Message.Contain("--out"));
        }

        // Amplitudes 5, 10, 5.
        void Write(RunInfo info)
        {
            using (var folder = ResultsFolder.Open(_path))
            {
                foreach (int i in Enumerable.Range(0, 3))
                    folder.Append(SampleRun.Row(i, i == 1 ? 6 : 3, i == 1 ? -8 : -4));
                folder.Finish(info);
            }
        }
    }
}
