using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>An axis-aligned box.</summary>
    public struct Box
    {
        /// <summary>Lowest coordinates, metres.</summary>
        public float3 Min;

        /// <summary>Highest coordinates, metres.</summary>
        public float3 Max;

        /// <summary>A box by its lowest and highest coordinates.</summary>
        public Box(float3 boxMin, float3 boxMax)
        {
            Min = boxMin;
            Max = boxMax;
        }

        /// <summary>The empty box.</summary>
        public static Box Empty => new Box(float.PositiveInfinity, float.NegativeInfinity);

        /// <summary>A corner, 0 to 7: bits 1, 2 and 4 select the upper x, y and z.</summary>
        public readonly double3 Corner(int number) => CornerOf(Min, Max, number);

        /// <summary>A corner of a box in double precision.</summary>
        /// <inheritdoc cref="Corner"/>
        public static double3 CornerOf(double3 boxMin, double3 boxMax, int number) =>
            new double3((number & 1) != 0 ? boxMax.x : boxMin.x, (number & 2) != 0 ? boxMax.y : boxMin.y,
                (number & 4) != 0 ? boxMax.z : boxMin.z);

        /// <summary>
        /// Half of the surface area, which is proportional to the probability that a ray hits the box.
        /// </summary>
        public readonly float HalfArea
        {
            get
            {
                float x = Max.x - Min.x, y = Max.y - Min.y, z = Max.z - Min.z;
                return x * y + y * z + z * x;
            }
        }

        /// <summary>Grows to hold another box.</summary>
        // Comparisons, because boxes seldom grow: a predicted branch costs less than a minimum and a store.
        public void Add(in Box other)
        {
            if (other.Min.x < Min.x) Min.x = other.Min.x;
            if (other.Min.y < Min.y) Min.y = other.Min.y;
            if (other.Min.z < Min.z) Min.z = other.Min.z;
            if (other.Max.x > Max.x) Max.x = other.Max.x;
            if (other.Max.y > Max.y) Max.y = other.Max.y;
            if (other.Max.z > Max.z) Max.z = other.Max.z;
        }

        /// <summary>Grows to hold a point.</summary>
        public void Add(float3 point)
        {
            if (point.x < Min.x) Min.x = point.x;
            if (point.y < Min.y) Min.y = point.y;
            if (point.z < Min.z) Min.z = point.z;
            if (point.x > Max.x) Max.x = point.x;
            if (point.y > Max.y) Max.y = point.y;
            if (point.z > Max.z) Max.z = point.z;
        }
    }
}
