using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Reads BVHs as the shaders do, in double precision, and checks that each box contains its subtree. It shares no
    /// code with the encoders.
    /// </summary>
    sealed class BvhReader
    {
        // The row of a binary BVH's root.
        const int BinaryRoot = 1;

        readonly uint4[] _rows;
        readonly BvhLayout _layout;
        readonly Func<int, Bounds3> _readLeaf;
        readonly bool[] _seen;
        double _margin;

        BvhReader(uint4[] rows, BvhLayout layout, Func<int, Bounds3> readLeaf)
        {
            _rows = rows;
            _layout = layout;
            _readLeaf = readLeaf;
            _seen = new bool[rows.Length];
        }

        /// <summary>Number of inner levels.</summary>
        public int Levels { get; private set; }

        public int Leaves { get; private set; }

        /// <summary>Bounds of all leaves' content.</summary>
        public Bounds3 Bounds { get; private set; }

        /// <param name="rows">The BVH.</param>
        /// <param name="layout">Its layout.</param>
        /// <param name="readLeaf">Reads the leaf at a row and returns its content.</param>
        public static BvhReader Read(uint4[] rows, BvhLayout layout, Func<int, Bounds3> readLeaf)
        {
            var reader = new BvhReader(rows, layout, readLeaf);
            if (layout == BvhLayout.Binary)
            {
                reader.Mark(0, BinaryRoot);
                Assert.That(rows[0].w, Is.Zero, "the last word of the first row");
            }
            reader.Bounds = reader.ReadNode(layout == BvhLayout.Binary ? BinaryRoot : 0, 1);
            Assert.That(reader._seen.Count(seen => !seen), Is.Zero, "rows that nothing refers to");
            return reader;
        }

        Bounds3 ReadNode(int row, int level)
        {
            Levels = Math.Max(Levels, level);
            return _layout == BvhLayout.Binary ? ReadBinary(row, level) : ReadWide(row, level);
        }

        Bounds3 ReadLeaf(int row)
        {
            Leaves++;
            Mark(row, 3);
            return _readLeaf(row);
        }

        Bounds3 ReadBinary(int row, int level)
        {
            Mark(row, 3);
            uint4 a = _rows[row], b = _rows[row + 1], halves = _rows[row + 2];
            if (halves.w != 0)
                Assert.Fail($"row {row + 2}: the last word is not 0");
            Bounds3 boxA = BinaryBox(a, halves.xyz & 0xffff0000), boxB = BinaryBox(b, halves.xyz << 16);
            if (row == BinaryRoot)
            {
                var whole = boxA;
                whole.Add(boxB);
                _margin = MarginOf(whole);
            }
            var all = ReadBinaryChild(row, a.w, boxA, level);
            if (a.w == b.w)
            {
                if (row != BinaryRoot || a.w >> 31 == 0)
                    Assert.Fail($"row {row}: only a root over one leaf has the same child twice");
                Expect(boxB, all, _margin, row);
            }
            else
                all.Add(ReadBinaryChild(row, b.w, boxB, level));
            return all;
        }

        Bounds3 BinaryBox(uint4 child, uint3 halfSize)
        {
            double3 centre = double3(asfloat(_rows[0].xyz)) + double3(asfloat(child.xyz)),
                half = double3(asfloat(halfSize));
            return new Bounds3 { Min = centre - half, Max = centre + half };
        }

        Bounds3 ReadBinaryChild(int row, uint reference, in Bounds3 box, int level)
        {
            int childRow = (int)(reference & 0x7fffffff);
            var content = reference >> 31 == 1 ? ReadLeaf(childRow) : ReadNode(childRow, level + 1);
            Expect(box, content, _margin, row);
            return content;
        }

        Bounds3 ReadWide(int row, int level)
        {
            Mark(row, 3);
            uint[] words = Enumerable.Range(0, 12).Select(i => _rows[row + i / 4][i % 4]).ToArray();
            double3 origin = double3(asfloat(words[0]), asfloat(words[1]), asfloat(words[2]));
            uint3 exponents = uint3(words[3], words[3] >> 8, words[3] >> 16) & 0xffu;
            uint leafMask = words[3] >> 24 & 0xf, validMask = words[3] >> 28;
            if (words[11] != 0 || (leafMask & ~validMask) != 0 || !new uint[] { 1, 3, 7, 15 }.Contains(validMask)
                || any(exponents == 0) || any(exponents == 255))
                Assert.Fail($"row {row}: masks, exponents or the last word: {words[3]:x} {words[11]:x}");
            double3 cell = double3(asfloat(exponents << 23));

            var all = Bounds3.Empty;
            Bounds3 BoxOf(int child)
            {
                double3 Plane(int word) => origin + cell * double3(Cells(words[word], child),
                    Cells(words[word + 1], child), Cells(words[word + 2], child));
                return new Bounds3 { Min = Plane(4), Max = Plane(7) };
            }
            var children = Enumerable.Range(0, 4).Where(child => (validMask >> child & 1) != 0).ToArray();
            if (row == 0)
            {
                var whole = Bounds3.Empty;
                foreach (int child in children)
                    whole.Add(BoxOf(child));
                _margin = MarginOf(whole);
            }
            foreach (int child in children)
            {
                int childRow = 3 * ((int)words[10] + child);
                var content = (leafMask >> child & 1) != 0 ? ReadLeaf(childRow) : ReadNode(childRow, level + 1);
                Expect(BoxOf(child), content, max(_margin, cell / 64), row);
                all.Add(content);
            }
            double largest = cmax(max(abs(all.Min), abs(all.Max)));
            if (cmin(cell) < largest / (1 << 21))
                Assert.Fail($"row {row}: cells of {cmin(cell)} m at {largest} m");
            return all;
        }

        // Position error of a float32 ray, relative to the scene's size.
        static double MarginOf(in Bounds3 whole) => 1e-6 * cmax(whole.Max - whole.Min);

        static double Cells(uint word, int child) => word >> (8 * child) & 0xff;

        static void Expect(in Bounds3 box, in Bounds3 content, double3 margin, int row)
        {
            if (!box.Holds(content, margin))
                Assert.Fail($"row {row}: the box {box.Min} to {box.Max} does not hold {content.Min} to {content.Max} "
                    + $"with a margin of {margin}");
        }

        void Mark(int row, int count)
        {
            for (int i = row; i < row + count; i++)
            {
                if (_seen[i])
                    Assert.Fail($"row {i} is part of two nodes or leaves");
                _seen[i] = true;
            }
        }
    }
}
