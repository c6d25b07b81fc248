using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>One of the device's buffers for trees, in rows of 16 bytes, and which of its rows are taken.</summary>
    sealed class TreeBank : IDisposable
    {
        readonly DeviceBuffer<uint4> _rows = new DeviceBuffer<uint4>("rows of trees");
        readonly SortedList<int, int> _taken = new SortedList<int, int>(); // first row -> rows

        public TreeBank(int capacity) => _rows.Reserve(capacity);

        public DeviceBuffer<uint4> Rows => _rows;

        /// <summary>Writes a tree into the first gap that it fits; -1 if there is none.</summary>
        public int Place(uint4[] words)
        {
            int first = 0, at = 0;
            while (at < _taken.Count && _taken.Keys[at] - first < words.Length)
            {
                first = _taken.Keys[at] + _taken.Values[at];
                at++;
            }
            if (_rows.Capacity - first < words.Length)
                return -1;
            _taken.Add(first, words.Length);
            _rows.Buffer.SetData(words, 0, first, words.Length);
            return first;
        }

        public void Free(int first) => _taken.Remove(first);

        public void Dispose() => _rows.Dispose();
    }
}
