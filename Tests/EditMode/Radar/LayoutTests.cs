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
            Assert.That(Marshal.SizeOf<BvhNode>(), Is.EqualTo(32));
            Assert.That(Marshal.SizeOf<TriangleRecord>(), Is.EqualTo(48));
            Assert.That(Marshal.SizeOf<GroupSum>(), Is.EqualTo(16));
        }

        [Test]
        public void SharedStructs_ReadByAKernel_HaveTheFieldsThatCSharpWrote()
        {
            var ray = new RayData { LastHit = float3(1, 2, 3), PathLength = 4, Direction = float3(5, 6, 7), Phase = 8, InPhase = 9, Quadrature = 10, Pixel = 11, Bounces = 12 };
            var node = new BvhNode { Min = float3(13, 14, 15), First = 16, Max = float3(17, 18, 19), Count = 20 };
            var triangle = new TriangleRecord { Corner = float3(21, 22, 23), Unused0 = 24, Edge1 = float3(25, 26, 27), Edge2 = float3(28, 29, 30) };
            var sum = new GroupSum { Hits = 31, Bounces = 32, PathLength = 33 };
            var expected = Enumerable.Range(1, 33).Select(i => IsWhole(i) ? (uint)i : asuint((float)i)).ToArray();

            Assert.That(Unpack(ray, node, triangle, sum, expected.Length), Is.EqualTo(expected));
        }

        static bool IsWhole(int field) => new[] { 11, 12, 16, 20, 24, 31, 32 }.Contains(field);

        static uint[] Unpack(RayData ray, BvhNode node, TriangleRecord triangle, GroupSum sum, int count)
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
                Bind("_NodeIn", node);
                Bind("_TriangleIn", triangle);
                Bind("_SumIn", sum);
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
