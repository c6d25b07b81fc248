using System;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Writes a BVH in <see cref="BvhLayout.Wide"/>, in records of 3 rows that number from 0, the root.
    /// A node's 12 words: origin x, y, z; exponents of the cell's sides and masks;
    /// lower planes of the children's boxes in cells from the origin, x, y, z with a byte for each child; upper planes;
    /// record of the first child; 0.
    /// </summary>
    sealed class WideEncoder
    {
        const int RecordRows = 3;

        /// <summary>
        /// A leaf's record and a third of a node's: a node replaces one record by four.
        /// </summary>
        public const double MinRowsPerLeaf = RecordRows * (1 + 1 / (WideCollapse.MaxChildren - 1.0)) * (1 - 1e-6);

        const int LastCell = 255;

        // Cells by which each plane is moved outwards at least, in addition to the BVH's margin; the kernels rely on
        // half of it.
        const double Margin = 1.0 / 32;

        // Minimum side of a cell as a fraction of the largest coordinate, so that float32 resolves a cell.
        const double MinCell = 1.0 / (1 << 21);
        const double MinNormal = 1.17549435e-38;

        readonly BinaryBvh _bvh;
        readonly ArraySegment<Bvh4Node> _nodes;
        readonly ILeafWriter _writer;
        readonly double _margin;
        readonly uint4[] _rows;

        WideEncoder(BinaryBvh bvh, ArraySegment<Bvh4Node> nodes, ILeafWriter writer)
        {
            _bvh = bvh;
            _nodes = nodes;
            _writer = writer;
            _margin = bvh.Margin;
            _rows = new uint4[FirstIdentityRow + writer.IdentityRows(nodes.Count)];
        }

        int FirstIdentityRow => RecordRows * _nodes.Count;

        /// <summary>Leaves that always fit into this many records, even if nodes have only two children.</summary>
        public static int MaxLeaves(int records) => records / 2;

        /// <summary>The rows of a subtree.</summary>
        /// <param name="firstIdentityRow">First of the identity rows, behind the records.</param>
        public static uint4[] Encode(BinaryBvh bvh, int root, ILeafWriter writer, out int firstIdentityRow)
        {
            var encoder = new WideEncoder(bvh, WideCollapse.Collapse(bvh, root), writer);
            Blocks.For(encoder._nodes.Count, (from, to) =>
            {
                for (int record = from; record < to; record++)
                    encoder.WriteRecord(record);
            });
            firstIdentityRow = encoder.FirstIdentityRow;
            return encoder._rows;
        }

        void WriteRecord(int record)
        {
            var node = _nodes.Array[record];
            if (node.ChildCount == 0)
                _writer.Write(_bvh.Leaves[~node.Binary].Item, _rows, RecordRows * record, record,
                    FirstIdentityRow);
            else
                WriteNode(record, node);
        }

        void WriteNode(int record, in Bvh4Node node)
        {
            var box = _bvh.BoxOf(node.Binary);
            double largest = cmax(max(abs((double3)box.Min), abs((double3)box.Max)));
            double minCell = Math.Max(MinCell * largest, MinNormal);
            Axis x = new Axis(box.Min.x, box.Max.x, _margin, minCell), y =
                new Axis(box.Min.y, box.Max.y, _margin, minCell), z = new Axis(box.Min.z, box.Max.z, _margin, minCell);

            uint leaves = 0, children = 0;
            uint3 boxMin = 0, boxMax = 0;
            for (int k = 0; k < node.ChildCount; k++)
            {
                int child = _nodes.Array[node.FirstChild + k].Binary;
                var inner = _bvh.BoxOf(child);
                children |= 1u << k;
                if (child < 0)
                    leaves |= 1u << k;
                boxMin |= uint3(x.Below(inner.Min.x), y.Below(inner.Min.y), z.Below(inner.Min.z)) << (8 * k);
                boxMax |= uint3(x.Above(inner.Max.x), y.Above(inner.Max.y), z.Above(inner.Max.z)) << (8 * k);
            }
            int row = RecordRows * record;
            _rows[row] = uint4(asuint(x.Origin), asuint(y.Origin), asuint(z.Origin),
                x.Exponent | y.Exponent << 8 | z.Exponent << 16 | leaves << 24 | children << 28);
            _rows[row + 1] = uint4(boxMin, boxMax.x);
            _rows[row + 2] = uint4(boxMax.y, boxMax.z, (uint)node.FirstChild, 0);
        }

        // Planes along one axis: Origin + n cells, n from 0 to 255; a cell is a power of two.
        readonly struct Axis
        {
            public readonly float Origin;
            public readonly uint Exponent;
            readonly double _cellsPerMetre, _margin;

            public Axis(double lower, double upper, double margin, double minCell)
            {
                lower -= margin;
                upper += margin;
                double cell = PowerOfTwoFrom(Math.Max((upper - lower) / LastCell, minCell));
                Origin = FloatUpTo(lower - Margin * cell);
                while ((upper - Origin) / cell + Margin > LastCell)
                {
                    cell *= 2;
                    Origin = FloatUpTo(lower - Margin * cell);
                }
                // The bits of a float: cells are normal numbers.
                Exponent = asuint((float)cell) >> 23;
                _cellsPerMetre = 1 / cell;
                _margin = margin;
            }

            public uint Below(float position) =>
                (uint)Math.Max(0, Math.Floor((position - _margin - Origin) * _cellsPerMetre - Margin));

            public uint Above(float position) =>
                (uint)Math.Min(LastCell, Math.Ceiling((position + _margin - Origin) * _cellsPerMetre + Margin));

            // The smallest power of two that is not below a positive number.
            static double PowerOfTwoFrom(double number)
            {
                const long Fraction = (1L << 52) - 1;
                return BitConverter.Int64BitsToDouble((BitConverter.DoubleToInt64Bits(number) + Fraction) & ~Fraction);
            }

            // The largest float that is not above a number.
            static float FloatUpTo(double number)
            {
                float near = (float)number;
                if (near <= number)
                    return near;
                int bits = BitConverter.SingleToInt32Bits(near);
                return BitConverter.Int32BitsToSingle(
                    bits > 0 ? bits - 1 : bits == 0 ? unchecked((int)0x80000001) : bits + 1);
            }
        }
    }
}
