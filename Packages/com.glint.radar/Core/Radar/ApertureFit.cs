using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Chooses the aperture of parallel rays from their spacing: as large as the scene seen from the radar, or of a
    /// given size.
    /// </summary>
    public static class ApertureFit
    {
        // Fraction of a spacing that is rounding: the outermost rays are half a spacing inside the edges.
        const double Tolerance = 1e-6;

        /// <summary>
        /// Chooses the picture so that its rays cover the scene, seen along <see cref="RadarView.Forward"/>, at the
        /// given spacing and without superfluous rows or columns: rays across and down, and the aperture's height and
        /// centre. The centre is <see cref="RadarView.Position"/> moved sideways, not nearer.
        /// </summary>
        /// <param name="spacing">From ray to ray in metres, across and down.</param>
        /// <param name="owner">Who holds the radar, for messages.</param>
        /// <exception cref="GlintException">
        /// The scene has no triangles, or the spacing is out of range or takes too many rays.
        /// </exception>
        public static void Cover(ref RadarPose pose, double spacing, string owner)
        {
            Project(pose.Scene, pose.View, out var boxMin, out var boxMax);
            if (!(boxMin.x <= boxMax.x))
                throw new GlintException($"{owner}: there is nothing to fit its aperture to: "
                    + "no triangles are traced (check its layers and roots, or give the aperture a size)");
            Divide(boxMax - boxMin, spacing, ref pose, owner);
            double2 centre = (boxMin + boxMax) / 2;
            pose.View.Position += centre.x * pose.View.Right + centre.y * pose.View.Up;
        }

        /// <summary>
        /// Chooses the picture so that its rays cover a rectangle about the view axis at the given spacing.
        /// The aperture is enlarged to a whole number of rays.
        /// </summary>
        /// <param name="size">Width and height of the rectangle, metres.</param>
        /// <param name="spacing">From ray to ray in metres, across and down.</param>
        /// <param name="owner">Who holds the radar, for messages.</param>
        /// <exception cref="GlintException">The spacing is out of range or takes too many rays.</exception>
        public static void Divide(double2 size, double spacing, ref RadarPose pose, string owner)
        {
            CheckSpacing(spacing, owner);
            double2 rays = math.max(1, math.ceil(size / spacing - Tolerance));
            if (math.cmax(rays) > RadarSettings.RaysPerAxisLimit || rays.x * rays.y > uint.MaxValue)
                throw new GlintException(FormattableString.Invariant(
                    $"{owner}: rays {spacing} m apart over {size.x:g4} x {size.y:g4} m are {rays.x:0} x {rays.y:0}, and the maximum is {RadarSettings.RaysPerAxisLimit} each way and {uint.MaxValue} in all: use a larger spacing"));
            (pose.Settings.RaysAcross, pose.Settings.RaysDown) = ((int)rays.x, (int)rays.y);
            pose.View.ApertureHeight = rays.y * spacing;
        }

        /// <summary>Refuses an invalid spacing.</summary>
        /// <exception cref="GlintException">It is not positive and finite.</exception>
        public static void CheckSpacing(double spacing, string owner)
        {
            if (!(spacing > 0) || double.IsInfinity(spacing))
                throw new GlintException($"{owner}: ray spacing {RadarSettings.Text(spacing)} m must be "
                    + "positive and finite");
        }

        /// <summary>
        /// Gives the receiver the aperture's size and moves it onto the aperture's axis, at the same depth.
        /// </summary>
        public static void MatchReceiver(ref RadarPose pose)
        {
            var view = pose.View;
            view.ReceiverSize = 2 * view.HalfSize(pose.Settings);
            view.ReceiverCentre =
                view.Position + math.dot(view.ReceiverCentre - view.Position, view.Forward) * view.Forward;
            pose.View = view;
        }

        // Corners of the rectangle around all triangles, along the view's right and up, from its position;
        // the minimum is above the maximum when there are no triangles.
        static void Project(RadarScene scene, in RadarView view, out double2 boxMin, out double2 boxMax)
        {
            (boxMin, boxMax) = (double.PositiveInfinity, double.NegativeInfinity);
            foreach (var instance in scene.Instances)
            {
                var toWorld = instance.ToWorld;
                var across = new double3(math.dot(toWorld.X, view.Right), math.dot(toWorld.Y, view.Right),
                    math.dot(toWorld.Z, view.Right));
                var up =
                    new double3(math.dot(toWorld.X, view.Up), math.dot(toWorld.Y, view.Up),
                        math.dot(toWorld.Z, view.Up));
                var vertices = instance.Mesh.Vertices;
                double2 meshMin = double.PositiveInfinity, meshMax = double.NegativeInfinity;
                foreach (int index in instance.Mesh.Indices) // vertices without a triangle do not count
                {
                    double3 vertex = vertices[index];
                    var point = new double2(math.dot(across, vertex), math.dot(up, vertex));
                    meshMin = math.min(meshMin, point);
                    meshMax = math.max(meshMax, point);
                }
                double3 toOrigin = toWorld.Origin - view.Position;
                var origin = new double2(math.dot(toOrigin, view.Right), math.dot(toOrigin, view.Up));
                boxMin = math.min(boxMin, origin + meshMin);
                boxMax = math.max(boxMax, origin + meshMax);
            }
        }
    }
}
