using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>At most one object. Undo restores the one before.</summary>
public sealed class Selection
{
    public static Action selectionChanged;

    static Object _active;

    public static Object activeObject
    {
        get => Object.IsNull(_active) ? null : _active;
        set
        {
            if (activeObject == value)
                return;
            Object before = _active;
            Undo.Add(null, "Selection Change", () => Change(before));
            Change(value);
        }
    }

    static void Change(Object active)
    {
        _active = active;
        selectionChanged?.Invoke();
    }

    public static bool Contains(Object obj) => !Object.IsNull(obj) && activeObject == obj;

    public static GameObject activeGameObject
    {
        get => activeObject as GameObject ?? (activeObject as Component)?.gameObject;
        set => activeObject = value;
    }

    public static Transform activeTransform
    {
        get => activeGameObject == null ? null : activeGameObject.transform;
        set => activeObject = value;
    }
}
