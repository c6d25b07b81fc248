using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace UnityEditor;

[Flags]
public enum StaticEditorFlags
{
    ContributeGI = 1,
    OccluderStatic = 2,
    BatchingStatic = 4,
    OccludeeStatic = 16,
    ReflectionProbeStatic = 64,
}

public sealed class GameObjectUtility
{
    /// <summary>In the host an object has all static flags or none.</summary>
    public static StaticEditorFlags GetStaticEditorFlags(GameObject go) =>
        go.isStatic ? Enum.GetValues<StaticEditorFlags>().Aggregate((all, flag) => all | flag) : 0;

    /// <summary>A missing flag counts as none.</summary>
    public static void SetStaticEditorFlags(GameObject go, StaticEditorFlags flags) =>
        go.isStatic = (flags & StaticEditorFlags.BatchingStatic) != 0;

    public static bool AreStaticEditorFlagsSet(GameObject go, StaticEditorFlags flags) =>
        (GetStaticEditorFlags(go) & flags) == flags;

    /// <summary>Sets parent, position and layer.</summary>
    public static void SetParentAndAlign(GameObject child, GameObject parent)
    {
        if (parent == null)
            return;
        child.transform.SetParent(parent.transform, false);
        foreach (Transform item in child.GetComponentsInChildren<Transform>(true))
            item.gameObject.layer = parent.layer;
    }

    /// <summary>The name, with a number appended if a sibling has it.</summary>
    public static void EnsureUniqueNameForSibling(GameObject self)
    {
        string name = self.name;
        HashSet<string> taken = Siblings(self.transform).Select(sibling => sibling.name).ToHashSet();
        for (int number = 1; taken.Contains(self.name); number++)
            self.name = $"{name} ({number})";
    }

    static IEnumerable<Transform> Siblings(Transform item)
    {
        IEnumerable<Transform> all = item.parent != null
            ? Enumerable.Range(0, item.parent.childCount).Select(item.parent.GetChild)
            : item.gameObject.scene.GetRootGameObjects().Select(root => root.transform);
        return all.Where(sibling => sibling != item);
    }
}
