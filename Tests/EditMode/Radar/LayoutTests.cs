using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The structs that C# and HLSL share mean the same bytes on both sides.</summary>
    public sealed class LayoutTests
    {
        [Test]
        public void SharedStructs_AreWholeRowsOfSixteenBytes()
        {
            Assert.That(Marshal.SizeOf<RayData>(), Is.EqualTo(48));
            Assert.That(Marshal.SizeOf<HitData>(), Is.EqualTo(32));
            Assert.That(Marshal.SizeOf<InstanceRecord>(), Is.EqualTo(112));
        }

        [Test]
        public void SharedStructs_ReadByAKernel_HaveTheFieldsThatCSharpWrote()
        {
            var ray = new RayData
            {
                LastHit = float3(1, 2, 3), PathLength = 4, Direction = float3(5, 6, 7), PathLengthRest = 8, InPhase = 9,
                Quadrature = 10, Pixel = 11, Bounces = 12
            };
            var instance = new InstanceRecord
            {
                ToLocalX = float4(13, 14, 15, 16), ToLocalY = float4(17, 18, 19, 20),
                ToLocalZ = float4(21, 22, 23, 24),
                RestX = float4(25, 26, 27, 28), RestY = float4(29, 30, 31, 32), RestZ = float4(33, 34, 35, 36),
                FirstRow = 37, Bank = 38, Stretch = 39, Rounding = 40
            };
            var hit = new HitData
            {
                Place = float3(41, 42, 43), Instance = 44, Direction = float3(45, 46, 47), Triangle = 48
            };
            var expected = Enumerable.Range(1, 48).Select(i => IsWhole(i) ? (uint)i : asuint((float)i)).ToArray();

            Assert.That(Unpack(ray, instance, hit, expected.Length), Is.EqualTo(expected));
        }

        [Test]
        public void InstanceRecord_OfATransform_TakesPointsAsTheTransformDoes()
        {
            var place = new Affine
            {
                X = double3(1, 2, 3), Y = double3(4, 5, 7), Z = double3(-2, 6, 1), Origin = double3(10, 20, 30)
            };
            var record = InstanceRecord.Of(place, 3, 4);
            float4 point = float4(0.5f, -1.5f, 2, 1);
            var taken = double3(dot(record.ToLocalX, point), dot(record.ToLocalY, point), dot(record.ToLocalZ, point));
            Assert.That(distance(taken, place.Point(double3(0.5, -1.5, 2))), Is.LessThan(1e-5));
            var third = new Affine
            {
                X = double3(1, 2, 3) / 3, Y = double3(4, 5, 7) / 3,
                Z = double3(-2, 6, 1) / 3, Origin = double3(10, 20, 30) / 3
            };
            Assert.That(record.Stretch, Is.EqualTo(sqrt(1 + 4 + 9 + 16 + 25 + 49 + 4 + 36 + 1)).Within(1e-5));
            Assert.That(record.Rounding, Is.EqualTo(60 * pow(2.0, -22)).Within(1e-6), "four steps of each coordinate");
            record = InstanceRecord.Of(third, 3, 4);
            var row = (double4)record.ToLocalX + (double4)record.RestX;
            Assert.That(length(row - double4(third.X.x, third.Y.x, third.Z.x, third.Origin.x)), Is.LessThan(1e-13));
        }

        [Test]
        public void WordsOfSums_StandWhereTheKernelPutsThem()
        {
            var inKernel = Constants("Sums.hlsl");
            var expected = new Dictionary<string, int>
            {
                ["SUM_SLOTS"] = RaySums.Slots, ["SUM_WORDS"] = RaySums.WordsPerSlot,
                ["SUM_HITS"] = RaySums.Hits, ["SUM_BOUNCES"] = RaySums.Bounces,
                ["SUM_RECEIVED"] = RaySums.Received, ["SUM_RETURNING"] = RaySums.Returning,
                ["SUM_LENGTH"] = RaySums.Length, ["SUM_IN_PHASE"] = RaySums.InPhase,
                ["SUM_QUADRATURE"] = RaySums.Quadrature, ["SUM_NODES"] = RaySums.Nodes,
                ["SUM_PAIRS"] = RaySums.Pairs, ["SUM_HISTOGRAM"] = RaySums.Histogram,
                ["PHASE_BINS"] = Signal.PhaseBins,
            };
            Assert.That(inKernel, Is.EquivalentTo(expected));
        }

        [Test]
        public void NumbersThatTheKernelAndItsCallerShare_AreTheSame()
        {
            var bindings = Constants("Bindings.hlsl");
            Assert.That(bindings["SHORTCUT_REACH"], Is.EqualTo((int)Shortcuts.Reach));
            Assert.That(bindings["SHORTCUT_LAST"], Is.EqualTo((int)Shortcuts.LastSegment));
            Assert.That(bindings["SHORTCUT_STARTS"], Is.EqualTo((int)Shortcuts.Starts));
            Assert.That(bindings["MOST_FEW"], Is.EqualTo(DeviceScene.MostFew));
            Assert.That(Constants("BinaryTree.hlsl")["BINARY_LEVELS"], Is.EqualTo(BoxTreeBuilder.MaxLevels));
            Assert.That(Constants("BinaryTree.hlsl")["ROOT"], Is.EqualTo(DeviceScene.TopRootRow));
            // The wide stack has 16 words: one a level, and three starts that wait.
            Assert.That(WideCollapse.MaxLevels - 1 + Constants("Starts.hlsl")["MOST_STARTS"] - 1,
                Is.LessThanOrEqualTo(16));
            Assert.That(Constants("Kernels.hlsl")["TILE_SIDE"], Is.EqualTo(PictureTiles.Side));
        }

        static Dictionary<string, int> Constants(string shader)
        {
            string source = System.IO.File.ReadAllText(
                System.IO.Path.Combine(Application.dataPath, "../Packages/com.glint.radar/Shaders", shader));
            return System.Text.RegularExpressions.Regex.Matches(source, @"static const uint (\w+) = (\d+);")
                .Cast<System.Text.RegularExpressions.Match>()
                .ToDictionary(match => match.Groups[1].Value, match => int.Parse(match.Groups[2].Value));
        }

        static bool IsWhole(int field) => new[] { 11, 12, 37, 38, 44, 48 }.Contains(field);

        static uint[] Unpack(RayData ray, InstanceRecord instance, HitData hit, int count)
        {
            var shader = TestKernels.Layout;
            int kernel = shader.FindKernel("Unpack");
            var buffers = new List<GraphicsBuffer>();
            void Bind<T>(string name, T second) where T : struct
            {
                var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 2, Marshal.SizeOf<T>());
                buffers.Add(buffer);
                buffer.SetData(new[] { default, second });
                shader.SetBuffer(kernel, name, buffer);
            }
            try
            {
                Bind("_RayIn", ray);
                Bind("_InstanceIn", instance);
                Bind("_HitIn", hit);
                var fields = new GraphicsBuffer(GraphicsBuffer.Target.Structured, count, sizeof(uint));
                buffers.Add(fields);
                shader.SetBuffer(kernel, "_Fields", fields);
                shader.Dispatch(kernel, 1, 1, 1);
                var values = new uint[count];
                fields.GetData(values);
                return values;
            }
            finally
            {
                buffers.ForEach(buffer => buffer.Dispose());
            }
        }
    }
}
