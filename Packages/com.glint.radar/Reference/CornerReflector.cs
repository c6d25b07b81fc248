using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// The corner reflector of the published experiment with its radar, in the recovered geometry. The thesis does not
    /// give the geometry; it was fitted to rays hit, rays received and amplitudes of all 46 rows of Table A.2 together.
    /// <c>glint reflector</c> makes the stored prefabs from these numbers.
    /// </summary>
    public static class CornerReflector
    {
        /// <summary>
        /// Distance from the camera to the turning point, metres. The turning point is the world's origin.
        /// </summary>
        public const double Distance = 41.112;

        /// <summary>Elevation of the camera above the turning point, degrees.</summary>
        public const double ElevationDegrees = 9.974;

        /// <summary>Pitch of the camera below the horizontal, degrees.</summary>
        public const double PitchDegrees = 9.985;

        /// <summary>
        /// Pitch of the receiver, upwards from the view axis, degrees: the receiver looks down by 6 degrees.
        /// </summary>
        public const double ReceiverTiltDegrees = 4.0;

        /// <summary>Centre of the receiver in the camera's frame (right, up, forward), metres.</summary>
        public static double3 ReceiverOffset => new double3(0, -0.210, -0.236);

        // Faces and ends of a plate along the axes of the reflector, from its vertex, metres. Plates intersect in their
        // middle planes: each ends half a thickness behind its neighbours' inner faces.
        const double Thickness = 0.211, PlateStart = -Thickness / 2, PlateEnd = 15.8985;

        // The angle between the vertical and the reflector's z axis, degrees.
        const double LeanDegrees = 49.132;

        // The turning point in the reflector's axes, from its vertex, metres.
        static double3 TurningPoint => new double3(7.871, 7.871, 8.052);

        /// <summary>The 36 triangles about the turning point.</summary>
        public static TriangleMesh Mesh { get; } = Make();

        /// <summary>Camera and receiver of the published sweep.</summary>
        public static RadarView View
        {
            get
            {
                double elevation = math.radians(ElevationDegrees);
                var view = AccuracyScene.PublishedView(Distance, PitchDegrees);
                view.Position = Distance * new double3(0, math.sin(elevation), -math.cos(elevation));
                view.ReceiverCentre = view.Position + ReceiverOffset.x * view.Right + ReceiverOffset.y * view.Up
                    + ReceiverOffset.z * view.Forward;
                double tilt = math.radians(ReceiverTiltDegrees), sin = math.sin(tilt), cos = math.cos(tilt);
                view.ReceiverUp = cos * view.Up - sin * view.Forward;
                view.ReceiverForward = cos * view.Forward + sin * view.Up;
                return view;
            }
        }

        /// <summary>
        /// The reflector turned about the vertical by an angle in degrees, positive as Unity's rotation about Y.
        /// </summary>
        public static RadarScene Turned(double degrees) => AccuracyScene.Turned(Mesh, degrees);

        /// <summary>The reflector's axes at 0 degrees, a rotation; their origin is the vertex.</summary>
        public static Affine Axes
        {
            get
            {
                double lean = math.radians(LeanDegrees);
                double3 across = new double3(1, 0, 0), along = new double3(0, -math.sin(lean), -math.cos(lean));
                var axes = new Affine
                {
                    X = (along + across) / math.sqrt(2.0), Y = (along - across) / math.sqrt(2.0),
                    Z = new double3(0, math.cos(lean), -math.sin(lean))
                };
                axes.Origin = axes.Vector(-TurningPoint);
                return axes;
            }
        }

        /// <summary>
        /// Lowest and highest corner of the plate across an axis of the reflector: 0, 1 or 2 for x, y or z.
        /// </summary>
        public static (double3 min, double3 max) Plate(int normal)
        {
            double3 min = PlateStart, max = PlateEnd;
            min[normal] = -Thickness;
            max[normal] = 0;
            return (min, max);
        }

        static TriangleMesh Make()
        {
            var vertices = new List<float3>();
            var indices = new List<int>();
            for (int normal = 0; normal < 3; normal++)
            {
                var (min, max) = Plate(normal);
                AddBox(vertices, indices, Axes, min, max);
            }
            return new TriangleMesh(vertices.ToArray(), indices.ToArray());
        }

        static void AddBox(List<float3> vertices, List<int> indices, in Affine axes, double3 min, double3 max)
        {
            int first = vertices.Count;
            for (int corner = 0; corner < 8; corner++)
                vertices.Add((float3)axes.Point(Box.CornerOf(min, max, corner)));
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
