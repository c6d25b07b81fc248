using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Leaves of a BVH over instances: their numbers.</summary>
    sealed class NumberWriter : ILeafWriter
    {
        public void Write(int item, uint4[] rows, int row) => rows[row].x = (uint)item;
    }
}
