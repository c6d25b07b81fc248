using System;
using System.Collections.Generic;

namespace Glint.Host;

/// <summary>Numbers of shader property names, constant while the program runs.</summary>
internal static class PropertyIds
{
    static readonly Dictionary<string, int> _ids = new();

    internal static int Get(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        lock (_ids)
        {
            if (!_ids.TryGetValue(name, out int id))
                _ids[name] = id = _ids.Count + 1;
            return id;
        }
    }
}
