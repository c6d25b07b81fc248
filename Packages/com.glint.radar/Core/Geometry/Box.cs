using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A box along the axes.</summary>
    struct Box
    {
        public float3 Low, High;

        public Box(float3 low, float3 high)
        {
            Low = low;
            High = high;
        }

        /// <summary>Holds nothing.</summary>
        public static Box Empty => new Box(float.PositiveInfinity, float.NegativeInfinity);

        /// <summary>A corner, 0 to 7: bits 1, 2 and 4 stand for the upper x, y and z.</summary>
        public readonly double3 Corner(int number) =>
            new double3((number & 1) != 0 ? High.x : Low.x, (number & 2) != 0 ? High.y : Low.y,
                (number & 4) != 0 ? High.z : Low.z);

        /// <summary>Half of the surface, which is in proportion to the rays that meet it.</summary>
        public readonly float HalfArea
        {
            get
            {
                float x = High.x - Low.x, y = High.y - Low.y, z = High.z - Low.z;
                return x * y + y * z + z * x;
            }
        }

        // Comparisons, because boxes seldom grow: a branch foretold costs less than a minimum and a store.
        public void Add(in Box other)
        {
            if (other.Low.x < Low.x) Low.x = other.Low.x;
            if (other.Low.y < Low.y) Low.y = other.Low.y;
            if (other.Low.z < Low.z) Low.z = other.Low.z;
            if (other.High.x > High.x) High.x = other.High.x;
            if (other.High.y > High.y) High.y = other.High.y;
            if (other.High.z > High.z) High.z = other.High.z;
        }

        public void Add(float3 point)
        {
            if (point.x < Low.x) Low.x = point.x;
            if (point.y < Low.y) Low.y = point.y;
            if (point.z < Low.z) Low.z = point.z;
            if (point.x > High.x) High.x = point.x;
            if (point.y > High.y) High.y = point.y;
            if (point.z > High.z) High.z = point.z;
        }
    }
}
