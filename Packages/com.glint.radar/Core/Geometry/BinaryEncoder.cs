using System;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Writes a tree in <see cref="TreeShape.Binary"/>: nodes of 4 rows (x and y of child a's box, the same of child b, z of both, references to both), then leaves of 3.
    /// A reference is the row of a child; a leaf's has bit 31 set. Nodes stand together so that each is 64 bytes at a multiple of 64.
    /// </summary>
    sealed class BinaryEncoder
    {
        const int NodeRows = 4;
        const int LeafRows = 3;
        const uint LeafBit = 0x80000000;

        /// <summary>A leaf and a node: there is one node less than leaves.</summary>
        public const double LeastRowsPerLeaf = LeafRows + NodeRows;

        readonly BoxTree _tree;
        readonly ILeafWriter _writer;
        readonly int _root, _firstLeaf, _leafCount, _nodeCount;
        readonly uint4[] _rows;

        BinaryEncoder(BoxTree tree, int root, ILeafWriter writer)
        {
            _tree = tree;
            _writer = writer;
            _root = root;
            _firstLeaf = tree.FirstLeaf(root);
            _leafCount = tree.LeafCount(root);
            _nodeCount = Math.Max(1, _leafCount - 1);
            _rows = new uint4[Rows(_leafCount)];
        }

        /// <summary>Leaves of a tree of at most this many rows.</summary>
        public static int MostLeaves(int rows) => (rows + NodeRows) / (NodeRows + LeafRows);

        /// <summary>The rows of a subtree.</summary>
        public static uint4[] Encode(BoxTree tree, int root, ILeafWriter writer)
        {
            var encoder = new BinaryEncoder(tree, root, writer);
            encoder.Write();
            return encoder._rows;
        }

        static int Rows(int leaves) => NodeRows * Math.Max(1, leaves - 1) + LeafRows * leaves;

        void Write()
        {
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

        int LeafRow(int leaf) => NodeRows * _nodeCount + LeafRows * leaf;

        void WriteNode(int node, int left, int right)
        {
            Box a = _tree.BoxOf(left), b = _tree.BoxOf(right);
            int row = NodeRows * node;
            _rows[row] = asuint(float4(a.Low.x, a.High.x, a.Low.y, a.High.y));
            _rows[row + 1] = asuint(float4(b.Low.x, b.High.x, b.Low.y, b.High.y));
            _rows[row + 2] = asuint(float4(a.Low.z, a.High.z, b.Low.z, b.High.z));
            _rows[row + 3] = uint4(Reference(left), Reference(right), 0, 0);
        }

        uint Reference(int child) => child < 0 ? LeafBit | (uint)LeafRow(~child - _firstLeaf) : (uint)(NodeRows * (child - _root));
    }
}
