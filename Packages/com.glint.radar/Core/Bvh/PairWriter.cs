using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// Leaves of a mesh's BVH: the corners of a pair of triangles, x, y, z of four in turn.
    /// Their identity rows hold the numbers of both triangles in the mesh, two leaves a row.
    /// </summary>
    sealed class PairWriter : ILeafWriter
    {
        readonly float3[] _vertices;
        readonly TrianglePair[] _pairs;

        public PairWriter(float3[] vertices, TrianglePair[] pairs)
        {
            _vertices = vertices;
            _pairs = pairs;
        }

        public int IdentityRows(int records) => (records + 1) / 2;

        public void Write(int item, uint4[] rows, int row, int record, int firstIdentityRow)
        {
            var pair = _pairs[item].Corners;
            float3 a = _vertices[pair.x], b = _vertices[pair.y], c = _vertices[pair.z], d = _vertices[pair.w];
            rows[row] = uint4(asuint(a.x), asuint(a.y), asuint(a.z), asuint(b.x));
            rows[row + 1] = uint4(asuint(b.y), asuint(b.z), asuint(c.x), asuint(c.y));
            rows[row + 2] = uint4(asuint(c.z), asuint(d.x), asuint(d.y), asuint(d.z));

            // Leaves are written by several threads: each writes its own half of a row.
            ref var identity = ref rows[firstIdentityRow + record / 2];
            if (record % 2 == 0)
                (identity.x, identity.y) = ((uint)_pairs[item].First, (uint)_pairs[item].Second);
            else
                (identity.z, identity.w) = ((uint)_pairs[item].First, (uint)_pairs[item].Second);
        }
    }
}
