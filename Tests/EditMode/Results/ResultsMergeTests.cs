using System;
using System.IO;
using System.Linq;
using Glint.Core;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Merged parts of a sweep: the files of the whole sweep, or one line with the error.</summary>
    public sealed class ResultsMergeTests
    {
        const int Poses = 7;

        TemporaryFolder _folder;

        [SetUp]
        public void SetUp() => _folder = new TemporaryFolder();

        [TearDown]
        public void TearDown() => _folder.Dispose();

        [Test]
        public void Shards_OfAnySweep_AreAllItsPosesOnceAndInOrder()
        {
            foreach (int poses in new[] { 1, 2, 7, 46, 1000, SweepPlan.Limit })
                for (int count = 1; count <= Math.Min(poses, 12); count++)
                {
                    var parts = Enumerable.Range(1, count).Select(number => new SweepShard(number, count)).ToArray();
                    Assert.That(parts[0].First(poses), Is.Zero);
                    Assert.That(parts[count - 1].End(poses), Is.EqualTo(poses));
                    for (int i = 1; i < count; i++)
                        Assert.That(parts[i].First(poses), Is.EqualTo(parts[i - 1].End(poses)));
                    var sizes = parts.Select(part => part.End(poses) - part.First(poses)).ToArray();
                    Assert.That(sizes.Min(), Is.GreaterThan(0));
                    Assert.That(sizes.Max() - sizes.Min(), Is.LessThanOrEqualTo(1));
                }
        }

        [Test]
        public void Merge_OfAnyNumberOfParts_IsTheUndividedSweep()
        {
            SampleSweep.Write(_folder.PathOf("whole"), SampleSweep.Identity(poses: Poses), Poses, Poses);
            for (int count = 1; count <= Poses; count++)
            {
                string[] parts = Enumerable.Range(1, count).Reverse().Select(number => Part(number, count)).ToArray();
                ResultsMerge.Merge(parts, _folder.PathOf("merged"));
                foreach (string name in new[] { "results.csv", "results.json" })
                    Assert.That(Text("merged", name), Is.EqualTo(Text("whole", name)), $"{count} parts");
            }
        }

        [Test]
        public void Merge_OfWhatDoesNotBelongTogether_IsRefusedByName()
        {
            string one = Part(1, 3), two = Part(2, 3), three = Part(3, 3);
            AssertRefused("a part is missing: 2/3", one, three);
            AssertRefused($"{two} and {two} are both part 2/3", one, two, two, three);
            AssertRefused("different numbers of parts", one, two, Part(2, 2));
            AssertRefused("there is no such folder", one, two, _folder.PathOf("nothing"));
            AssertRefused("is one of the parts", one, two, three, _folder.PathOf("merged"));

            SampleSweep.Write(_folder.PathOf("other"),
                SampleSweep.Identity("9000000000 Hz", new SweepShard(3, 3), Poses), 3, 3);
            AssertRefused("frequency was \"10000000000 Hz\" and is \"9000000000 Hz\"", one, two,
                _folder.PathOf("other"));
            SampleSweep.Write(_folder.PathOf("undivided"), SampleSweep.Identity(poses: Poses), Poses, Poses);
            AssertRefused("is not part of a sweep", _folder.PathOf("undivided"));
            SampleSweep.Write(_folder.PathOf("unfinished"),
                SampleSweep.Identity(shard: new SweepShard(3, 3), poses: Poses), 3, 2, first: 4);
            AssertRefused("is not finished: finish it with --resume", one, two, _folder.PathOf("unfinished"));
            SampleSweep.Write(_folder.PathOf("short"),
                SampleSweep.Identity(shard: new SweepShard(3, 3), poses: Poses), 1, 1, first: 6);
            AssertRefused("a file was changed", one, two, _folder.PathOf("short"));

            string json = Path.Combine(two, "results.json");
            File.WriteAllText(json, File.ReadAllText(json).Replace("\"amplitude\":", "\"altitude\":"));
            AssertRefused(json + ": cannot be read as results, it is damaged: a row has no amplitude", one, two, three);
            File.WriteAllText(json, "{\n  \"table\": nonsense");
            AssertRefused(json + ", line 2: cannot be read as results, it is damaged: malformed JSON; restore it, or run the sweep "
                + "again without --resume", one, two, three);
            File.Delete(json);
            AssertRefused($"{two}: has no results.json", one, two, three);
        }

        /// <summary>Its plan says how many poses there are: not the rows, of which any part may have lost some.</summary>
        [Test]
        public void Merge_OfAPartThatLostARow_NamesThePart()
        {
            string one = Part(1, 3), two = Part(2, 3), lost = _folder.PathOf("lost");
            SampleSweep.Write(lost, SampleSweep.Identity(shard: new SweepShard(3, 3), poses: Poses), 2, 2, first: 4);
            AssertRefused($"{Path.Combine(lost, "results.json")}: has 2 rows where part 3/3 of 7 poses has 3: a file was "
                + "changed; trace the part again", one, two, lost);
        }

        /// <summary>As for --resume: each row is where the plan has it. A file may have been changed by hand.</summary>
        [Test]
        public void Merge_OfRowsThatAreNotOfThePlan_IsRefusedByFileAndRow()
        {
            string one = Part(1, 3), three = Part(3, 3);
            void AssertChanged(string problem, Action<JArray> change)
            {
                string two = Part(2, 3), json = Path.Combine(two, "results.json");
                var results = StoredRun.Parse(File.ReadAllText(json));
                change((JArray)results["rows"]);
                File.WriteAllText(json, results.ToString());
                AssertRefused($"{json}: {problem}: it was changed; restore it, or trace part 2/3 again", one, two, three);
            }
            AssertChanged("row 1 is of 3 deg instead of 2 deg", rows => rows.Add(Taken(rows[0])));
            AssertChanged("row 2 is of 12.5 deg instead of 3 deg", rows => rows[1]["angle_deg"] = 12.5);
            AssertChanged("row 2 is of snapshot 4, 3 deg instead of 3 deg", rows => rows[1]["snapshot"] = 4);
        }

        [Test]
        public void Merge_OfTheRowsOfAnotherPart_IsRefused()
        {
            string foreign = _folder.PathOf("foreign");
            SampleSweep.Write(foreign, SampleSweep.Identity(shard: new SweepShard(2, 3), poses: Poses), 2, 2, first: 4);
            AssertRefused($"{Path.Combine(foreign, "results.json")}: row 1 is of 4 deg instead of 2 deg", Part(1, 3), foreign,
                Part(3, 3));
        }

        [Test]
        public void Merge_OfCrossSectionsThatAreNotOfThePlan_IsRefused()
        {
            var plan = new CrossSectionPlan(new double[] { 0, 30, 60, 90 }, new double[] { 5 }, new[] { 9e9 });
            var rows = SampleRows.Of(plan, azimuth => 1, azimuth => 1);
            string[] parts = { CrossSections(1, rows[0], rows[1]), CrossSections(2, rows[3], rows[2]) };
            AssertRefused($"{Path.Combine(parts[1], "results.json")}: row 1 is of azimuth 90 deg, elevation 5 deg, 9000000000 Hz "
                + "instead of azimuth 60 deg, elevation 5 deg, 9000000000 Hz: it was changed; restore it, or trace part 2/2 "
                + "again", parts);

            string CrossSections(int number, params CrossSectionRow[] written)
            {
                string path = _folder.PathOf($"rcs {number}");
                using (var folder = ResultsFolder.Open(path, ResultTable.CrossSection))
                {
                    var info = SampleRun.Info();
                    info.Sweep = new SweepIdentity { Shard = new SweepShard(number, 2) };
                    plan.AddTo(info.Sweep);
                    folder.Begin(info.Sweep, SampleSweep.Started);
                    folder.Append(written);
                    folder.Finish(info);
                }
                return path;
            }
        }

        /// <summary>Directions on a track are computed, on another machine perhaps with other last digits.</summary>
        [Test]
        public void PlanOfATrack_HasItsRowsBackFromTheIdentity()
        {
            var plan = new CrossSectionPlan(new RadarTrack(new[] { -50, -0.3, 0, 7.7 }, 30, 12, 1000 / 3.0), new[] { 9e9 });
            var identity = new SweepIdentity();
            plan.AddTo(identity);
            var rows = StoredRow.Of(SampleRows.Of(plan, azimuth => 1, azimuth => 1));
            var again = CrossSectionPlan.Of(identity);
            for (int i = 0; i < plan.Count; i++)
            {
                Assert.That(again.ProblemOf(i, rows[i]), Is.Null);
                Assert.That(again.ProblemOf(i, rows[(i + 1) % rows.Length]), Does.StartWith("is of azimuth "));
            }
        }

        [Test]
        public void Merge_OfPartsWithoutAPlan_NamesNoneOfThem()
        {
            string[] parts = { _folder.PathOf("a"), _folder.PathOf("b") };
            for (int i = 0; i < 2; i++)
                SampleSweep.Write(parts[i], new SweepIdentity { Shard = new SweepShard(i + 1, 2) }, 2 - i, 2 - i);
            AssertRefused($"{parts[0]}, {parts[1]}: have 2, 1 rows, and no sweep of 3 poses has such parts", parts);
        }

        [Test]
        public void Merge_OfDifferentCommands_SaysSo()
        {
            string one = Part(1, 2), two = _folder.PathOf("rcs");
            using (var folder = ResultsFolder.Open(two, ResultTable.CrossSection))
            {
                var info = SampleRun.Info();
                info.Sweep = SampleSweep.Identity(shard: new SweepShard(2, 2), poses: Poses);
                folder.Begin(info.Sweep, SampleSweep.Started);
                folder.Append(SampleRows.Of(new double[] { 0 }, azimuth => 1, azimuth => 1));
                folder.Finish(info);
            }
            AssertRefused($"{two} holds results of glint rcs and {one} of glint sweep: give the parts of one run", one, two);
        }

        static JToken Taken(JToken row)
        {
            row.Remove();
            return row;
        }

        string Part(int number, int count)
        {
            var shard = new SweepShard(number, count);
            string path = _folder.PathOf($"part {number} of {count}");
            int poses = shard.End(Poses) - shard.First(Poses);
            SampleSweep.Write(path, SampleSweep.Identity(shard: shard, poses: Poses), poses, poses, first: shard.First(Poses));
            return path;
        }

        void AssertRefused(string part, params string[] folders)
        {
            string merged = _folder.PathOf("merged");
            Assert.That(Assert.Throws<GlintException>(() => ResultsMerge.Merge(folders, merged)).Message,
                Does.Contain(part).And.Not.Contain("\n"));
            Assert.That(Directory.Exists(merged), Is.False);
        }

        string Text(string folder, string name) => File.ReadAllText(Path.Combine(_folder.PathOf(folder), name));
    }
}
