using System;
using System.Globalization;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;

namespace Glint.Tests
{
    /// <summary>S of an error pose by the double-precision reference: a line of CrossSectionTruths.txt.</summary>
    sealed class ErrorTruth
    {
        // A truth is fine enough when tubes of half the size change it by at most these parts of what its pose allows.
        const double MaxChange = 0.03, MaxCrossChange = 0.01;
        const int MaxFineness = 8;

        public string Target { get; private set; }
        public int Number { get; private set; }

        /// <summary>Tubes of this truth along one of the settings of its target, a power of 2.</summary>
        public int Fineness { get; private set; }

        public ScatteringMatrix S { get; private set; }

        /// <summary>Its change from tubes of twice the size, beside the largest that is fine enough.</summary>
        public double Excess { get; private set; } = double.PositiveInfinity;

        /// <summary>Whether finer tubes are due.</summary>
        public bool IsCoarse => Excess > 1 && Fineness < MaxFineness;

        /// <summary>The truth of a pose, by tubes this much finer than the settings of its target.</summary>
        public static ErrorTruth Compute(string target, int number, int fineness)
        {
            var pose = ErrorPose.Of(target, ErrorPose.SceneOf(target), number);
            var settings = ErrorPose.TruthSettingsOf(target);
            settings.CellsPerWavelength *= fineness;
            settings.MaxPhaseError /= fineness;
            return new ErrorTruth
            {
                Target = target, Number = number, Fineness = fineness,
                S = new ReferenceCrossSection(pose.Scene).Compute(pose, settings)[0, 0]
            };
        }

        /// <summary>The truth with tubes of half the size.</summary>
        public ErrorTruth Refined()
        {
            var refined = Compute(Target, Number, 2 * Fineness);
            refined.Excess = refined.ExcessOver(this);
            return refined;
        }

        double ExcessOver(ErrorTruth coarser)
        {
            var pose = ErrorPose.Of(Target, ErrorPose.SceneOf(Target), Number);
            var (boxMin, boxMax) = pose.Scene.Bound();
            double floor = CrossSectionFloor.Of(boxMin, boxMax);
            double ExcessOf(bool isCross, double maxChange) =>
                ErrorPose.PairOf(isCross).Max(each => (each.Of(S) - each.Of(coarser.S)).Magnitude)
                / (maxChange * CrossSectionAccuracy.AllowedBy(pose.ToleranceDb) * ErrorPose.ScaleOf(S, floor, isCross));
            return Math.Max(ExcessOf(false, MaxChange), ExcessOf(true, MaxCrossChange));
        }

        public static ErrorTruth Parse(string line)
        {
            var fields = line.Split(' ');
            double Value(int field) => double.Parse(fields[field], CultureInfo.InvariantCulture);
            return new ErrorTruth
            {
                Target = fields[0], Number = (int)Value(1), Fineness = (int)Value(2),
                S = new ScatteringMatrix
                {
                    VV = new Complex(Value(3), Value(4)), HH = new Complex(Value(5), Value(6)),
                    HV = new Complex(Value(7), Value(8)), VH = new Complex(Value(9), Value(10))
                },
                Excess = Value(11)
            };
        }

        public override string ToString() => $"{Target} {Number} {Fineness} " + string.Join(" ",
            new[] { S.VV, S.HH, S.HV, S.VH }.SelectMany(part => new[] { part.Real, part.Imaginary })
                .Select(part => part.ToString("g9", CultureInfo.InvariantCulture)))
            + FormattableString.Invariant($" {Excess:g4}");
    }
}
