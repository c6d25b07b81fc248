using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// A scene of the accuracy benchmark, built in code.
    /// </summary>
    public sealed class AccuracyScene
    {
        /// <summary>Grazing angle of the published experiment, degrees.</summary>
        public const double PublishedGrazingDegrees = 10;

        const double PublishedFov = 60, PublishedReceiver = 3, ReceiverBehindCamera = 0.2;

        internal AccuracyScene(string name, RadarScene scene, RadarView view)
        {
            Name = name;
            Scene = scene;
            View = view;
        }

        /// <summary>Name of target and direction.</summary>
        public string Name { get; }

        /// <summary>The traced scene.</summary>
        public RadarScene Scene { get; }

        /// <summary>Poses of radar and receiver.</summary>
        public RadarView View { get; }

        /// <summary>True if the scene is large enough to time the stages of a pose.</summary>
        public bool HasMuch => Scene.TriangleCount > 10000;

        /// <summary>
        /// The scenes. Returns are large and flat, in or out of phase, curved, or in many small pieces.
        /// </summary>
        public static IReadOnlyList<AccuracyScene> All()
        {
            var sea = new SeaAndShip(1, 35000, 44000);
            return new[]
            {
                Corner(0), Corner(10), Corner(23), Corner(28),
                new AccuracyScene("flat plate, 1 deg", Turned(Plate(4), 1), PublishedView(50, 0)),
                new AccuracyScene("ship-like body, broadside", new RadarScene(sea.Ship),
                    PublishedView(50, PublishedGrazingDegrees)),
                new AccuracyScene("ship-like body, bow on", Turned(sea.Ship, 90),
                    PublishedView(50, PublishedGrazingDegrees)),
                new AccuracyScene("rough sea, seen from above", new RadarScene(sea.Sea), PublishedView(50, 85)),
            };
        }

        /// <summary>
        /// The camera of the published experiment looking along +Z at the origin: 60 degrees high,
        /// receiver 3 x 3 m, 0.2 m behind it.
        /// </summary>
        /// <param name="distance">Distance to the origin, metres.</param>
        /// <param name="grazing">Grazing angle, degrees.</param>
        public static RadarView PublishedView(double distance, double grazing)
        {
            double down = math.radians(grazing);
            double3 right = new double3(1, 0, 0), up = new double3(0, math.cos(down), math.sin(down)),
                forward = new double3(0, -math.sin(down), math.cos(down));
            return new RadarView
            {
                Position = -distance * forward, Right = right, Up = up,
                Forward = forward, VerticalFovDegrees = PublishedFov,
                ReceiverCentre = -(distance + ReceiverBehindCamera) * forward, ReceiverRight = right, ReceiverUp = up,
                ReceiverForward = forward, ReceiverSize = PublishedReceiver,
            };
        }

        static AccuracyScene Corner(double degrees) =>
            new AccuracyScene($"corner reflector, {degrees:0} deg",
                CornerReflector.Turned(degrees), CornerReflector.View);

        /// <summary>
        /// A mesh turned about the vertical through its origin, positive as Unity's rotation about Y.
        /// </summary>
        internal static RadarScene Turned(TriangleMesh mesh, double degrees)
        {
            double half = math.radians(degrees) / 2;
            return new RadarScene(new MeshInstance
            {
                Mesh = mesh, ToWorld = Affine.FromTransform(0, new double4(0, math.sin(half), 0, math.cos(half)), 1)
            });
        }

        // A square perpendicular to the z axis.
        static TriangleMesh Plate(float side)
        {
            float half = side / 2;
            var corners = new[]
            {
                new float3(-half, -half, 0),
                new float3(half, -half, 0), new float3(half, half, 0), new float3(-half, half, 0)
            };
            return new TriangleMesh(corners, new[] { 0, 1, 2, 0, 2, 3 });
        }
    }
}
