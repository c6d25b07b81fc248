using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Turns a file's coordinates into Unity's axes and metres.</summary>
    sealed class MeshFilePlacement
    {
        readonly double _meters;
        readonly UpAxis _up;

        public MeshFilePlacement(LengthUnit unit, UpAxis up)
        {
            _meters = unit.Meters;
            _up = up;
            Unit = unit;
        }

        public LengthUnit Unit { get; }

        /// <summary>One coordinate in metres; infinite if it exceeds the range of float.</summary>
        public float Scale(double coordinate) => (float)(coordinate * _meters);

        public float3 Turn(float x, float y, float z) => _up == UpAxis.Z ? new float3(x, z, y) : new float3(x, y, z);

        /// <summary>
        /// Reorders the corners so that each face keeps its outer side: swapping two axes mirrors.
        /// </summary>
        public int[] Turn(int[] indices)
        {
            if (_up == UpAxis.Z)
                for (int i = 0; i < indices.Length; i += 3)
                    (indices[i + 1], indices[i + 2]) = (indices[i + 2], indices[i + 1]);
            return indices;
        }
    }

    /// <summary>The axis of a mesh file that points up.</summary>
    public enum UpAxis
    {
        /// <summary>As in Unity: x right, y up, z forward.</summary>
        Y,

        /// <summary>(x, y, z) of the file is (x, z, y) of Unity.</summary>
        Z
    }
}
