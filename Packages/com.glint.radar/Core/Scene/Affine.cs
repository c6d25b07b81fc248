using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// An affine transform in double precision: rotation, scale (also mirrored or uneven), translation.
    /// </summary>
    public struct Affine : IEquatable<Affine>
    {
        /// <summary>Images of the unit vectors: the columns.</summary>
        public double3 X, Y, Z;

        /// <summary>Image of the origin, metres.</summary>
        public double3 Origin;

        /// <summary>The identity.</summary>
        public static Affine Identity =>
            new Affine { X = new double3(1, 0, 0), Y = new double3(0, 1, 0), Z = new double3(0, 0, 1) };

        /// <summary>
        /// Scale, then rotation, then translation, as a Transform relative to its parent. The rotation need not be
        /// normalised; a zero rotation is the identity, and one that is not finite gives a transform that is not
        /// finite.
        /// </summary>
        public static Affine FromTransform(double3 position, double4 rotation, double3 scale)
        {
            double square = math.dot(rotation, rotation);
            double4 q = square == 0 ? new double4(0, 0, 0, 1) : rotation / math.sqrt(square);
            return new Affine
            {
                X = scale.x * new double3(1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z),
                    2 * (q.x * q.z - q.w * q.y)),
                Y = scale.y * new double3(2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z),
                    2 * (q.y * q.z + q.w * q.x)),
                Z = scale.z * new double3(2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x),
                    1 - 2 * (q.x * q.x + q.y * q.y)),
                Origin = position,
            };
        }

        /// <summary>Scale of volumes; negative for a mirroring transform, 0 for a singular one.</summary>
        public double Determinant => math.dot(X, math.cross(Y, Z));

        /// <summary>Whether all components are equal.</summary>
        public bool Equals(Affine other) =>
            X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z) && Origin.Equals(other.Origin);

        /// <summary>Transforms a point, metres.</summary>
        public double3 Point(double3 p) => Vector(p) + Origin;

        /// <summary>Transforms a direction or difference of points, without translation.</summary>
        public double3 Vector(double3 v) => v.x * X + v.y * Y + v.z * Z;

        /// <summary>
        /// The product of the matrices: applies <paramref name="second"/>, then <paramref name="first"/>.
        /// </summary>
        public static Affine operator *(in Affine first, in Affine second) => new Affine
        {
            X = first.Vector(second.X), Y = first.Vector(second.Y),
            Z = first.Vector(second.Z), Origin = first.Point(second.Origin),
        };

        /// <summary>The inverse; not finite for a singular transform.</summary>
        public Affine Inverse()
        {
            double d = Determinant;
            double3 a = math.cross(Y, Z) / d, b = math.cross(Z, X) / d, c = math.cross(X, Y) / d; // rows of the inverse
            return new Affine
            {
                X = new double3(a.x, b.x, c.x), Y = new double3(a.y, b.y, c.y), Z = new double3(a.z, b.z, c.z),
                Origin = -new double3(math.dot(a, Origin), math.dot(b, Origin), math.dot(c, Origin)),
            };
        }
    }
}
