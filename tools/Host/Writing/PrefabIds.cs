using System.Buffers.Binary;
using System.Collections.Generic;
using System.Security.Cryptography;
using System.Text;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// The ids of a prefab's objects, derived from each object's path and type. The same hierarchy gets the same ids
/// again, and a change of one object keeps the ids of the others, which scenes refer to. The root's name does not
/// matter.
/// </summary>
internal static class PrefabIds
{
    /// <summary>Ids in the order of the hierarchy, each object followed by its components.</summary>
    internal static Dictionary<Object, long> Of(GameObject root)
    {
        Dictionary<Object, long> ids = new(ReferenceEqualityComparer.Instance);
        HashSet<long> taken = [];
        Add(root.transform, "", ids, taken);
        return ids;
    }

    static void Add(Transform node, string path, Dictionary<Object, long> ids, HashSet<long> taken)
    {
        GameObject item = node.gameObject;
        ids.Add(item, Free($"{path}\n{nameof(GameObject)}", taken));
        Dictionary<string, int> seen = [];
        foreach (Component component in item.Components)
            ids.Add(component, Free($"{path}\n{Numbered(component.GetType().FullName, seen)}", taken));
        seen.Clear();
        for (int index = 0; index < node.childCount; index++)
            Add(node.GetChild(index), $"{path}/{Numbered(node.GetChild(index).name, seen)}", ids, taken);
    }

    // The first object of a name has no number, so that a second one does not change its id.
    static string Numbered(string name, Dictionary<string, int> seen)
    {
        int number = seen[name] = seen.GetValueOrDefault(name) + 1;
        return number == 1 ? name : $"{name}\n{number}";
    }

    static long Free(string key, HashSet<long> taken)
    {
        long id = BinaryPrimitives.ReadInt64LittleEndian(SHA256.HashData(Encoding.UTF8.GetBytes(key))) & long.MaxValue;
        while (id == 0 || !taken.Add(id))
            id = (id + 1) & long.MaxValue;
        return id;
    }
}
