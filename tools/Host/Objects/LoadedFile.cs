using System.Collections.Generic;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>A file's table and the objects made from it so far.</summary>
internal sealed class LoadedFile(ObjectTable table)
{
    readonly Dictionary<ObjectRecord, Object> _objects = new();

    internal ObjectTable Table { get; } = table;

    /// <summary>Objects in the order of creation.</summary>
    internal IReadOnlyDictionary<ObjectRecord, Object> Objects => _objects;

    internal void Add(ObjectRecord record, Object made) => _objects.Add(record, made);

    /// <summary>Null for objects of classes that the host lacks.</summary>
    internal Object Find(ObjectRecord record) => _objects.GetValueOrDefault(record);
}
