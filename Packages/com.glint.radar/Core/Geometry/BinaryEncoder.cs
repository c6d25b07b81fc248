using System;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Writes a tree in <see cref="TreeShape.Binary"/>: a row with the centre of all boxes,
    /// nodes of 3 rows from the root on, then leaves of 3.
    /// A node: middle of child a's box from the centre and reference to a, the same of child b,
    /// and the half sizes of both boxes, x, y, z:
    /// the upper halves of floats, a's above b's. A reference is the row of a child; a leaf's has bit 31 set.
    /// </summary>
    sealed class BinaryEncoder
    {
        const int HeadRows = 1;
        const int NodeRows = 3;
        const int LeafRows = 3;
        const uint LeafBit = 0x80000000;

        /// <summary>A leaf and a node: there is one node less than leaves.</summary>
        public const double LeastRowsPerLeaf = LeafRows + NodeRows;

        readonly BoxTree _tree;
        readonly ILeafWriter _writer;
        readonly int _root, _firstLeaf, _leafCount, _nodeCount;
        readonly float3 _centre;
        readonly double _margin;
        readonly uint4[] _rows;

        BinaryEncoder(BoxTree tree, int root, ILeafWriter writer)
        {
            _tree = tree;
            _writer = writer;
            _root = root;
            _firstLeaf = tree.FirstLeaf(root);
            _leafCount = tree.LeafCount(root);
            _nodeCount = Math.Max(1, _leafCount - 1);
            var box = tree.BoxOf(root);
            _centre = (float3)(0.5 * ((double3)box.Low + box.High));
            _margin = tree.Margin;
            _rows = new uint4[LeafRow(_leafCount)];
        }

        /// <summary>Leaves of a tree of at most this many rows.</summary>
        public static int MostLeaves(int rows) => (rows - HeadRows + NodeRows) / (NodeRows + LeafRows);

        /// <summary>The rows of a subtree.</summary>
        public static uint4[] Encode(BoxTree tree, int root, ILeafWriter writer)
        {
            var encoder = new BinaryEncoder(tree, root, writer);
            encoder.Write();
            return encoder._rows;
        }

        void Write()
        {
            _rows[0] = uint4(asuint(_centre), 0);
            if (_leafCount == 1)
                WriteNode(0, _root, _root);
            else
                Blocks.For(_nodeCount, (from, to) =>
                {
                    for (int node = from; node < to; node++)
                        WriteNode(node, _tree.Left(_root + node), _tree.Right(_root + node));
                });
            Blocks.For(_leafCount, (from, to) =>
            {
                for (int leaf = from; leaf < to; leaf++)
                    _writer.Write(_tree.Leaves[_firstLeaf + leaf].Item, _rows, LeafRow(leaf));
            });
        }

        static int NodeRow(int node) => HeadRows + NodeRows * node;

        int LeafRow(int leaf) => NodeRow(_nodeCount) + LeafRows * leaf;

        void WriteNode(int node, int left, int right)
        {
            Measure(_tree.BoxOf(left), out var middleA, out var halfSizeA);
            Measure(_tree.BoxOf(right), out var middleB, out var halfSizeB);
            int row = NodeRow(node);
            _rows[row] = uint4(asuint(middleA), Reference(left));
            _rows[row + 1] = uint4(asuint(middleB), Reference(right));
            _rows[row + 2] = uint4(halfSizeA << 16 | halfSizeB, 0);
        }

        uint Reference(int child) =>
            child < 0 ? LeafBit | (uint)LeafRow(~child - _firstLeaf) : (uint)NodeRow(child - _root);

        void Measure(in Box box, out float3 middle, out uint3 halfSize)
        {
            MeasureAxis(box.Low.x, box.High.x, _centre.x, _margin, out middle.x, out halfSize.x);
            MeasureAxis(box.Low.y, box.High.y, _centre.y, _margin, out middle.y, out halfSize.y);
            MeasureAxis(box.Low.z, box.High.z, _centre.z, _margin, out middle.z, out halfSize.z);
        }

        static void MeasureAxis(double low, double high, double centre, double margin,
            out float middle, out uint halfSize)
        {
            low -= centre;
            high -= centre;
            middle = (float)(0.5 * (low + high));
            halfSize = UpperHalfFrom(Math.Max(high - middle, middle - low) + margin);
        }

        // The upper half of the least float that ends in 16 zero bits and is not below a number from 0 on;
        // of the largest finite one if there is none.
        static uint UpperHalfFrom(double number)
        {
            const uint Largest = 0x7f7f;
            float near = (float)number;
            uint half = asuint(near) >> 16;
            return asfloat(half << 16) >= number ? half : Math.Min(half + 1, Largest);
        }
    }
}
