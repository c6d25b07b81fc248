using System;

namespace Glint.Core
{
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
