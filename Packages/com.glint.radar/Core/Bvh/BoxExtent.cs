using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The box around some boxes, and the box around their centres.</summary>
    struct BoxExtent
    {
        public Box Box;

        /// <summary>In coordinates twice as large: a centre is the sum of a box's corners.</summary>
        public Box Centres;

        public static BoxExtent Empty => new BoxExtent { Box = Box.Empty, Centres = Box.Empty };

        public readonly int LongestAxis
        {
            get
            {
                var size = Centres.Max - Centres.Min;
                return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            }
        }

        public void Add(in Box box)
        {
            Box.Add(box);
            Centres.Add(new float3(box.Min.x + box.Max.x, box.Min.y + box.Max.y, box.Min.z + box.Max.z));
        }
    }
}
