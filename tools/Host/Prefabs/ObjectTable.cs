using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Host;

/// <summary>The objects of one file by id, with those of its prefab instances.</summary>
internal sealed class ObjectTable
{
    // Prefabs that hold each other twice, level by level, make small files with exponentially many objects. An object
    // counts as this number of values.
    const long MaxValues = 20_000_000, ObjectWeight = 50;

    readonly Dictionary<long, ObjectRecord> _byId = new();
    readonly List<ObjectRecord> _records = new();
    readonly Dictionary<long, ObjectRecord> _instanceRoots = new();
    readonly HashSet<long> _skipped = new();
    Dictionary<ObjectReference, ObjectRecord> _byOrigin;
    long _lastFreeId, _values, _copySize;

    internal ObjectTable(string shownPath, string guid)
    {
        ShownPath = shownPath;
        Guid = guid;
    }

    /// <summary>Path for messages, relative to the project.</summary>
    internal string ShownPath { get; }

    /// <summary>Null without a .meta.</summary>
    internal string Guid { get; }

    /// <summary>The Transform of a prefab's root; null for other files.</summary>
    internal ObjectRecord Root { get; set; }

    /// <summary>Objects in the order of the file, then those of prefab instances.</summary>
    internal IReadOnlyList<ObjectRecord> Records => _records;

    /// <summary>Memory of a copy of all objects, as a number of values.</summary>
    internal long CopySize =>
        _copySize > 0 ? _copySize : _copySize = _records.Sum(record => ObjectWeight + record.Fields.Node.CopySize());

    /// <summary>Ids of the objects of unknown classes.</summary>
    internal IReadOnlyCollection<long> Skipped => _skipped;

    internal ObjectRecord Find(long id) => _byId.GetValueOrDefault(id);

    internal bool IsFree(long id) => id != 0 && !_byId.ContainsKey(id);

    /// <summary>A free id, for an object that no reference names by id.</summary>
    internal long FreeId()
    {
        do
            _lastFreeId--;
        while (!IsFree(_lastFreeId));
        return _lastFreeId;
    }

    internal bool IsSkipped(long id) => _skipped.Contains(id);

    internal void AddSkipped(long id) => _skipped.Add(id);

    /// <summary>Adds the root of a prefab instance, which a scene lists by the id of the instance.</summary>
    internal void AddInstanceRoot(long instanceId, ObjectRecord root) => _instanceRoots[instanceId] = root;

    internal ObjectRecord FindRoot(long id) => Find(id) ?? _instanceRoots.GetValueOrDefault(id);

    internal void Add(ObjectRecord record)
    {
        if (!_byId.TryAdd(record.Id, record))
            throw new GlintException($"{ShownPath}: a second object &{record.Id}: restore the file");
        _records.Add(record);
        (_byOrigin, _copySize) = (null, 0);
    }

    /// <summary>Reserves room for the values that prefab instances add.</summary>
    /// <exception cref="GlintException">The total exceeds the maximum.</exception>
    internal void Reserve(long values)
    {
        _values += values;
        if (_values > MaxValues)
            throw new GlintException($"{ShownPath}: its prefab instances, with those in the prefabs, "
                + $"hold more than {MaxValues} values: remove some");
    }

    /// <summary>Adds a further id of an object, unless it is taken.</summary>
    internal void AddAlias(long id, ObjectRecord record) => _byId.TryAdd(id, record);

    internal void Remove(IReadOnlySet<ObjectRecord> removed)
    {
        if (removed.Count == 0)
            return;
        _records.RemoveAll(removed.Contains);
        (_byOrigin, _copySize) = (null, 0);
        foreach (long id in _byId.Where(entry => removed.Contains(entry.Value)).Select(entry => entry.Key).ToList())
            _byId.Remove(id);
    }

    /// <summary>
    /// Resolves a reference from another file: an object's id in this file, or its id in a prefab nested in it.
    /// </summary>
    internal ObjectRecord Resolve(ObjectReference reference)
    {
        if (reference.IsLocal || reference.Guid == Guid)
            return Find(reference.FileId);
        return (_byOrigin ??= ByOrigin()).GetValueOrDefault(reference);
    }

    Dictionary<ObjectReference, ObjectRecord> ByOrigin()
    {
        Dictionary<ObjectReference, ObjectRecord> found = new();
        foreach (ObjectRecord record in _records)
        {
            foreach (ObjectReference origin in record.Origins)
                found.TryAdd(origin, record);
        }
        return found;
    }
}
