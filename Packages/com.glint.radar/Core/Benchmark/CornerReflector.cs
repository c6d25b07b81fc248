using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The corner reflector of the published experiment, built in code: three square plates, 16 x 16 x 0.2 m, before the camera of <see cref="AccuracyScene.PublishedView"/>.</summary>
    public static class CornerReflector
    {
        /// <summary>From the camera to the point about whose vertical it turns, metres; that point is the origin.</summary>
        public const double Distance = 41.08;

        /// <summary>The camera looks down by so much, degrees.</summary>
        public const double GrazingDegrees = 10;

        // Along the axes of the reflector, from its vertex: a plate's faces, its ends, and the point it turns about.
        const double Thickness = 0.2, Near = -0.1, Far = 15.9, Centre = 8;

        // How far the reflector leans over.
        const double LeanDegrees = 49.25;

        /// <summary>The 36 triangles; their origin is the point the reflector turns about.</summary>
        public static TriangleMesh Mesh { get; } = Make();

        /// <summary>Turned by so much about the vertical, positive as Unity's rotation about Y.</summary>
        public static RadarScene Turned(double degrees) => AccuracyScene.Turned(Mesh, degrees);

        /// <summary>From the reflector's own axes, whose origin is its vertex; they turn and do not mirror.</summary>
        internal static Affine Axes
        {
            get
            {
                double lean = math.radians(LeanDegrees);
                double3 across = new double3(1, 0, 0), along = new double3(0, -math.sin(lean), -math.cos(lean));
                var axes = new Affine { X = (along + across) / math.sqrt(2.0), Y = (along - across) / math.sqrt(2.0), Z = new double3(0, math.cos(lean), -math.sin(lean)) };
                axes.Origin = axes.Vector(-Centre);
                return axes;
            }
        }

        /// <summary>Corners of the plate across an axis of the reflector: 0, 1 or 2 for x, y or z.</summary>
        internal static (double3 low, double3 high) Plate(int normal)
        {
            double3 low = Near, high = Far;
            low[normal] = -Thickness;
            high[normal] = 0;
            return (low, high);
        }

        static TriangleMesh Make()
        {
            var vertices = new List<float3>();
            var indices = new List<int>();
            for (int normal = 0; normal < 3; normal++)
            {
                var (low, high) = Plate(normal);
                AddBox(vertices, indices, Axes, low, high);
            }
            return new TriangleMesh(vertices.ToArray(), indices.ToArray());
        }

        // Corner i lies at the high end of axis a where bit a of i is set.
        static void AddBox(List<float3> vertices, List<int> indices, in Affine axes, double3 low, double3 high)
        {
            int first = vertices.Count;
            for (int corner = 0; corner < 8; corner++)
                vertices.Add((float3)axes.Point(new double3((corner & 1) == 0 ? low.x : high.x, (corner & 2) == 0 ? low.y : high.y, (corner & 4) == 0 ? low.z : high.z)));
            for (int axis = 0; axis < 3; axis++)
            {
                int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
                foreach (int side in new[] { 0, 1 << axis })
                {
                    int corner = first + side;
                    indices.AddRange(new[] { corner, corner + u, corner + u + v, corner, corner + u + v, corner + v });
                }
            }
        }
    }
}
