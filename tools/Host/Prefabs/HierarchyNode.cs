using System.Collections.Generic;

namespace Glint.Host;

/// <summary>A GameObject with its components and children, still as text.</summary>
internal sealed class HierarchyNode(ObjectRecord gameObject)
{
    internal ObjectRecord GameObject { get; } = gameObject;

    internal ObjectRecord Transform { get; set; }

    /// <summary>Components except the Transform, in order; unknown classes are left out.</summary>
    internal List<ObjectRecord> Components { get; } = new();

    internal HierarchyNode Parent { get; set; }

    internal List<HierarchyNode> Children { get; } = new();
}
