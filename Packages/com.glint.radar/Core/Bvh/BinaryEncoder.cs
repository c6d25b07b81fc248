using System;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Writes a BVH in <see cref="BvhLayout.Binary"/>: a row with the centre of all boxes,
    /// nodes of 3 rows from the root on, then leaves of 3.
    /// A node: centre of child a's box, relative to the centre of all, and reference to a; the same of child b;
    /// half sizes of both boxes, x, y, z:
    /// the upper halves of floats, a's above b's. A reference is the row of a child; a leaf's has bit 31 set.
    /// </summary>
    sealed class BinaryEncoder
    {
        const int HeadRows = 1;
        const int NodeRows = 3;
        const int LeafRows = 3;
        const uint LeafBit = 0x80000000;

        /// <summary>A leaf and a node: there is one node less than leaves.</summary>
        public const double MinRowsPerLeaf = LeafRows + NodeRows;

        readonly BinaryBvh _bvh;
        readonly ILeafWriter _writer;
        readonly int _root, _firstLeaf, _leafCount, _nodeCount;
        readonly float3 _centre;
        readonly double _margin;
        readonly uint4[] _rows;

        BinaryEncoder(BinaryBvh bvh, int root, ILeafWriter writer)
        {
            _bvh = bvh;
            _writer = writer;
            _root = root;
            _firstLeaf = bvh.FirstLeaf(root);
            _leafCount = bvh.LeafCount(root);
            _nodeCount = Math.Max(1, _leafCount - 1);
            var box = bvh.BoxOf(root);
            _centre = (float3)(0.5 * ((double3)box.Min + box.Max));
            _margin = bvh.Margin;
            _rows = new uint4[FirstIdentityRow + writer.IdentityRows(_leafCount)];
        }

        /// <summary>Leaves of a BVH of at most this many rows, with half an identity row each.</summary>
        public static int MaxLeaves(int rows) => 2 * (rows - HeadRows + NodeRows - 1) / (2 * (NodeRows + LeafRows) + 1);

        int FirstIdentityRow => LeafRow(_leafCount);

        /// <summary>The rows of a subtree.</summary>
        /// <param name="firstLeafRow">Row of the first leaf.</param>
        /// <param name="firstIdentityRow">First of the identity rows, behind the leaves.</param>
        public static uint4[] Encode(BinaryBvh bvh, int root, ILeafWriter writer, out int firstLeafRow,
            out int firstIdentityRow)
        {
            var encoder = new BinaryEncoder(bvh, root, writer);
            encoder.Write();
            (firstLeafRow, firstIdentityRow) = (encoder.LeafRow(0), encoder.FirstIdentityRow);
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
                        WriteNode(node, _bvh.Left(_root + node), _bvh.Right(_root + node));
                });
            Blocks.For(_leafCount, (from, to) =>
            {
                for (int leaf = from; leaf < to; leaf++)
                    _writer.Write(_bvh.Leaves[_firstLeaf + leaf].Item, _rows, LeafRow(leaf), leaf, FirstIdentityRow);
            });
        }

        static int NodeRow(int node) => HeadRows + NodeRows * node;

        int LeafRow(int leaf) => NodeRow(_nodeCount) + LeafRows * leaf;

        void WriteNode(int node, int left, int right)
        {
            int row = NodeRow(node);
            WriteBoxes(_rows, row, _bvh.BoxOf(left), _bvh.BoxOf(right), _centre, _margin);
            (_rows[row].w, _rows[row + 1].w) = (Reference(left), Reference(right));
        }

        /// <summary>
        /// Writes the boxes of moved items into the nodes of a BVH whose leaves hold their items' numbers; the tree stays
        /// as it is. It allocates nothing.
        /// </summary>
        public static void Refit(uint4[] rows, float3[] boxMins, float3[] boxMaxes)
        {
            var all = Box.Empty;
            for (int item = 0; item < boxMins.Length; item++)
                all.Add(new Box(boxMins[item], boxMaxes[item]));
            // A node precedes its children.
            for (int node = Math.Max(1, boxMins.Length - 1) - 1; node >= 0; node--)
            {
                int row = NodeRow(node);
                WriteBoxes(rows, row, BoxOf(rows, rows[row].w, boxMins, boxMaxes),
                    BoxOf(rows, rows[row + 1].w, boxMins, boxMaxes), asfloat(rows[0].xyz), BinaryBvh.MarginOf(all));
            }
        }

        static Box BoxOf(uint4[] rows, uint child, float3[] boxMins, float3[] boxMaxes)
        {
            int row = (int)(child & ~LeafBit);
            if ((child & LeafBit) != 0)
                return new Box(boxMins[rows[row].x], boxMaxes[rows[row].x]);
            float3 centreA = asfloat(rows[row].xyz), centreB = asfloat(rows[row + 1].xyz),
                halfSizeA = asfloat(rows[row + 2].xyz & 0xffff0000), halfSizeB = asfloat(rows[row + 2].xyz << 16),
                centre = asfloat(rows[0].xyz);
            return new Box(centre + min(centreA - halfSizeA, centreB - halfSizeB),
                centre + max(centreA + halfSizeA, centreB + halfSizeB));
        }

        // References to the children stay.
        static void WriteBoxes(uint4[] rows, int row, in Box left, in Box right, float3 centre, double margin)
        {
            Measure(left, centre, margin, out var centreA, out var halfSizeA);
            Measure(right, centre, margin, out var centreB, out var halfSizeB);
            rows[row].xyz = asuint(centreA);
            rows[row + 1].xyz = asuint(centreB);
            rows[row + 2] = uint4(halfSizeA << 16 | halfSizeB, 0);
        }

        uint Reference(int child) =>
            child < 0 ? LeafBit | (uint)LeafRow(~child - _firstLeaf) : (uint)NodeRow(child - _root);

        static void Measure(in Box box, float3 from, double margin, out float3 centre, out uint3 halfSize)
        {
            MeasureAxis(box.Min.x, box.Max.x, from.x, margin, out centre.x, out halfSize.x);
            MeasureAxis(box.Min.y, box.Max.y, from.y, margin, out centre.y, out halfSize.y);
            MeasureAxis(box.Min.z, box.Max.z, from.z, margin, out centre.z, out halfSize.z);
        }

        static void MeasureAxis(double lower, double upper, double centre, double margin,
            out float midpoint, out uint halfSize)
        {
            lower -= centre;
            upper -= centre;
            midpoint = (float)(0.5 * (lower + upper));
            halfSize = UpperHalfFrom(Math.Max(upper - midpoint, midpoint - lower) + margin);
        }

        // The upper half of the smallest float with 16 low zero bits that is not below a number >= 0;
        // of the largest finite float if there is none.
        static uint UpperHalfFrom(double number)
        {
            const uint Largest = 0x7f7f;
            float near = (float)number;
            uint half = asuint(near) >> 16;
            return asfloat(half << 16) >= number ? half : Math.Min(half + 1, Largest);
        }
    }
}
