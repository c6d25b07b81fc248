using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Leaves of a BVH over instances: their numbers.</summary>
    sealed class NumberWriter : ILeafWriter
    {
        public int IdentityRows(int records) => 0;

        public void Write(int item, uint4[] rows, int row, int record, int firstIdentityRow) =>
            rows[row].x = (uint)item;
    }
}
