using System;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Writes a tree in <see cref="TreeShape.Wide"/>, in records of 3 rows that number from 0, the root.
    /// A node's 12 words: origin x, y, z; exponents of the cell's sides and masks;
    /// lower planes of the children's boxes in cells from the origin, x, y, z with a byte for each child; upper planes;
    /// record of the first child; 0.
    /// </summary>
    sealed class WideEncoder
    {
        const int RecordRows = 3;

        /// <summary>
        /// A leaf's record and a third of a node's: a node's children are three records more than it.
        /// </summary>
        public const double LeastRowsPerLeaf = RecordRows * (1 + 1 / (WideCollapse.MostChildren - 1.0)) * (1 - 1e-6);

        const int LastCell = 255;

        // In cells: beside the tree's margin each plane lies outwards by this at least;
        // the kernels count on half of it.
        const double Margin = 1.0 / 32;

        // The cell's side is at least this fraction of the largest coordinate,
        // so that float32 places are finer than cells.
        const double LeastCell = 1.0 / (1 << 21);
        const double LeastNormal = 1.17549435e-38;

        readonly BoxTree _tree;
        readonly ArraySegment<WideNode> _nodes;
        readonly ILeafWriter _writer;
        readonly double _margin;
        readonly uint4[] _rows;

        WideEncoder(BoxTree tree, ArraySegment<WideNode> nodes, ILeafWriter writer)
        {
            _tree = tree;
            _nodes = nodes;
            _writer = writer;
            _margin = tree.Margin;
            _rows = new uint4[RecordRows * nodes.Count];
        }

        /// <summary>Leaves of a tree of at most this many records, however few children its nodes have.</summary>
        public static int MostLeaves(int records) => records / 2;

        /// <summary>The rows of a subtree.</summary>
        public static uint4[] Encode(BoxTree tree, int root, ILeafWriter writer)
        {
            var encoder = new WideEncoder(tree, WideCollapse.Collapse(tree, root), writer);
            Blocks.For(encoder._nodes.Count, (from, to) =>
            {
                for (int record = from; record < to; record++)
                    encoder.WriteRecord(record);
            });
            return encoder._rows;
        }

        void WriteRecord(int record)
        {
            var node = _nodes.Array[record];
            if (node.ChildCount == 0)
                _writer.Write(_tree.Leaves[~node.Binary].Item, _rows, RecordRows * record);
            else
                WriteNode(record, node);
        }

        void WriteNode(int record, in WideNode node)
        {
            var box = _tree.BoxOf(node.Binary);
            double largest = cmax(max(abs((double3)box.Low), abs((double3)box.High)));
            double least = Math.Max(LeastCell * largest, LeastNormal);
            Axis x = new Axis(box.Low.x, box.High.x, _margin, least), y =
                new Axis(box.Low.y, box.High.y, _margin, least), z = new Axis(box.Low.z, box.High.z, _margin, least);

            uint leaves = 0, children = 0;
            uint3 low = 0, high = 0;
            for (int k = 0; k < node.ChildCount; k++)
            {
                int child = _nodes.Array[node.FirstChild + k].Binary;
                var inner = _tree.BoxOf(child);
                children |= 1u << k;
                if (child < 0)
                    leaves |= 1u << k;
                low |= uint3(x.Below(inner.Low.x), y.Below(inner.Low.y), z.Below(inner.Low.z)) << (8 * k);
                high |= uint3(x.Above(inner.High.x), y.Above(inner.High.y), z.Above(inner.High.z)) << (8 * k);
            }
            int row = RecordRows * record;
            _rows[row] = uint4(asuint(x.Origin), asuint(y.Origin), asuint(z.Origin),
                x.Exponent | y.Exponent << 8 | z.Exponent << 16 | leaves << 24 | children << 28);
            _rows[row + 1] = uint4(low, high.x);
            _rows[row + 2] = uint4(high.y, high.z, (uint)node.FirstChild, 0);
        }

        // Planes along one axis: Origin + n cells, n from 0 to 255; a cell is a power of two.
        readonly struct Axis
        {
            public readonly float Origin;
            public readonly uint Exponent;
            readonly double _cellsPerMetre, _margin;

            public Axis(double low, double high, double margin, double leastCell)
            {
                low -= margin;
                high += margin;
                double cell = PowerOfTwoFrom(Math.Max((high - low) / LastCell, leastCell));
                Origin = FloatUpTo(low - Margin * cell);
                while ((high - Origin) / cell + Margin > LastCell)
                {
                    cell *= 2;
                    Origin = FloatUpTo(low - Margin * cell);
                }
                // The bits of a float: cells are normal numbers.
                Exponent = asuint((float)cell) >> 23;
                _cellsPerMetre = 1 / cell;
                _margin = margin;
            }

            public uint Below(float place) =>
                (uint)Math.Max(0, Math.Floor((place - _margin - Origin) * _cellsPerMetre - Margin));

            public uint Above(float place) =>
                (uint)Math.Min(LastCell, Math.Ceiling((place + _margin - Origin) * _cellsPerMetre + Margin));

            // The least power of two that is not below a positive number.
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
