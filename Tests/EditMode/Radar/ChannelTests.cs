using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>
    /// Channels hold the sums of the most rays at their largest parts, and refuse larger parts by name.
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
            // As if all rays but the last 1,024 had been added; and from 0, across the limits of the words.
            foreach (long before in new[] { Channel.MaxRays - Threads, 0, -Threads / 2 })
            {
                var words = new uint[Channel.Slots * Channel.WordsPerSlot];
                Put(words, Channel.InPhase.Word, 2, sign * before * s_units);
                Put(words, FirstWideWord, 3, sign * before * s_wideUnits);
                Add(words, sign * (float)Channel.InPhase.MaxPart, sign * WidePart);
                Assert.That(Channel.InPhase.SumOf(words, 0), Is.EqualTo(sign * (before + Threads) * s_units));
                Assert.That(Channel.SumOf(words, FirstWideWord, 3), Is.EqualTo(sign * (before + Threads) * s_wideUnits));
                Assert.DoesNotThrow(() => Channel.CheckOverflow(words, "test"));
            }
        }

        [TestCase(1.00001f)]
        [TestCase(-1.00001f)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(float.NegativeInfinity)]
        [TestCase(float.NaN)]
        public void Add_LargerPart_IsRefusedByName(float part)
        {
            var words = new uint[Channel.Slots * Channel.WordsPerSlot];
            Add(words, part, part * 2 * WidePart);
            Assert.That(Channel.InPhase.SumOf(words, 0), Is.Zero, "not wrapped");
            Assert.That(Channel.SumOf(words, FirstWideWord, 3), Is.Zero, "not wrapped");
            Assert.That(words[Channel.Overflow.Word] >> 31, Is.EqualTo(1), "the wide channel's bit");
            var problem = Assert.Throws<GlintException>(() => Channel.CheckOverflow(words, "Radar"));
            Assert.That(problem.Message, Does.StartWith("Radar: ").And.Contain("'in_phase'"));
        }

        // In two's complement.
        static void Put(uint[] words, int first, int count, decimal units)
        {
            var number = new BigInteger(units);
            for (int word = 0; word < count; word++)
                words[first + word] = (uint)(number >> (32 * word) & uint.MaxValue);
        }

        static void Add(uint[] words, float part, float widePart)
        {
            var shader = TestKernels.Channels;
            int kernel = shader.FindKernel("AddParts");
            var sums = new ComputeBuffer(words.Length, 4);
            try
            {
                sums.SetData(words);
                shader.SetBuffer(kernel, "_Sums", sums);
                shader.SetFloat("_Part", part);
                shader.SetFloat("_WidePart", widePart);
                shader.Dispatch(kernel, Threads / 64, 1, 1);
                sums.GetData(words);
            }
            finally
            {
                sums.Release();
            }
        }
    }
}
