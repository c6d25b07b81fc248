namespace Glint.Core
{
    /// <summary>
    /// All that one pose is traced from. Scene and view are in the same frame;
    /// settings and view are of the same picture.
    /// </summary>
    public struct RadarPose
    {
        /// <summary>What is traced.</summary>
        public RadarScene Scene;

        /// <summary>Frequency, rays, region and bounces; those of a fitted aperture where the radar fits one.</summary>
        public RadarSettings Settings;

        /// <summary>Where radar and receiver stand, and what they see.</summary>
        public RadarView View;
    }
}
