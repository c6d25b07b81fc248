namespace Glint.Editor.Views
{
    /// <summary>The window that sweeps.</summary>
    static class RadarWindow
    {
        /// <summary>Opens it on a radar.</summary>
        public static void Show(RadarController radar)
        {
        }
    }
}
