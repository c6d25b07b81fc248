using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A reflection of a ray.</summary>
    public struct PathHit
    {
        /// <summary>Number of what a ray meets when nobody knows it.</summary>
        public const int NoObject = -1;

        /// <summary>Where, metres, from the scene's origin.</summary>
        public double3 Position;

        /// <summary>Unit direction after the reflection.</summary>
        public double3 Direction;

        /// <summary>
        /// Number of the object that reflects, as <see cref="IHitObjects"/> has it;
        /// <see cref="NoObject"/> if nobody knows.
        /// </summary>
        public int Object;
    }
}
