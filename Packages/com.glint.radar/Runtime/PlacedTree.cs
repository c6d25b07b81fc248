using System.Collections.Generic;
using Glint.Core;

namespace Glint
{
    /// <summary>A mesh's trees and where they stand on the device.</summary>
    sealed class PlacedTree
    {
        readonly int[] _banks, _firstRows;

        public PlacedTree(MeshTree tree)
        {
            Tree = tree;
            _banks = new int[tree.Parts.Length];
            _firstRows = new int[tree.Parts.Length];
        }

        public MeshTree Tree { get; }

        public long Rows
        {
            get
            {
                long rows = 0;
                foreach (var part in Tree.Parts)
                    rows += part.Words.Length;
                return rows;
            }
        }

        public int BankOf(int part) => _banks[part];

        public int FirstRowOf(int part) => _firstRows[part];

        /// <summary>Writes every part where there is room; false, and none written, if there is not enough.</summary>
        public bool Place(IReadOnlyList<TreeBank> banks)
        {
            for (int part = 0; part < Tree.Parts.Length; part++)
                if (!Place(banks, part))
                {
                    Free(banks, part);
                    return false;
                }
            return true;
        }

        public void Free(IReadOnlyList<TreeBank> banks) => Free(banks, Tree.Parts.Length);

        bool Place(IReadOnlyList<TreeBank> banks, int part)
        {
            for (int bank = 0; bank < banks.Count; bank++)
            {
                int first = banks[bank].Place(Tree.Parts[part].Words);
                if (first < 0)
                    continue;
                _banks[part] = bank;
                _firstRows[part] = first;
                return true;
            }
            return false;
        }

        void Free(IReadOnlyList<TreeBank> banks, int parts)
        {
            for (int part = 0; part < parts; part++)
                banks[_banks[part]].Free(_firstRows[part]);
        }
    }
}
