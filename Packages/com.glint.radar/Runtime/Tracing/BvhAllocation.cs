using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>A mesh's BVHs and their positions on the device.</summary>
    sealed class BvhAllocation
    {
        readonly int[] _pages, _firstRows;

        public BvhAllocation(MeshBvh bvh)
        {
            Bvh = bvh;
            _pages = new int[bvh.Parts.Length];
            _firstRows = new int[bvh.Parts.Length];
        }

        public MeshBvh Bvh { get; }

        public long Rows
        {
            get
            {
                long rows = 0;
                foreach (var part in Bvh.Parts)
                    rows += part.Rows.Length;
                return rows;
            }
        }

        public int PageOf(int part) => _pages[part];

        public int FirstRowOf(int part) => _firstRows[part];

        /// <summary>
        /// Writes all parts into pages with room; false, and writes none, if there is not enough room.
        /// </summary>
        public bool Allocate(IReadOnlyList<BvhPage> pages)
        {
            for (int part = 0; part < Bvh.Parts.Length; part++)
                if (!Allocate(pages, part))
                {
                    Free(pages, part);
                    return false;
                }
            return true;
        }

        public void Free(IReadOnlyList<BvhPage> pages) => Free(pages, Bvh.Parts.Length);

        bool Allocate(IReadOnlyList<BvhPage> pages, int part)
        {
            for (int page = 0; page < pages.Count; page++)
            {
                int first = pages[page].Allocate(Bvh.Parts[part].Rows);
                if (first < 0)
                    continue;
                _pages[part] = page;
                _firstRows[part] = first;
                return true;
            }
            return false;
        }

        void Free(IReadOnlyList<BvhPage> pages, int parts)
        {
            for (int part = 0; part < parts; part++)
                pages[_pages[part]].Free(_firstRows[part]);
        }
    }

    /// <summary>A device buffer for BVHs, in rows of 16 bytes, and its allocated rows.</summary>
    sealed class BvhPage : IDisposable
    {
        readonly DeviceBuffer<uint4> _rows = new DeviceBuffer<uint4>("rows of BVHs");
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
