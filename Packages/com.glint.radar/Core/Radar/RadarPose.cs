namespace Glint.Core
{
    /// <summary>
    /// All that one pose is traced from, gathered once. Scene and view are in the same frame;
    /// settings and view are of the same picture.
    /// </summary>
    public struct RadarPose
    {
        /// <summary>What is traced.</summary>
        public RadarScene Scene;

        /// <summary>Frequency, rays, region and bounces; those of a fitted aperture where the radar fits one.</summary>
        public RadarSettings Settings;

        /// <summary>Pose of radar and receiver, and what they see.</summary>
        public RadarView View;

        /// <summary>A pose of a scene.</summary>
        /// <param name="view">In the frame of the scene.</param>
        public RadarPose(RadarScene scene, in RadarSettings settings, in RadarView view)
        {
            Scene = scene;
            Settings = settings;
            View = view;
        }
    }
}
