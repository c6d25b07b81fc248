using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Groups of changes that can be undone, latest first. A recorded object counts as changed.</summary>
public class Undo
{
    public delegate void UndoRedoCallback();

    public static UndoRedoCallback undoRedoPerformed;

    static readonly List<Entry> _entries = new();
    static int _group;
    static string _name = "";

    public static void RecordObject(Object objectToUndo, string name) => RegisterCompleteObjectUndo(objectToUndo, name);

    public static void RecordObjects(Object[] objectsToUndo, string name)
    {
        foreach (Object item in objectsToUndo)
            RecordObject(item, name);
    }

    public static void RegisterCompleteObjectUndo(Object objectToUndo, string name)
    {
        var state = (Object)ObjectRegistry.Make(false, () => ScriptReflection.New(objectToUndo.GetType()));
        state.CopyFrom(objectToUndo, new CloneMap());
        Add(objectToUndo, name, () => Restore(objectToUndo, state));
    }

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name) =>
        Add(objectToUndo, name, () => Destruction.Now(objectToUndo)); // also what another component requires

    public static T AddComponent<T>(GameObject gameObject)
        where T : Component => (T)AddComponent(gameObject, typeof(T));

    public static Component AddComponent(GameObject gameObject, Type type)
    {
        Component added = gameObject.AddComponent(type);
        if (added != null)
            RegisterCreatedObjectUndo(added, $"Add {type.Name}");
        return added;
    }

    public static void IncrementCurrentGroup()
    {
        _group++;
        _name = "";
    }

    public static int GetCurrentGroup() => _group;

    public static string GetCurrentGroupName() => _name;

    public static void SetCurrentGroupName(string name) => _name = name;

    /// <summary>Merges this group and all later ones.</summary>
    public static void CollapseUndoOperations(int groupIndex)
    {
        foreach (Entry entry in _entries.Where(entry => entry.Group > groupIndex))
            entry.Group = groupIndex;
    }

    /// <summary>Undoes the latest group with changes.</summary>
    public static void PerformUndo()
    {
        if (_entries.Count == 0)
            return;
        int group = _entries[^1].Group;
        while (_entries.Count > 0 && _entries[^1].Group == group)
        {
            Entry entry = _entries[^1];
            _entries.RemoveAt(_entries.Count - 1);
            entry.TakeBack();
        }
        undoRedoPerformed?.Invoke();
    }

    public static void FlushUndoRecordObjects()
    {
    }

    public static void ClearAll() => _entries.Clear();

    internal static void Add(Object target, string name, Action takeBack)
    {
        if (_name.Length == 0)
            _name = name;
        _entries.Add(new Entry { Group = _group, TakeBack = takeBack });
        GameObject owner = target as GameObject ?? (target as Component)?.Owner;
        if (owner?.SceneData is { } scene && !Engine.IsPlaying)
            scene.IsDirty = true;
    }

    // Changes of transforms and active states must be propagated.
    static void Restore(Object target, Object state)
    {
        if (Object.IsNull(target))
            return;
        bool wasActive = (target as GameObject)?.ActiveSelf ?? false,
            wasEnabled = (target as Behaviour)?.EnabledSelf ?? false;
        target.CopyFrom(state, new CloneMap());
        if (target is GameObject gameObject && gameObject.ActiveSelf != wasActive)
            Activation.Refresh(gameObject);
        if (target is Transform transform)
            transform.localPosition = transform.localPosition;
        if (target is Behaviour behaviour && behaviour.EnabledSelf != wasEnabled)
            behaviour.OnEnabledChanged();
        if (target is MonoBehaviour script)
            Messages.Call(script, "OnValidate");
    }

    sealed class Entry
    {
        internal int Group { get; set; }
        internal Action TakeBack { get; init; }
    }
}
