using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class SnapshotsTests
    {
        [TestCase("1:10", new[] { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 })]
        [TestCase("2:9:3", new[] { 2, 5, 8 })]
        [TestCase("4:4", new[] { 4 })]
        [TestCase("7", new[] { 7 })]
        [TestCase("3, 1,2", new[] { 3, 1, 2 })]
        public void Parse_RangeOrList_CountsFromOneAndKeepsTheOrder(string text, int[] expected) =>
            Assert.That(SweepAxis.Snapshot.Parse(text), Is.EqualTo(expected));

        [TestCase("", "no snapshots")]
        [TestCase("0:3", "each snapshot must be a whole number from 1")]
        [TestCase("1:x", "x is not a number: give FROM:TO, such as 1:10")]
        [TestCase("1.5", "each snapshot must be a whole number from 1")]
        [TestCase("1,,2", "a number is missing")]
        [TestCase("2,1,2,3", "the snapshot 2 is given twice: give each once")]
        [TestCase("5:1", "FROM must not be above TO")]
        [TestCase("1:9:0", "STEP must be a whole number above 0")]
        [TestCase("1:9:0.5", "STEP must be a whole number above 0")]
        [TestCase("1:2:3:4", "two or three parts")]
        [TestCase("1:9999999999", "each snapshot must be a whole number from 1")]
        public void Parse_Malformed_IsRefusedWithTheWayOut(string text, string part) =>
            Assert.That(Assert.Throws<UsageException>(() => SweepAxis.Snapshot.Parse(text)).Message,
                Does.Contain(part));
    }
}
