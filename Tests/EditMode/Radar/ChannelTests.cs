using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Channels hold the sums of the maximum number of rays with the largest parts, and refuse larger parts by name.
    /// </summary>
    public sealed class ChannelTests
    {
        const int Threads = 1024, FirstWideWord = Channel.WordsPerSlot - 3;
        const float WidePart = 1 << 20;

        // Units of one ray's largest part.
        static readonly decimal s_units = (decimal)(Channel.InPhase.MaxPart * Channel.InPhase.Scale),
            s_wideUnits = (decimal)WidePart * (1 << 24);

        [Test]
        public void Add_LargestPartOfTheLastRays_IsExact([Values(1, -1)] int sign)
        {
            // As if all rays but the last 1,024 had been added; and from 0, across the words' limits.
            foreach (long before in new[] { Channel.MaxRays - Threads, 0, -Threads / 2 })
            {
                var slots = new uint[WorkCounts.First];
                Put(slots, Channel.InPhase.Word, 2, sign * before * s_units);
                Put(slots, FirstWideWord, 3, sign * before * s_wideUnits);
                Add(slots, sign * (float)Channel.InPhase.MaxPart, sign * WidePart);
                Assert.That(Channel.InPhase.SumOf(slots, 0), Is.EqualTo(sign * (before + Threads) * s_units));
                Assert.That(Channel.SumOf(slots, FirstWideWord, 3),
                    Is.EqualTo(sign * (before + Threads) * s_wideUnits));
                Assert.DoesNotThrow(() => Channel.CheckOverflow(slots, "test"));
            }
        }

        [TestCase(1.00001f)]
        [TestCase(-1.00001f)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(float.NegativeInfinity)]
        [TestCase(float.NaN)]
        public void Add_LargerPart_IsRefusedByName(float part)
        {
            var slots = new uint[WorkCounts.First];
            Add(slots, part, part * 2 * WidePart);
            Assert.That(Channel.InPhase.SumOf(slots, 0), Is.Zero, "not wrapped");
            Assert.That(Channel.SumOf(slots, FirstWideWord, 3), Is.Zero, "not wrapped");
            Assert.That(slots[Channel.Overflow.Word] >> 31, Is.EqualTo(1), "the wide channel's bit");
            var problem = Assert.Throws<GlintException>(() => Channel.CheckOverflow(slots, "Radar"));
            Assert.That(problem.Message, Does.StartWith("Radar: ").And.Contain("'in_phase'"));
        }

        [Test]
        public void Sums_BinOfMoreRaysThan32Bits_IsExact()
        {
            var (settings, view) = (TestRadar.Settings(16, 9), TestRadar.LookAt(double3(9, 10, 11), 0));
            var sums = new ChannelSums(new RayGrid(settings, view, -1, 1));
            var slice = new uint[WorkCounts.First];
            slice[Channel.Histogram.Word] = 3000000000;
            sums.Add(slice);
            sums.Add(slice);
            Assert.That(sums.ToSums(settings, view).PhaseHistogram[0], Is.EqualTo(6000000000));
        }

        // Two's complement.
        static void Put(uint[] slots, int first, int count, decimal units)
        {
            var number = new BigInteger(units);
            for (int word = 0; word < count; word++)
                slots[first + word] = (uint)(number >> (32 * word) & uint.MaxValue);
        }

        static void Add(uint[] slots, float part, float widePart)
        {
            var shader = TestKernels.Channels;
            int kernel = shader.FindKernel("AddParts");
            var sums = new ComputeBuffer(slots.Length, 4);
            try
            {
                sums.SetData(slots);
                shader.SetBuffer(kernel, "_Sums", sums);
                shader.SetFloat("_Part", part);
                shader.SetFloat("_WidePart", widePart);
                shader.Dispatch(kernel, Threads / 64, 1, 1);
                sums.GetData(slots);
            }
            finally
            {
                sums.Release();
            }
        }
    }
}
