namespace Glint.Core
{
    /// <summary>The version of the package, as results state it.</summary>
    public static class GlintVersion
    {
        /// <summary>As in package.json; a test compares them.</summary>
        public const string Text = "0.1.0";
    }
}
