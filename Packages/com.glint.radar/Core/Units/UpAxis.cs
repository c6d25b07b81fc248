namespace Glint.Core
{
    /// <summary>The axis of a mesh file that points up.</summary>
    public enum UpAxis
    {
        /// <summary>As in Unity: x right, y up, z forward.</summary>
        Y,

        /// <summary>(x, y, z) of the file is (x, z, y) of Unity.</summary>
        Z
    }
}
