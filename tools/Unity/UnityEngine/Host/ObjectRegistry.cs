using System;
using System.Collections.Generic;
using System.Linq;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Instance ids, and all live objects by id: positive for objects of files, negative for objects made by code.
/// </summary>
internal static class ObjectRegistry
{
    static readonly object _lock = new();
    static readonly Dictionary<int, WeakReference<Object>> _objects = new();
    static int _fromFiles;
    static int _fromCode;

    [ThreadStatic]
    static bool _loading;

    internal static int Add(Object item)
    {
        lock (_lock)
        {
            int id = _loading ? _fromFiles += 2 : _fromCode -= 2;
            _objects.Add(id, new WeakReference<Object>(item));
            return id;
        }
    }

    internal static void Remove(Object item)
    {
        lock (_lock)
            _objects.Remove(item.GetInstanceID());
    }

    internal static Object Find(int instanceId)
    {
        lock (_lock)
            return _objects.TryGetValue(instanceId, out WeakReference<Object> reference)
                && reference.TryGetTarget(out Object item) ? item : null;
    }

    internal static List<Object> All()
    {
        lock (_lock)
        {
            var alive = new List<Object>(_objects.Count);
            foreach (int id in _objects.Keys.ToArray())
            {
                if (_objects[id].TryGetTarget(out Object item))
                    alive.Add(item);
                else
                    _objects.Remove(id);
            }
            return alive;
        }
    }

    /// <summary>Makes an object with an id for files or for code.</summary>
    internal static T Make<T>(bool fromFile, Func<T> constructor)
    {
        bool outer = _loading;
        _loading = fromFile;
        try
        {
            return constructor();
        }
        finally
        {
            _loading = outer;
        }
    }
}
