using System;
using System.IO;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>A sweep interrupted at any byte of its files resumes to the files of an uninterrupted one.</summary>
    public sealed class ResumeTests
    {
        const int Poses = 4;

        TemporaryFolder _folder;
        string _path;

        [SetUp]
        public void SetUp()
        {
            _folder = new TemporaryFolder();
            _path = _folder.PathOf("sweep");
        }

        [TearDown]
        public void TearDown() => _folder.Dispose();

        [Test]
        public void Resume_AfterAnEndAtAnyByte_GivesTheSameFiles()
        {
            SampleSweep.Write(_folder.PathOf("whole"), SampleSweep.Identity(), Poses, Poses);
            var whole = Files(_folder.PathOf("whole"));
            SampleSweep.Write(_path, SampleSweep.Identity(), Poses, Poses - 1);
            byte[] partial = Bytes(ResultsFolder.PartialName), csv = Bytes(ResultsFolder.CsvName);
            int[] partialEnds = Ends(partial), csvEnds = Ends(csv);

            // State of the disk after each write of a row: first to results.partial, then to results.csv.
            int partialLength = partialEnds[0], csvLength = 0, moments = 0;
            for (int row = 1; row < partialEnds.Length; row++)
            {
                for (; partialLength < partialEnds[row];
                    partialLength += Math.Min(13, partialEnds[row] - partialLength), moments++)
                    AssertGoesOn(partial, partialLength, csv, csvLength, row - 1, whole);
                for (; csvLength < csvEnds[row]; csvLength += Math.Min(13, csvEnds[row] - csvLength), moments++)
                    AssertGoesOn(partial, partialLength, csv, csvLength, row, whole);
            }
            AssertGoesOn(partial, partialLength, csv, csvLength, Poses - 1, whole);
            Assert.That(moments, Is.GreaterThan(100));
        }

        [Test]
        public void Resume_AfterAnEndBeforeTheJson_TracesTheLastPoseAgain()
        {
            SampleSweep.Write(_folder.PathOf("whole"), SampleSweep.Identity(), Poses, Poses);
            SampleSweep.Write(_path, SampleSweep.Identity(), Poses, Poses, finish: false);
            Assert.That(GoOn(), Is.EqualTo(Poses - 1), "results.json describes the pose at which it stands");
            Assert.That(Files(_path), Is.EqualTo(Files(_folder.PathOf("whole"))));
        }

        // The first pose has no echo: results.csv gets the columns of echoes when all rows are there, before the JSON.
        [Test]
        public void Resume_AfterAnEndBeforeTheJson_OfRowsWithEchoes_TracesTheLastPoseAgain()
        {
            var echo = new CrossSectionResult(1, 1);
            echo.S[0, 0] = new ScatteringMatrix { VV = 10 };
            var rows = new[] { new CrossSectionResult(1, 1), echo }.Select((result, pose) =>
                new SweepRow(SampleRun.Row(pose).Pose, SampleRun.Row(pose).Result.With(PoseEcho.Of(result)))).ToArray();
            int Write(string path, bool goesOn, int count, bool finish)
            {
                using (var folder = ResultsFolder.Open(path))
                {
                    folder.Begin(SampleSweep.Identity(poses: 2), SampleSweep.Started);
                    int done = goesOn ? folder.Resume(2) : 0;
                    foreach (var row in rows.Take(count).Skip(done))
                        folder.Append(row);
                    if (finish)
                        SampleSweep.Finish(folder, SampleSweep.Identity(poses: 2));
                    return done;
                }
            }
            Write(_folder.PathOf("whole"), false, 2, true);
            Write(_path, false, 2, false);
            File.Copy(Path.Combine(_folder.PathOf("whole"), ResultsFolder.CsvName),
                Path.Combine(_path, ResultsFolder.CsvName), true);
            Assert.That(Write(_path, true, 2, true), Is.EqualTo(1));
            Assert.That(Files(_path), Is.EqualTo(Files(_folder.PathOf("whole"))));
        }

        [Test]
        public void Resume_OfACompleteSweep_LeavesIt()
        {
            SampleSweep.Write(_path, SampleSweep.Identity(), Poses, Poses);
            var before = Files(_path);
            using (var results = ResultsFolder.Open(_path))
            {
                results.Begin(SampleSweep.Identity(), SampleSweep.Started);
                Assert.That(results.Resume(Poses), Is.EqualTo(Poses));
            }
            Assert.That(Files(_path), Is.EqualTo(before));
        }

        [Test]
        public void Resume_WhereNothingIs_Begins()
        {
            Assert.That(GoOn(), Is.Zero);
            Assert.That(Directory.GetFiles(_path).Select(Path.GetFileName),
                Is.EquivalentTo(new[] { "results.csv", "results.json" }));
        }

        [TestCase(true)]
        [TestCase(false)]
        public void Resume_OfAnotherSweep_IsRefusedAndSaysWhatDiffers(bool isFinished)
        {
            SampleSweep.Write(_path, SampleSweep.Identity(frequency: "9000000000 Hz"), Poses, isFinished ? Poses : 2);
            AssertRefused(isFinished ? "results.json" : "results.partial",
                "frequency was \"9000000000 Hz\" and is \"10000000000 Hz\"");
        }

        [Test]
        public void Difference_OfLongTexts_IsWhereTheyDiffer()
        {
            string List(int count, int changed = -1) =>
                string.Join(",", Enumerable.Range(0, count).Select(i => i == changed ? "99" : $"{i}"));
            string Difference(string was, string now)
            {
                SweepIdentity earlier = new SweepIdentity(), later = new SweepIdentity();
                earlier.Add("angle_deg", was);
                later.Add("angle_deg", now);
                return later.DifferenceFrom(earlier);
            }
            string path = new string('a', 80);
            Assert.That(Difference(List(41), List(81)), Is.EqualTo("angle_deg had 41 values and has 81"));
            Assert.That(Difference(List(41), List(41, 30)), Is.EqualTo("value 31 of angle_deg was 30 and is 99"));
            Assert.That(Difference(path + "b", path + "c"), Is.EqualTo($"angle_deg was {path}b and is {path}c"));
        }

        [Test]
        public void Resume_OfAnotherPart_IsRefused()
        {
            SampleSweep.Write(_path, SampleSweep.Identity(shard: new SweepShard(1, 3)), Poses, 2);
            AssertRefused("results.partial", "shard was 1/3 and is not given");
        }

        [Test]
        public void Resume_OfADamagedRow_IsRefusedByItsLine()
        {
            SampleSweep.Write(_path, SampleSweep.Identity(), Poses, 3);
            string path = Path.Combine(_path, ResultsFolder.PartialName);
            string text = File.ReadAllText(path);
            foreach (var (damaged, line) in new[]
            {
                (text.Replace("\"amplitude\":5", "\"amplitude\":x"), "line 2"),
                (text.Replace("\"bounces\"", "\"jumps\""), "line 2"), ("[]\n" + text, "line 1"),
                (text.Insert(text.IndexOf('\n'), "}"), "line 1")
            })
            {
                File.WriteAllText(path, damaged);
                AssertRefused("results.partial, " + line, "damaged");
            }
        }

        [Test]
        public void Resume_OfRowsThatWereChanged_IsRefusedAndAfterDeletionWritesThemAnew()
        {
            SampleSweep.Write(_folder.PathOf("whole"), SampleSweep.Identity(), Poses, Poses);
            SampleSweep.Write(_path, SampleSweep.Identity(), Poses, 3);
            string csv = Path.Combine(_path, ResultsFolder.CsvName);
            File.WriteAllText(csv, File.ReadAllText(csv).Replace("\n1,", "\n1.5,"));
            AssertRefused("results.csv, line 3", "delete it");
            File.Delete(csv);
            GoOn();
            Assert.That(Files(_path), Is.EqualTo(Files(_folder.PathOf("whole"))));
        }

        [Test]
        public void Resume_OfASinglePoseOrOfLoneRows_IsRefused()
        {
            using (var results = ResultsFolder.Open(_path))
            {
                results.Append(SampleRun.Row(0));
                results.Finish(SampleRun.Info());
            }
            AssertRefused("results.json", "single pose");
            File.Delete(Path.Combine(_path, ResultsFolder.JsonName));
            AssertRefused("results.csv", "results.partial is not beside it");
        }

        [Test]
        public void Resume_OfADamagedJson_IsRefused()
        {
            SampleSweep.Write(_path, SampleSweep.Identity(), Poses, Poses);
            string path = Path.Combine(_path, ResultsFolder.JsonName);
            string text = File.ReadAllText(path);
            foreach (string damaged in new[]
            {
                "", text.Substring(0, text.Length / 2), "[1]", text.Replace("\"rows\"", "\"lines\""),
                text.Replace("\"elapsed_ms\": ", "\"elapsed_ms\": \"no\" , \"x\": "), text.Replace("2025-03", "2025-33")
            })
            {
                File.WriteAllText(path, damaged);
                AssertRefused("results.json", "damaged");
            }
        }

        void AssertGoesOn(byte[] partial, int partialLength, byte[] csv, int csvLength, int rows, string[] whole)
        {
            Directory.Delete(_path, true);
            Directory.CreateDirectory(_path);
            File.WriteAllBytes(Path.Combine(_path, ResultsFolder.PartialName), partial.Take(partialLength).ToArray());
            File.WriteAllBytes(Path.Combine(_path, ResultsFolder.CsvName), csv.Take(csvLength).ToArray());
            Assert.That(GoOn(), Is.EqualTo(rows));
            Assert.That(Files(_path), Is.EqualTo(whole), $"{partialLength} and {csvLength} bytes");
        }

        int GoOn() => SampleSweep.GoOn(_path, SampleSweep.Identity(), Poses);

        void AssertRefused(string file, string part)
        {
            var before = Directory.GetFiles(_path).OrderBy(path => path)
                .Select(path => (path, File.ReadAllText(path))).ToArray();
            var error = Assert.Throws<GlintException>(() => GoOn());
            Assert.That(error.Message,
                Does.StartWith(Path.Combine(_path, file)).And.Contain(part).And.Not.Contain("\n"));
            Assert.That(Directory.GetFiles(_path).OrderBy(path => path).Select(path => (path, File.ReadAllText(path))),
                Is.EqualTo(before), "nothing is lost");
        }

        byte[] Bytes(string name) => File.ReadAllBytes(Path.Combine(_path, name));

        static string[] Files(string path) =>
            new[] { "results.csv", "results.json" }.Select(name => File.ReadAllText(Path.Combine(path, name)))
                .Concat(Directory.GetFiles(path).Select(Path.GetFileName).OrderBy(name => name)).ToArray();

        // After each line.
        static int[] Ends(byte[] bytes) =>
            Enumerable.Range(0, bytes.Length).Where(i => bytes[i] == '\n').Select(i => i + 1).ToArray();
    }
}
