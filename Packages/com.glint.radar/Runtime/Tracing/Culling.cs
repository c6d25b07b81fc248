using System;

namespace Glint
{
    /// <summary>
    /// Work that may be skipped without changing a result. The kernels have the same numbers: CULL_ in
    /// Shaders/Constants.hlsl.
    /// </summary>
    [Flags]
    public enum Culling
    {
        /// <summary>All work is done.</summary>
        None = 0,

        /// <summary>Traversal ends at the receiver.</summary>
        Reach = 1,

        /// <summary>The segment after the last bounce is traversed only if it meets the receiver.</summary>
        LastSegment = 2,

        /// <summary>Tiles that cannot see the scene are not traced.</summary>
        Tiles = 4,

        /// <summary>
        /// First segments start at the entry points of their cell, in scenes with inline instances.
        /// </summary>
        EntryPoints = 8,

        /// <summary>All that is skipped in a pose.</summary>
        All = Reach | LastSegment | Tiles | EntryPoints,
    }
}
