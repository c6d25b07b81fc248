using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Knows the objects that the triangles of a scene belong to.</summary>
    public interface IHitObjects
    {
        /// <summary>Number of the object of a triangle.</summary>
        /// <param name="instance">Place in <see cref="RadarScene.Instances"/>.</param>
        /// <param name="a">Corner of the triangle, as the instance's mesh has it.</param>
        /// <param name="b">Corner.</param>
        /// <param name="c">Corner.</param>
        int ObjectOf(int instance, float3 a, float3 b, float3 c);
    }
}
