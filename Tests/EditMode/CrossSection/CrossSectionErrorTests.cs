using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>
    /// The error that the kernels say beside the true one, for random poses of ten targets, and of three of them at a finite
    /// range. The truths are of the double-precision tracer, and stored: CrossSectionTruths.txt.
    /// </summary>
    [Category("Slow")]
    public sealed class CrossSectionErrorTests
    {
        const string TruthsPath = "Packages/com.glint.tests/EditMode/CrossSection/CrossSectionTruths.txt";

        // File that receives truths, hours of work: how the table was made. It has these poses of each target.
        const string FileVariable = "GLINT_TRUTHS";
        const int PosesOfABody = 50;

        // The poses of each target that are compared; tools/stress errors takes all of the table.
        const string CountVariable = "GLINT_ERROR_POSES";
        const int DefaultCount = 6;

        // Of HV and VH, as a part of what is allowed: below it they are not compared.
        const double MinCrossError = 0.02;

        /// <summary>A pose with its truth, and what the kernels made of it.</summary>
        sealed class Sample
        {
            public string Target;
            public int Number;
            public double Said, True, Allowed, Scale;
            public bool IsMet, IsCross;
            public double Ratio => True / Said;
            public override string ToString() =>
                FormattableString.Invariant($"{Target} {Number}{(IsCross ? " HV, VH" : "")}: said {Said:g3} m, true {True:g3} m, scale {Scale:g3} m");
        }

        [TestCase(false)]
        [TestCase(true)]
        [Timeout(3600000)]
        public void SaidErrors_OfRandomPoses_AreAboutTheTrueOnes(bool isNear)
        {
            int count = int.Parse(Environment.GetEnvironmentVariable(CountVariable) ?? DefaultCount.ToString(CultureInfo.InvariantCulture),
                CultureInfo.InvariantCulture);
            var all = Samples((target, number) => number < count && ErrorPose.IsNear(target) == isNear).ToArray();
            var coPolar = all.Where(sample => !sample.IsCross && sample.Said > 0).ToArray();
            // Of many poses HV and VH are rounded zeros. What their errors leave out is in rcs.md.
            var crossPolar = all.Where(sample => sample.IsCross
                && Math.Max(sample.Said, sample.True) > MinCrossError * sample.Allowed).ToArray();
            Print(coPolar);
            Print(crossPolar);
            AssertAboutTrue(coPolar, count, 0.01);
            if (isNear)
                AssertWithinTolerance(crossPolar, count);
            else
                AssertAboutTrue(crossPolar, count, 0.01);
        }

        // Strips of grazing second bounces beside the line where two faces meet, and an edge that is just hidden all along: they
        // were off by 0.6 to 8 mm, up to 1,400 times the error said.
        [TestCase("dihedral", 30)]
        [TestCase("top_hat", 4)]
        [TestCase("near_dihedral", 49)]
        [TestCase("near_trihedral", 33)]
        [TestCase("near_trihedral", 44)]
        public void ErrorsOfThinStrips_AreSaid(string target, int number)
        {
            foreach (var sample in Samples((each, pose) => each == target && pose == number))
                Assert.That(sample.True, Is.LessThanOrEqualTo(Math.Max(sample.Allowed, 10 * sample.Said)), sample.ToString());
        }

        // The corner of a cell met the wide end of a strip, and no corner of its parts the narrow one, beside which no ray looked
        // again: VH was off by 1.5 mm, 5.2 times the error said.
        [Test]
        public void NarrowEndsOfStrips_AreFound() => AssertRatios("trihedral", 33, 3);

        // Second bounces off what curved surfaces mirror reach into cells through a side whose ends do not see them: HV was off by 4.4
        // to 19 times the error said, at any tolerance.
        [TestCase("two_plates", 26)]
        [TestCase("ship", 17)]
        [TestCase("ship", 34)]
        public void FingersOfSecondBounces_AreFound(string target, int number) => AssertRatios(target, number, 4);

        // The corner of a shadow of second bounces reaches into a cell of one path. The cell beside it had found it, but the divided
        // cell was summed as a whole all the same: S was off by 4.8 times what is asked for here, 21 times the error said.
        [Test]
        public void CornersOfShadowsOfSecondBounces_AreFound() => AssertRatios("two_plates", 3, 3, 0.01);

        // Rays off the limb of the mast have the field of those off a cylinder, not that of the plane of a facet: HV was off by 6.2
        // and 5 times the error said.
        [TestCase("ship", 0)]
        [TestCase("ship", 24)]
        public void FieldsOffFacets_SpreadAsThoseOffTheirSurface(string target, int number) => AssertRatios(target, number, 4);

        // The strength at the corners of a square, which HV and VH follow, was that of VV and HH on other facets too: both were too
        // large all over the mast, 3.4 times the error said.
        [Test]
        public void StrengthsAcrossFacets_AreThoseOfEachPolarisation() => AssertRatios("ship", 42, 3);

        // maxRatio: of the true error over the one said. toleranceDb: instead of that of the pose.
        static void AssertRatios(string target, int number, double maxRatio, double? toleranceDb = null)
        {
            foreach (var sample in Samples((each, pose) => each == target && pose == number, toleranceDb))
                Assert.That(sample.Ratio, Is.LessThan(maxRatio), sample.ToString());
        }

        static void Print(Sample[] samples)
        {
            TestContext.WriteLine(Table(samples));
            TestContext.WriteLine(string.Join("\n", samples.Where(sample => sample.Ratio > 3)));
        }

        // Shares of a part of the table scatter.
        static double ScatterOf(int count) => count < PosesOfABody ? 0.04 : 0;

        // maxAbove: share of errors above three times those said.
        static void AssertAboutTrue(Sample[] samples, int count, double maxAbove)
        {
            double Share(Func<Sample, bool> isOne) => samples.Count(isOne) / (double)samples.Length;
            // What is above 3 has its causes in rcs.md.
            double scatter = ScatterOf(count);
            Assert.That(Share(sample => sample.Ratio >= 1 / 3.0 && sample.Ratio <= 3), Is.GreaterThanOrEqualTo(0.8 - scatter));
            Assert.That(Share(sample => sample.Ratio > 3), Is.LessThanOrEqualTo(maxAbove + scatter));
            Assert.That(Share(sample => sample.Ratio > 10), Is.Zero);
            AssertWithinTolerance(samples, count);
        }

        static void AssertWithinTolerance(Sample[] samples, int count)
        {
            var met = samples.Where(sample => sample.IsMet).ToArray();
            Assert.That(met.Count(sample => sample.True <= sample.Allowed),
                Is.GreaterThanOrEqualTo((0.95 - ScatterOf(count)) * met.Length));
        }

        static string Table(IEnumerable<Sample> samples) => string.Join("\n", samples.GroupBy(sample => sample.Target)
            .Append(samples.GroupBy(_ => "all").Single()).Select(group =>
            {
                var ratios = group.Select(sample => sample.Ratio).OrderBy(ratio => ratio).ToArray();
                var met = group.Where(sample => sample.IsMet).ToArray();
                double Percent(Func<double, bool> isOne) => 100.0 * ratios.Count(isOne) / ratios.Length;
                return FormattableString.Invariant(
                    $"| {group.Key} | {ratios.Length} | {Math.Sqrt(ratios.Average(ratio => ratio * ratio)):0.00} | {ratios[ratios.Length / 2]:0.00} | {Percent(ratio => ratio < 1 / 3.0):0.0} | {Percent(ratio => ratio >= 1 / 3.0 && ratio <= 3):0.0} | {Percent(ratio => ratio > 3):0.0} | {Percent(ratio => ratio > 10):0.0} | {ratios.Last():0.0} | {100.0 * met.Count(sample => sample.True <= sample.Allowed) / met.Length:0.0} of {met.Length} |");
            }));

        // toleranceDb: instead of that of the pose.
        static IEnumerable<Sample> Samples(Func<string, int, bool> isTaken, double? toleranceDb = null)
        {
            using (var tracer = new CrossSectionTracer(TestKernels.Tubes))
                foreach (var rows in Truths().Where(truth => isTaken(truth.Target, truth.Number))
                    .GroupBy(truth => truth.Target))
                {
                    var scene = ErrorPose.SceneOf(rows.Key);
                    foreach (var truth in rows)
                    {
                        var pose = ErrorPose.Of(truth.Target, scene, truth.Number);
                        pose.ToleranceDb = toleranceDb ?? pose.ToleranceDb;
                        var result = tracer.Trace(pose);
                        foreach (bool isCross in new[] { false, true })
                        {
                            double scale = ErrorPose.ScaleOf(result.S[0, 0], result.FloorDbsm, isCross);
                            yield return new Sample
                            {
                                Target = truth.Target, Number = truth.Number, IsMet = result.IsMet, IsCross = isCross,
                                Said = (isCross ? result.CrossErrors : result.Errors)[0, 0],
                                True = Math.Sqrt(ErrorPose.PairOf(isCross)
                                    .Average(each => Square(each.Of(result.S[0, 0]) - each.Of(truth.S)))),
                                Scale = scale, Allowed = CrossSectionAccuracy.AllowedBy(pose.ToleranceDb) * scale
                            };
                        }
                    }
                }
        }

        static double Square(Complex s) => s.Real * s.Real + s.Imaginary * s.Imaginary;

        // Truths that take seconds, with edges, second bounces, layers, and a finite range; or all for the file of the variable.
        [TestCase("plate_with_edges", 38, Category = "Stress")]
        [TestCase("two_plates", 11, Category = "Stress")]
        [TestCase("coated_box", 18, Category = "Stress")]
        [TestCase("near_trihedral", 17)]
        [Timeout(3600000)]
        public void Truths_AreThoseOfTheReferenceTracer(string target, int number)
        {
            string file = Environment.GetEnvironmentVariable(FileVariable);
            if (file != null)
            {
                WriteTruths(file);
                return;
            }
            var truth = Truths().Single(each => each.Target == target && each.Number == number);
            var s = ErrorTruth.Compute(target, number, truth.Fineness).S;
            Assert.That((s.VV - truth.S.VV).Magnitude, Is.LessThan(1e-6 * truth.S.VV.Magnitude));
            Assert.That((s.HH - truth.S.HH).Magnitude, Is.LessThan(1e-6 * truth.S.HH.Magnitude));
        }

        // Poses that the table lacks or whose truth is coarse: a line for each step, of which the last one counts. A run that was
        // ended goes on where it was.
        static void WriteTruths(string file)
        {
            var known = Truths().Concat(Parse(File.Exists(file) ? File.ReadAllText(file) : ""))
                .GroupBy(truth => (truth.Target, truth.Number)).ToDictionary(each => each.Key, each => each.Last());
            foreach (string target in ErrorPose.Targets)
                for (int number = 0; number < PosesOfABody; number++)
                {
                    if (!known.TryGetValue((target, number), out var truth))
                        truth = ErrorTruth.Compute(target, number, 1);
                    while (truth.IsCoarse)
                    {
                        truth = truth.Refined();
                        File.AppendAllText(file, truth + "\n");
                    }
                }
        }

        static ErrorTruth[] Truths() => Parse(AssetDatabase.LoadAssetAtPath<TextAsset>(TruthsPath).text);

        static ErrorTruth[] Parse(string table) => table
            .Split(new[] { '\n', '\r' }, StringSplitOptions.RemoveEmptyEntries).Select(ErrorTruth.Parse).ToArray();
    }
}
