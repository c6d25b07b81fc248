using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The motion of a rigid body at one moment; by default none.</summary>
    public struct RigidMotion : IEquatable<RigidMotion>
    {
        /// <summary>Velocity of the pivot, metres a second.</summary>
        public double3 Velocity;

        /// <summary>
        /// Angular velocity, radians a second, about the axis of the vector: about +Y it turns +Z towards +X, as
        /// rotations do in Unity.
        /// </summary>
        public double3 AngularVelocity;

        /// <summary>A point of the body's frame, metres.</summary>
        public double3 Pivot;

        /// <summary>Whether nothing moves.</summary>
        public bool IsNone => math.all(Velocity == 0) && math.all(AngularVelocity == 0);

        /// <summary>Velocity of the body's material at a point, metres a second.</summary>
        public double3 VelocityAt(double3 point) => Velocity + math.cross(AngularVelocity, point - Pivot);

        /// <summary>Velocity, and angular velocity about the pivot, if there is one.</summary>
        public override string ToString()
        {
            string Text(double3 v) => $"({Numbers.Format(v.x)}, {Numbers.Format(v.y)}, {Numbers.Format(v.z)})";
            return IsNone ? "none" : $"{Text(Velocity)} m/s" + (math.all(AngularVelocity == 0)
                ? ""
                : $", {Text(AngularVelocity)} rad/s about {Text(Pivot)} m");
        }

        /// <summary>Whether both are equal.</summary>
        public bool Equals(RigidMotion other) => Velocity.Equals(other.Velocity)
            && AngularVelocity.Equals(other.AngularVelocity) && Pivot.Equals(other.Pivot);

        /// <inheritdoc/>
        public override bool Equals(object other) => other is RigidMotion motion && Equals(motion);

        /// <inheritdoc/>
        public override int GetHashCode() => Velocity.GetHashCode() ^ AngularVelocity.GetHashCode();
    }
}
