using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>A device buffer for BVHs, in rows of 16 bytes, and its allocated rows.</summary>
    sealed class BvhPage : IDisposable
    {
        readonly DeviceBuffer<uint4> _rows = new DeviceBuffer<uint4>("rows of trees");
        readonly SortedList<int, int> _taken = new SortedList<int, int>(); // first row -> rows

        public BvhPage(int capacity) => _rows.Reserve(capacity);

        public DeviceBuffer<uint4> Rows => _rows;

        /// <summary>Writes a BVH into the first gap that fits; -1 if there is none.</summary>
        public int Allocate(uint4[] rows)
        {
            int first = 0, at = 0;
            while (at < _taken.Count && _taken.Keys[at] - first < rows.Length)
            {
                first = _taken.Keys[at] + _taken.Values[at];
                at++;
            }
            if (_rows.Capacity - first < rows.Length)
                return -1;
            _taken.Add(first, rows.Length);
            _rows.Buffer.SetData(rows, 0, first, rows.Length);
            return first;
        }

        public void Free(int first) => _taken.Remove(first);

        public void Dispose() => _rows.Dispose();
    }
}
