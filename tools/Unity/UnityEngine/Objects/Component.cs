using System;
using System.Collections.Generic;

namespace UnityEngine;

public class Component : Object
{
    public Transform transform => gameObject.transform;

    public GameObject gameObject
    {
        get
        {
            EnsureAlive();
            return Owner;
        }
    }

    public string tag
    {
        get => gameObject.tag;
        set => gameObject.tag = value;
    }

    internal GameObject Owner { get; set; }

    internal override string Name
    {
        get => Owner is null ? "" : Owner.Name;
        set => Owner.Name = value;
    }

    public bool CompareTag(string tag) => gameObject.CompareTag(tag);

    public int GetComponentIndex() => gameObject.GetComponentIndex(this);

    public Component GetComponent(Type type) => gameObject.GetComponent(type);

    public T GetComponent<T>() => gameObject.GetComponent<T>();

    public bool TryGetComponent(Type type, out Component component) => gameObject.TryGetComponent(type, out component);

    public bool TryGetComponent<T>(out T component) => gameObject.TryGetComponent(out component);

    public Component[] GetComponents(Type type) => gameObject.GetComponents(type);

    public void GetComponents(Type type, List<Component> results) => gameObject.GetComponents(type, results);

    public T[] GetComponents<T>() => gameObject.GetComponents<T>();

    public void GetComponents<T>(List<T> results) => gameObject.GetComponents(results);

    public Component GetComponentInChildren(Type t) => gameObject.GetComponentInChildren(t);

    public Component GetComponentInChildren(Type t, bool includeInactive) =>
        gameObject.GetComponentInChildren(t, includeInactive);

    public T GetComponentInChildren<T>() => gameObject.GetComponentInChildren<T>();

    public T GetComponentInChildren<T>(bool includeInactive) => gameObject.GetComponentInChildren<T>(includeInactive);

    public Component[] GetComponentsInChildren(Type t) => gameObject.GetComponentsInChildren(t);

    public Component[] GetComponentsInChildren(Type t, bool includeInactive) =>
        gameObject.GetComponentsInChildren(t, includeInactive);

    public T[] GetComponentsInChildren<T>() => gameObject.GetComponentsInChildren<T>();

    public T[] GetComponentsInChildren<T>(bool includeInactive) =>
        gameObject.GetComponentsInChildren<T>(includeInactive);

    public void GetComponentsInChildren<T>(List<T> results) => gameObject.GetComponentsInChildren(results);

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> result) =>
        gameObject.GetComponentsInChildren(includeInactive, result);

    public Component GetComponentInParent(Type t) => gameObject.GetComponentInParent(t);

    public Component GetComponentInParent(Type t, bool includeInactive) =>
        gameObject.GetComponentInParent(t, includeInactive);

    public T GetComponentInParent<T>() => gameObject.GetComponentInParent<T>();

    public T GetComponentInParent<T>(bool includeInactive) => gameObject.GetComponentInParent<T>(includeInactive);

    public Component[] GetComponentsInParent(Type t) => gameObject.GetComponentsInParent(t);

    public Component[] GetComponentsInParent(Type t, bool includeInactive) =>
        gameObject.GetComponentsInParent(t, includeInactive);

    public T[] GetComponentsInParent<T>() => gameObject.GetComponentsInParent<T>();

    public T[] GetComponentsInParent<T>(bool includeInactive) => gameObject.GetComponentsInParent<T>(includeInactive);

    public void GetComponentsInParent<T>(bool includeInactive, List<T> results) =>
        gameObject.GetComponentsInParent(includeInactive, results);
}
