using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>Leaves of a mesh's BVH: the corners of a pair of triangles, x, y, z of four in turn.</summary>
    sealed class PairWriter : ILeafWriter
    {
        readonly float3[] _vertices;
        readonly int4[] _pairs;

        public PairWriter(float3[] vertices, int4[] pairs)
        {
            _vertices = vertices;
            _pairs = pairs;
        }

        public void Write(int item, uint4[] rows, int row)
        {
            var pair = _pairs[item];
            float3 a = _vertices[pair.x], b = _vertices[pair.y], c = _vertices[pair.z], d = _vertices[pair.w];
            rows[row] = uint4(asuint(a.x), asuint(a.y), asuint(a.z), asuint(b.x));
            rows[row + 1] = uint4(asuint(b.y), asuint(b.z), asuint(c.x), asuint(c.y));
            rows[row + 2] = uint4(asuint(c.z), asuint(d.x), asuint(d.y), asuint(d.z));
        }
    }
}
