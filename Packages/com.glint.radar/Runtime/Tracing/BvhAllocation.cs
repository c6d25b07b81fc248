using System.Collections.Generic;
using Glint.Core;

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
}
