using System;

namespace Glint.Core
{
    /// <summary>A mesh at its place in the scene, and whose its triangles are.</summary>
    public struct MeshInstance : IEquatable<MeshInstance>
    {
        static readonly MeshRange[] s_unknown = { new MeshRange(0, MeshRange.NoObject, 0) };

        MeshRange[] _ranges;

        /// <summary>The triangles, in a frame of their own. Several instances may share a mesh.</summary>
        public TriangleMesh Mesh;

        /// <summary>Transform from the mesh's frame to the scene's, metres.</summary>
        public Affine ToWorld;

        /// <summary>How it moves, in the scene's frame.</summary>
        public RigidMotion Motion;

        /// <summary>
        /// Objects and surfaces of the triangles, in the order of <see cref="MeshRange.FirstTriangle"/>, from 0.
        /// Null, or not set: one range of no known object, a perfect conductor.
        /// </summary>
        public MeshRange[] Ranges
        {
            get => _ranges ?? s_unknown;
            set
            {
                if (value != null && (value.Length == 0 || value[0].FirstTriangle != 0))
                    throw new ArgumentException("the first range of a mesh begins at triangle 0");
                _ranges = value;
            }
        }

        /// <summary>Whether both are the same mesh at the same place, with equal motions and ranges.</summary>
        public bool Equals(MeshInstance other) => Mesh == other.Mesh && ToWorld.Equals(other.ToWorld)
            && Motion.Equals(other.Motion) && Ranges.AsSpan().SequenceEqual(other.Ranges);

        /// <inheritdoc/>
        public override bool Equals(object other) => other is MeshInstance instance && Equals(instance);

        /// <inheritdoc/>
        public override int GetHashCode() => Mesh == null ? 0 : Mesh.GetHashCode();
    }

    /// <summary>Triangles of a mesh, in a row, that belong to one object and have one surface.</summary>
    public readonly struct MeshRange : IEquatable<MeshRange>
    {
        /// <summary>Number of what a triangle belongs to when that is not known.</summary>
        public const int NoObject = -1;

        /// <summary>A range.</summary>
        public MeshRange(int firstTriangle, int objectNumber, int surface) =>
            (FirstTriangle, Object, Surface) = (firstTriangle, objectNumber, surface);

        /// <summary>Number of the first triangle in the mesh; the range ends where the next one begins.</summary>
        public int FirstTriangle { get; }

        /// <summary>Number of the object; <see cref="NoObject"/> if it is not known.</summary>
        public int Object { get; }

        /// <summary>Place in <see cref="RadarScene.Surfaces"/>.</summary>
        public int Surface { get; }

        /// <inheritdoc/>
        public bool Equals(MeshRange other) =>
            FirstTriangle == other.FirstTriangle && Object == other.Object && Surface == other.Surface;

        /// <inheritdoc/>
        public override bool Equals(object other) => other is MeshRange range && Equals(range);

        /// <inheritdoc/>
        public override int GetHashCode() => FirstTriangle ^ Object << 12 ^ Surface << 24;
    }
}
