using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Originals and their clones: references inside a cloned hierarchy are mapped, others are unchanged.
/// </summary>
internal sealed class CloneMap
{
    readonly Dictionary<Object, Object> _clones = new(ReferenceEqualityComparer.Instance);

    internal IEnumerable<KeyValuePair<Object, Object>> Pairs => _clones;

    internal void Add(Object original, Object clone) => _clones.Add(original, clone);

    internal T Of<T>(T original)
        where T : Object
    {
        if (Object.IsNull(original))
            return null;
        return _clones.TryGetValue(original, out Object clone) ? (T)clone : original;
    }
}
