namespace Glint.Core
{
    /// <summary>All that one pose is traced from. Scene and view are in the same frame; settings and view are of the same picture.</summary>
    public struct RadarPose
    {
        public RadarScene Scene;

        public RadarSettings Settings;

        public RadarView View;
    }
}
