using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A face of a wedge, at its edge.</summary>
    public readonly struct WedgeFace
    {
        /// <summary>A face.</summary>
        public WedgeFace(double3 into, double3 normal, int instance, int triangle) =>
            (Into, Normal, Instance, Triangle) = (into, normal, instance, triangle);

        /// <summary>Unit vector in the face, across the edge and away from it.</summary>
        public double3 Into { get; }

        /// <summary>Unit normal of the face, across the edge, towards the air of the outer angle.</summary>
        public double3 Normal { get; }

        /// <summary>The instance of a triangle of the face.</summary>
        public int Instance { get; }

        /// <summary>That triangle, in its mesh.</summary>
        public int Triangle { get; }
    }

    /// <summary>
    /// A straight edge of a conducting body, with the air on one side of it. Directions around it are angles phi from
    /// <see cref="First"/>: cos(phi) First.Into + sin(phi) First.Normal, from 0 to the outer angle, where the second
    /// face is. First.Normal is cross(Direction, First.Into). A thin plate that ends is one wedge whose two faces are
    /// the two sides of the plate, with outer angle 2 pi.
    /// </summary>
    public sealed class Wedge
    {
        /// <summary>A wedge.</summary>
        public Wedge(double3 a, double3 b, WedgeFace first, WedgeFace second, double outerAngle) =>
            (A, B, First, Second, OuterAngle) = (a, b, first, second, outerAngle);

        /// <summary>An end, metres, in the scene's frame.</summary>
        public double3 A { get; }

        /// <summary>The other end.</summary>
        public double3 B { get; }

        /// <summary>Unit vector from <see cref="A"/> to <see cref="B"/>.</summary>
        public double3 Direction => math.normalize(B - A);

        /// <summary>Metres.</summary>
        public double Length => math.distance(A, B);

        /// <summary>The face at angle 0.</summary>
        public WedgeFace First { get; }

        /// <summary>The face at the outer angle.</summary>
        public WedgeFace Second { get; }

        /// <summary>Angle through the air from one face to the other, radians, above 0 and up to 2 pi.</summary>
        public double OuterAngle { get; }

        /// <summary>The outer angle in half turns: 2 for the end of a thin plate, 1.5 for the edge of a box.</summary>
        public double N => OuterAngle / math.PI_DBL;

        /// <summary>
        /// Whether this is the inside of a corner, with an outer angle below pi: rays bounce there, and the edge adds
        /// nothing of its own.
        /// </summary>
        public bool IsConcave => OuterAngle < math.PI_DBL;
    }
}
