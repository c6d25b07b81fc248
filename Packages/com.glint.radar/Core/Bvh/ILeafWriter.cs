using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Writes the leaves of a BVH as the kernel reads them.</summary>
    interface ILeafWriter
    {
        /// <summary>
        /// Writes item <paramref name="item"/> into three rows from <paramref name="row"/> on; they are 0 before.
        /// </summary>
        void Write(int item, uint4[] rows, int row);
    }
}
