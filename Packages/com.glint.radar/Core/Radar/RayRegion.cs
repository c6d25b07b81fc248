namespace Glint.Core
{
    /// <summary>
    /// A rectangle of the picture, in rays from its left and bottom edge; the rays outside are not emitted.
    /// Without area: the whole picture.
    /// </summary>
    public struct RayRegion
    {
        /// <summary>Left and bottom edge, width and height, all in rays of the whole picture.</summary>
        public int Left, Bottom, Width, Height;

        /// <summary>True for the whole picture.</summary>
        public bool IsWhole => Width == 0 && Height == 0;
    }
}
