using System;

namespace Glint
{
    /// <summary>
    /// Work that may be skipped because it cannot change a result. The kernel has the same numbers:
    /// SHORTCUT_ in Shaders/Bindings.hlsl.
    /// </summary>
    [Flags]
    enum Culling
    {
        None = 0,

        /// <summary>Nothing is searched for beyond the receiver.</summary>
        Reach = 1,

        /// <summary>The segment after the last bounce is searched only if it meets the receiver.</summary>
        LastSegment = 2,

        /// <summary>Tiles in which nothing of the scene can be seen are not traced.</summary>
        Tiles = 4,

        /// <summary>
        /// The first segments of a tile's rays begin their search where a beam around them parts:
        /// in scenes of few instances.
        /// </summary>
        EntryPoints = 8,

        All = Reach | LastSegment | Tiles | EntryPoints,
    }
}
