namespace Glint.Core
{
    /// <summary>
    /// The input of a trace, gathered once: a value. Scene and view are in the same frame; settings and view describe
    /// the same picture.
    /// </summary>
    public struct RadarPose
    {
        /// <summary>The traced scene.</summary>
        public RadarScene Scene;

        /// <summary>Frequency, rays, region and bounces; with a fitted aperture its rays.</summary>
        public RadarSettings Settings;

        /// <summary>Pose, field of view or aperture of the radar, and the receiver.</summary>
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
