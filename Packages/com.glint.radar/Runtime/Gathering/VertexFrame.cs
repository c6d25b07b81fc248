using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Where float32 vertices keep the most digits: in metres, about, and with the origin among them.
    /// To go there and back rounds no double.
    /// </summary>
    struct VertexFrame
    {
        /// <summary>In the coordinates outside.</summary>
        public double3 Origin;

        /// <summary>Metres, about, of a length of 1 outside; a power of two.</summary>
        public double Unit;

        /// <param name="centre">Middle of the vertices' box.</param>
        /// <param name="half">Half the sides of the box.</param>
        public VertexFrame(double3 centre, double3 half, double unit)
        {
            Unit = unit;
            // On a grid as coarse as the box: coordinates on a grid of a power of two, 1/16 m say, stay on it.
            double step = TransformMath.PowerOfTwoBelow(math.cmax(half));
            Origin = step > 0 ? step * math.round(centre / step) : centre;
        }

        /// <summary>From the coordinates outside.</summary>
        public Affine Into => Scaled(Unit, -Unit * Origin);

        /// <summary>To the coordinates outside.</summary>
        public Affine Back => Scaled(1 / Unit, Origin);

        static Affine Scaled(double scale, double3 origin) =>
            new Affine
            {
                X = new double3(scale, 0, 0),
                Y = new double3(0, scale, 0), Z = new double3(0, 0, scale), Origin = origin
            };
    }
}
