using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Writes the leaves of a BVH as the kernel reads them.</summary>
    interface ILeafWriter
    {
        /// <summary>Rows behind the BVH that name what is in its leaves.</summary>
        /// <param name="records">Records that leaves are numbered among.</param>
        int IdentityRows(int records);

        /// <summary>
        /// Writes item <paramref name="item"/> into three rows from <paramref name="row"/> on; they are 0 before.
        /// </summary>
        /// <param name="record">The leaf's number.</param>
        /// <param name="firstIdentityRow">First of the identity rows.</param>
        void Write(int item, uint4[] rows, int row, int record, int firstIdentityRow);
    }
}
