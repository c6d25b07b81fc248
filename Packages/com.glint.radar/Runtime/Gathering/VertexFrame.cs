using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// The frame in which float32 vertices keep the most digits: units of about a metre, origin among the vertices. The
    /// transforms into it and back are exact in double.
    /// </summary>
    struct VertexFrame
    {
        /// <summary>Origin of the frame in outer coordinates.</summary>
        public double3 Origin;

        /// <summary>Approximate metres per outer unit; a power of two.</summary>
        public double Unit;

        /// <param name="centre">Centre of the vertices' box.</param>
        /// <param name="half">Half sizes of the box.</param>
        public VertexFrame(double3 centre, double3 half, double unit)
        {
            Unit = unit;
            // On a grid as coarse as the box, so that coordinates on a finer grid of a power of two, such as 1/16 m,
            // stay on it.
            double step = TransformMath.PowerOfTwoBelow(math.cmax(half));
            Origin = step > 0 ? step * math.round(centre / step) : centre;
        }

        /// <summary>Transform from outer coordinates to the frame.</summary>
        public Affine Into => Scaled(Unit, -Unit * Origin);

        /// <summary>Transform from the frame to outer coordinates.</summary>
        public Affine Back => Scaled(1 / Unit, Origin);

        static Affine Scaled(double scale, double3 origin) =>
            new Affine
            {
                X = new double3(scale, 0, 0),
                Y = new double3(0, scale, 0), Z = new double3(0, 0, scale), Origin = origin
            };
    }
}
