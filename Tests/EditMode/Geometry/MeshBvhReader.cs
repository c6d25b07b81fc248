using System;
using System.Collections.Generic;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Reads a mesh's BVHs and checks everything that the shaders rely on.</summary>
    sealed class MeshBvhReader
    {
        readonly TriangleMesh _mesh;
        readonly List<ulong> _triangles = new List<ulong>();

        MeshBvhReader(TriangleMesh mesh) => _mesh = mesh;

        /// <summary>Number of triangle pairs and single triangles.</summary>
        public int Leaves { get; private set; }

        /// <summary>Bytes of all parts.</summary>
        public long Bytes { get; private set; }

        /// <summary>Largest number of inner levels of a part.</summary>
        public int Levels { get; private set; }

        public static MeshBvhReader Check(TriangleMesh mesh, BvhLayout layout) =>
            Check(mesh, layout, MeshBvh.Build(mesh, layout));

        public static MeshBvhReader Check(TriangleMesh mesh, BvhLayout layout, MeshBvh bvh)
        {
            var reader = new MeshBvhReader(mesh);
            foreach (var part in bvh.Parts)
                reader.ReadPart(part, layout);
            var expected = Expected(mesh);
            Assert.That(bvh.TriangleCount, Is.EqualTo(expected.Length), "triangles");
            var found = reader._triangles.ToArray();
            Array.Sort(found);
            Array.Sort(expected);
            CollectionAssert.AreEqual(expected, found, "triangles in leaves");
            CheckCover(mesh, bvh);
            return reader;
        }

        void ReadPart(BvhPart part, BvhLayout layout)
        {
            var bvh = BvhReader.Read(part.Rows.AsSpan(0, part.FirstIdentityRow).ToArray(), layout,
                row => ReadPair(part, row));
            Assert.That(bvh.Levels, Is.LessThanOrEqualTo(layout == BvhLayout.Wide ? 16 : 32), "levels");
            Assert.That(bvh.Leaves, Is.LessThanOrEqualTo(1 << 20), "leaves of a part");
            if (layout == BvhLayout.Wide)
                Assert.That(part.Rows.Length / 3, Is.LessThanOrEqualTo(1 << 20), "records of a part");
            Assert.That(16L * part.Rows.Length, Is.LessThanOrEqualTo(96 << 20), "bytes of a part");
            Assert.That(double3(part.Min), Is.EqualTo(bvh.Bounds.Min));
            Assert.That(double3(part.Max), Is.EqualTo(bvh.Bounds.Max));
            Levels = Math.Max(Levels, bvh.Levels);
            Leaves += bvh.Leaves;
            Bytes += 16L * part.Rows.Length;
        }

        Bounds3 ReadPair(BvhPart part, int row)
        {
            var rows = part.Rows;
            float4 r0 = asfloat(rows[row]), r1 = asfloat(rows[row + 1]), r2 = asfloat(rows[row + 2]);
            float3 a = r0.xyz, b = float3(r0.w, r1.xy), c = float3(r1.zw, r2.x), d = r2.yzw;
            _triangles.Add(Key(a, b, c));
            // Two leaves share a row with the numbers of their triangles.
            int leaf = (row - part.FirstRecordRow) / 3;
            uint4 names = rows[part.FirstIdentityRow + leaf / 2];
            CheckName(leaf % 2 == 0 ? names.x : names.z, Key(a, b, c));
            if (any(d != c))
            {
                _triangles.Add(Key(a, c, d));
                CheckName(leaf % 2 == 0 ? names.y : names.w, Key(a, c, d));
            }
            var bounds = Bounds3.Empty;
            bounds.Add(a);
            bounds.Add(b);
            bounds.Add(c);
            bounds.Add(d);
            return bounds;
        }

        void CheckName(uint triangle, ulong key)
        {
            _mesh.GetTriangle((int)triangle, out var a, out var b, out var c);
            if (Key(a, b, c) != key)
                Assert.Fail($"a leaf's triangle is not number {triangle}");
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

        // The same for any order of the corners. Other triangles collide with a probability of 2^-64.
        static ulong Key(float3 a, float3 b, float3 c) => Mix(Key(a) + Key(b) + Key(c));

        static ulong Key(float3 position) =>
            Mix(Mix(Mix(asuint(position.x)) + asuint(position.y)) + asuint(position.z));

        static ulong Mix(ulong value)
        {
            value = (value + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
            value = (value ^ (value >> 29)) * 0x94d049bb133111eb;
            return value ^ (value >> 32);
        }

        static void CheckCover(TriangleMesh mesh, MeshBvh bvh)
        {
            Assert.That(bvh.CoverMin.Length, Is.EqualTo(bvh.CoverMax.Length));
            Assert.That(bvh.CoverMin.Length, Is.InRange(bvh.Parts.Length > 0 ? 1 : 0, 64), "boxes of the cover");
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var a, out var b, out var c);
                double normalSquared = lengthsq(cross((double3)b - a, (double3)c - a));
                if (normalSquared < 1e-32 || normalSquared > float.MaxValue)
                    continue;
                float3 boxMin = min(a, min(b, c)), boxMax = max(a, max(b, c));
                bool isCovered = false;
                for (int i = 0; i < bvh.CoverMin.Length && !isCovered; i++)
                    isCovered = all(bvh.CoverMin[i] <= boxMin) && all(bvh.CoverMax[i] >= boxMax);
                if (!isCovered)
                    Assert.Fail($"no box of the cover holds triangle {t}");
            }
        }
    }
}
