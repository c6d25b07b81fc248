using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Any change of a mesh's content changes its hash.</summary>
    public sealed class ContentHashTests
    {
        [Test]
        public void Value_EqualContent_IsEqual()
        {
            Assert.That(Of(Points(7), Numbers(19)), Is.EqualTo(Of(Points(7), Numbers(19))));
        }

        [Test]
        public void Value_OneBitOfAnyNumber_Matters()
        {
            var seen = new HashSet<ulong> { Of(Points(11), Numbers(23)) };
            for (int i = 0; i < 11; i++)
                for (int axis = 0; axis < 3; axis++)
                {
                    var points = Points(11);
                    var point = points[i];
                    point[axis] =
                        System.BitConverter.Int32BitsToSingle(System.BitConverter.SingleToInt32Bits(point[axis]) ^ 1);
                    points[i] = point;
                    Assert.That(seen.Add(Of(points, Numbers(23))), $"point {i} axis {axis}");
                }
            for (int i = 0; i < 23; i++)
                for (int bit = 0; bit < 32; bit++)
                {
                    var numbers = Numbers(23);
                    numbers[i] ^= 1 << bit;
                    Assert.That(seen.Add(Of(Points(11), numbers)), $"number {i} bit {bit}");
                }
        }

        [Test]
        public void Value_Order_Matters()
        {
            var seen = new HashSet<ulong> { Of(Points(11), Numbers(23)) };
            for (int i = 0; i < 23; i++)
                for (int j = 0; j < i; j++)
                {
                    var numbers = Numbers(23);
                    (numbers[i], numbers[j]) = (numbers[j], numbers[i]);
                    Assert.That(seen.Add(Of(Points(11), numbers)), $"numbers {i} and {j}");
                }
            for (int i = 0; i < 11; i++)
                for (int j = 0; j < i; j++)
                {
                    var points = Points(11);
                    (points[i], points[j]) = (points[j], points[i]);
                    Assert.That(seen.Add(Of(points, Numbers(23))), $"points {i} and {j}");
                }
        }

        [Test]
        public void Value_ListsOfZerosOfOtherLengths_Differ()
        {
            var seen = new HashSet<ulong>();
            for (int points = 0; points < 20; points++)
                for (int numbers = 0; numbers < 20; numbers++)
                    Assert.That(seen.Add(Of(new Vector3[points].ToList(), new int[numbers].ToList())),
                        $"{points} points, {numbers} numbers");
        }

        // Several chunks, the last one short; indices at the chunks' ends and some between.
        [Test]
        public void Value_OneNumberOfALongList_Matters()
        {
            const int count = 3 * ContentHash.ChunkSize + 5;
            List<Vector3> points = Points(count);
            List<int> numbers = Numbers(count);
            var seen = new HashSet<ulong> { Of(points, numbers) };
            foreach (int chunk in new[] { 0, 1, 2, 3 })
                foreach (int i in new[] { 0, 1, 4, ContentHash.ChunkSize / 2, ContentHash.ChunkSize - 1 }
                    .Select(i => chunk * ContentHash.ChunkSize + i).Where(i => i < count))
                {
                    numbers[i] ^= 1;
                    Assert.That(seen.Add(Of(points, numbers)), $"number {i}");
                    numbers[i] ^= 1;
                    var point = points[i];
                    points[i] += Vector3.forward;
                    Assert.That(seen.Add(Of(points, numbers)), $"point {i}");
                    points[i] = point;
                }
            Assert.That(seen, Has.Member(Of(points, numbers)));
            (numbers[0], numbers[ContentHash.ChunkSize]) = (numbers[ContentHash.ChunkSize], numbers[0]);
            Assert.That(seen.Add(Of(points, numbers)), "two numbers of different chunks");
        }

        static ulong Of(List<Vector3> points, List<int> numbers)
        {
            var hash = new ContentHash();
            hash.Add(points);
            hash.Add(numbers);
            return hash.Value;
        }

        static List<Vector3> Points(int count) =>
            Enumerable.Range(1, count).Select(i => new Vector3(i, -i, 0.5f * i)).ToList();

        static List<int> Numbers(int count) => Enumerable.Range(100, count).ToList();
    }
}
