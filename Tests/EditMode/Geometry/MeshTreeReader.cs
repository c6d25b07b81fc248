using System;
using System.Collections.Generic;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Reads a mesh's trees and checks all that the shaders count on.</summary>
    sealed class MeshTreeReader
    {
        readonly List<ulong> _triangles = new List<ulong>();

        /// <summary>Pairs of triangles, and triangles left alone.</summary>
        public int Leaves { get; private set; }

        /// <summary>Bytes of all parts.</summary>
        public long Bytes { get; private set; }

        /// <summary>Most inner levels of a part.</summary>
        public int Levels { get; private set; }

        public static MeshTreeReader Check(TriangleMesh mesh, TreeShape shape) =>
            Check(mesh, shape, MeshTree.Build(mesh, shape));

        public static MeshTreeReader Check(TriangleMesh mesh, TreeShape shape, MeshTree tree)
        {
            var reader = new MeshTreeReader();
            foreach (var part in tree.Parts)
                reader.ReadPart(part, shape);
            var expected = Expected(mesh);
            Assert.That(tree.TriangleCount, Is.EqualTo(expected.Length), "triangles");
            var found = reader._triangles.ToArray();
            Array.Sort(found);
            Array.Sort(expected);
            CollectionAssert.AreEqual(expected, found, "triangles in leaves");
            CheckCover(mesh, tree);
            return reader;
        }

        void ReadPart(TreePart part, TreeShape shape)
        {
            var tree = TreeReader.Read(part.Words, shape, row => ReadPair(part.Words, row));
            Assert.That(tree.Levels, Is.LessThanOrEqualTo(shape == TreeShape.Wide ? 16 : 32), "levels");
            Assert.That(tree.Leaves, Is.LessThanOrEqualTo(1 << 20), "leaves of a part");
            if (shape == TreeShape.Wide)
                Assert.That(part.Words.Length / 3, Is.LessThanOrEqualTo(1 << 20), "records of a part");
            Assert.That(16L * part.Words.Length, Is.LessThanOrEqualTo(96 << 20), "bytes of a part");
            Assert.That(double3(part.Low), Is.EqualTo(tree.Bounds.Low));
            Assert.That(double3(part.High), Is.EqualTo(tree.Bounds.High));
            Levels = Math.Max(Levels, tree.Levels);
            Leaves += tree.Leaves;
            Bytes += 16L * part.Words.Length;
        }

        Bounds3 ReadPair(uint4[] rows, int row)
        {
            float4 r0 = asfloat(rows[row]), r1 = asfloat(rows[row + 1]), r2 = asfloat(rows[row + 2]);
            float3 a = r0.xyz, b = float3(r0.w, r1.xy), c = float3(r1.zw, r2.x), d = r2.yzw;
            _triangles.Add(Key(a, b, c));
            if (any(d != c))
                _triangles.Add(Key(a, c, d));
            var bounds = Bounds3.Empty;
            bounds.Add(a);
            bounds.Add(b);
            bounds.Add(c);
            bounds.Add(d);
            return bounds;
        }

        // Triangles with a normal in float32.
        static ulong[] Expected(TriangleMesh mesh)
        {
            var keys = new List<ulong>();
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                double normalSquared = lengthsq(cross((double3)b - a, (double3)c - a));
                if (normalSquared >= 1e-32 && normalSquared <= float.MaxValue)
                    keys.Add(Key(a, b, c));
            }
            return keys.ToArray();
        }

        // The same for any order of the corners, and for nothing else but by a chance of one in 2^64.
        static ulong Key(float3 a, float3 b, float3 c) => Mix(Key(a) + Key(b) + Key(c));

        static ulong Key(float3 place) => Mix(Mix(Mix(asuint(place.x)) + asuint(place.y)) + asuint(place.z));

        static ulong Mix(ulong value)
        {
            value = (value + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
            value = (value ^ (value >> 29)) * 0x94d049bb133111eb;
            return value ^ (value >> 32);
        }

        static void CheckCover(TriangleMesh mesh, MeshTree tree)
        {
            Assert.That(tree.CoverLow.Length, Is.EqualTo(tree.CoverHigh.Length));
            Assert.That(tree.CoverLow.Length, Is.InRange(tree.Parts.Length > 0 ? 1 : 0, 64), "boxes of the cover");
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                double normalSquared = lengthsq(cross((double3)b - a, (double3)c - a));
                if (normalSquared < 1e-32 || normalSquared > float.MaxValue)
                    continue;
                float3 low = min(a, min(b, c)), high = max(a, max(b, c));
                bool held = false;
                for (int i = 0; i < tree.CoverLow.Length && !held; i++)
                    held = all(tree.CoverLow[i] <= low) && all(tree.CoverHigh[i] >= high);
                if (!held)
                    Assert.Fail($"no box of the cover holds triangle {t}");
            }
        }
    }
}
