using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A reflection of a ray.</summary>
    public struct PathHit
    {
        /// <summary>Point of reflection, metres, from the scene's origin.</summary>
        public double3 Position;

        /// <summary>Unit direction after the reflection.</summary>
        public double3 Direction;

        /// <summary>Place of the instance in <see cref="RadarScene.Instances"/>.</summary>
        public int Instance;

        /// <summary>Number of the triangle in the instance's mesh.</summary>
        public int Triangle;

        /// <summary>Number of the object that reflects; <see cref="MeshRange.NoObject"/> if it is not known.</summary>
        public int Object;

        /// <summary>Place of the surface that reflects in <see cref="RadarScene.Surfaces"/>.</summary>
        public int Surface;
    }
}
