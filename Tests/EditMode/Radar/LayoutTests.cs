using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The structs shared by C# and HLSL have the same layout on both sides.</summary>
    public sealed class LayoutTests
    {
        [Test]
        public void SharedStructs_AreWholeRowsOfSixteenBytes()
        {
            Assert.That(Marshal.SizeOf<RayData>(), Is.EqualTo(48));
            Assert.That(Marshal.SizeOf<HitData>(), Is.EqualTo(48));
            Assert.That(Marshal.SizeOf<InstanceRecord>(), Is.EqualTo(144));
            Assert.That(Marshal.SizeOf<SurfaceSample>(), Is.EqualTo(32));
        }

        [Test]
        public void SharedStructs_ReadByAKernel_HaveTheFieldsThatCSharpWrote()
        {
            var ray = new RayData
            {
                LastHit = float3(1, 2, 3), PathLength = 4, Direction = float3(5, 6, 7), PathLengthLo = 8, InPhase = 9,
                Quadrature = 10, Pixel = 11, Bounces = 12
            };
            var instance = new InstanceRecord
            {
                ToLocalX = float4(13, 14, 15, 16), ToLocalY = float4(17, 18, 19, 20),
                ToLocalZ = float4(21, 22, 23, 24),
                ToLocalXLo = float4(25, 26, 27, 28),
                ToLocalYLo = float4(29, 30, 31, 32), ToLocalZLo = float4(33, 34, 35, 36),
                FirstRow = 37, Page = 38, Stretch = 39, Rounding = 40,
                FirstRecordRow = 41, FirstIdentityRow = 42, FirstRange = 43, RangeCount = 44, Instance = 45
            };
            var hit = new HitData
            {
                Position = float3(46, 47, 48), Instance = 49, Direction = float3(50, 51, 52), Triangle = 53,
                Object = 54, Surface = 55
            };
            var sample = new SurfaceSample { Position = float3(56, 57, 58), Area = 59, Instance = 60, Triangle = 61 };
            var expected = Enumerable.Range(1, 61).Select(i => IsWhole(i) ? (uint)i : asuint((float)i)).ToArray();

            Assert.That(Unpack(ray, instance, hit, sample, expected.Length), Is.EqualTo(expected));
        }

        [Test]
        public void InstanceRecord_OfATransform_TakesPointsAsTheTransformDoes()
        {
            var transform = new Affine
            {
                X = double3(1, 2, 3), Y = double3(4, 5, 7), Z = double3(-2, 6, 1), Origin = double3(10, 20, 30)
            };
            var record = InstanceRecord.Of(transform, 3, 4);
            float4 point = float4(0.5f, -1.5f, 2, 1);
            var taken = double3(dot(record.ToLocalX, point), dot(record.ToLocalY, point), dot(record.ToLocalZ, point));
            Assert.That(distance(taken, transform.Point(double3(0.5, -1.5, 2))), Is.LessThan(1e-5));
            var third = new Affine
            {
                X = double3(1, 2, 3) / 3, Y = double3(4, 5, 7) / 3,
                Z = double3(-2, 6, 1) / 3, Origin = double3(10, 20, 30) / 3
            };
            Assert.That(record.Stretch, Is.EqualTo(sqrt(1 + 4 + 9 + 16 + 25 + 49 + 4 + 36 + 1)).Within(1e-5));
            Assert.That(record.Rounding, Is.EqualTo(60 * pow(2.0, -22)).Within(1e-6), "four steps of each coordinate");
            record = InstanceRecord.Of(third, 3, 4);
            var row = (double4)record.ToLocalX + (double4)record.ToLocalXLo;
            Assert.That(length(row - double4(third.X.x, third.Y.x, third.Z.x, third.Origin.x)), Is.LessThan(1e-13));
        }

        // A name without a counterpart fails on either side.
        [Test]
        public void Constants_OfTheKernels_AreThoseOfCSharp()
        {
            var expected = new Dictionary<string, double>
            {
                ["SUM_SLOTS"] = Channel.Slots, ["SUB_RAY_SLOTS"] = Channel.SubRaySlots, ["SUM_WORDS"] = Channel.WordsPerSlot, ["PHASE_BINS"] = Signal.PhaseBins,
                ["LENGTH_UNITS"] = Channel.Length.Scale, ["PHASOR_UNITS"] = Channel.InPhase.Scale,
                ["MAX_PHASOR_PART"] = Channel.InPhase.MaxPart, ["LENGTH_OVERFLOW"] = 1u << Channel.Length.Number,
                ["IN_PHASE_OVERFLOW"] = 1u << Channel.InPhase.Number,
                ["QUADRATURE_OVERFLOW"] = 1u << Channel.Quadrature.Number,
                ["CULL_REACH"] = (int)Culling.Reach, ["CULL_LAST"] = (int)Culling.LastSegment,
                ["CULL_ENTRY_POINTS"] = (int)Culling.EntryPoints,
                ["READBACK_NONE"] = (int)RayReadback.None, ["READBACK_RECEIVED"] = (int)RayReadback.Received,
                ["READBACK_ALL"] = (int)RayReadback.All,
                ["COUNT_KNOWN"] = WorkCounts.First, ["COUNT_SEARCHED"] = WorkCounts.First + 1,
                ["COUNT_SUB_KNOWN"] = WorkCounts.First + 2, ["COUNT_SUB_SEARCHED"] = WorkCounts.First + 3,
                ["COUNT_RECEIVED"] = WorkCounts.First + 4, ["COUNT_CHOSEN"] = WorkCounts.ChosenWord,
                ["RECEIVED_RAYS"] = WorkCounts.ReceivedRays, ["MAX_REFINED"] = CandidateList.MaxRefined,
                ["CANDIDATE_PADDING"] = CandidateList.Padding, ["SPREAD_THREADS"] = CandidateList.SpreadThreads,
                ["MAX_CHOSEN"] = SlicePass.MaxChosen, ["REFINE_ARGUMENTS"] = SliceArguments.Refine,
                ["SUB_RAY_ARGUMENTS"] = SliceArguments.SubRays,
                ["REFINE_SUB_RAY_ARGUMENTS"] = SliceArguments.RefineSubRays,
                ["SUB_RAYS"] = SamplingEstimate.SubRays, ["MAX_BOUNCES"] = RadarSettings.BounceLimit,
                ["NO_LENGTH"] = ReceivedRay.NoLength, ["NO_PIXEL"] = ReceivedRay.NoPixel, ["RAY_RECEIVED"] = RayData.Received,
                ["TILE_SIDE"] = PictureTiles.Side, ["RAYS_A_TILE"] = PictureTiles.Rays,
                ["GROUPS_A_ROW"] = TraceKernel.GroupsARow, ["MAX_INLINE_INSTANCES"] = DeviceScene.MaxInlineInstances,
                ["ROOT"] = DeviceScene.InstanceBvhRootRow, ["BINARY_LEVELS"] = BinaryBvhBuilder.MaxLevels,
                // The wide stack has 16 words: one for each level, and the pending entry points.
                ["MAX_ENTRY_POINTS"] = 16 - WideCollapse.MaxLevels + 2
            };
            foreach (var channel in Channel.All)
                expected["SUM_" + channel.Name.ToUpperInvariant()] = channel.Word;
            Assert.That(ShaderConstants.Of("Constants.hlsl"), Is.EquivalentTo(expected));
        }

        [Test]
        public void Channels_OfTheLargestParts_HoldTheirSums()
        {
            foreach (var channel in Channel.All.Where(channel => channel != Channel.Overflow))
            {
                // One word is unsigned; with more words the highest bit is the sign.
                int bits = channel.Words == 1 ? 32 : 32 * channel.Words - 1;
                Assert.That(channel.MaxPart * channel.Scale * Channel.MaxRays, Is.LessThan(pow(2.0, bits)),
                    channel.Name);
            }
            Assert.That(Channel.Histogram, Is.SameAs(Channel.All.Last()));
            Assert.That(Channel.Histogram.Word + Signal.PhaseBins, Is.LessThanOrEqualTo(Channel.WordsPerSlot));
        }

        static bool IsWhole(int field) => new[] { 11, 12, 37, 38, 41, 42, 43, 44, 45, 49, 53, 54, 55, 60, 61 }.Contains(field);

        static uint[] Unpack(RayData ray, InstanceRecord instance, HitData hit, SurfaceSample sample,
            int count)
        {
            using (var fields = new ShaderFields(TestKernels.Layout))
            {
                fields.Bind("_RayIn", ray);
                fields.Bind("_InstanceIn", instance);
                fields.Bind("_HitIn", hit);
                fields.Bind("_SampleIn", sample);
                return fields.Unpack(count);
            }
        }
    }
}
