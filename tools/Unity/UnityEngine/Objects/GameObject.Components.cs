using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;

namespace UnityEngine;

public sealed partial class GameObject
{
    public Component AddComponent(Type componentType)
    {
        EnsureAlive();
        return ComponentAdder.Add(this, componentType);
    }

    public T AddComponent<T>()
        where T : Component => (T)AddComponent(typeof(T));

    public int GetComponentCount() => Alive()._components.Count;

    public Component GetComponentAtIndex(int index) => Alive()._components[index];

    public int GetComponentIndex(Component component) => Alive()._components.IndexOf(component);

    public Component GetComponent(Type type) => Own(type).FirstOrDefault();

    public T GetComponent<T>() => First<T>(Own(typeof(T)));

    public bool TryGetComponent(Type type, out Component component)
    {
        component = GetComponent(type);
        return component is not null;
    }

    public bool TryGetComponent<T>(out T component)
    {
        component = GetComponent<T>();
        return component is not null;
    }

    public Component[] GetComponents(Type type) => Own(type).ToArray();

    public void GetComponents(Type type, List<Component> results) => Fill(results, Own(type));

    public T[] GetComponents<T>() => Own(typeof(T)).Cast<T>().ToArray();

    public void GetComponents<T>(List<T> results) => Fill(results, Own(typeof(T)).Cast<T>());

    public Component GetComponentInChildren(Type type) => GetComponentInChildren(type, false);

    public Component GetComponentInChildren(Type type, bool includeInactive) =>
        Below(type, includeInactive).FirstOrDefault();

    public T GetComponentInChildren<T>() => GetComponentInChildren<T>(false);

    public T GetComponentInChildren<T>(bool includeInactive) => First<T>(Below(typeof(T), includeInactive));

    public Component[] GetComponentsInChildren(Type type) => GetComponentsInChildren(type, false);

    public Component[] GetComponentsInChildren(Type type, bool includeInactive) =>
        Below(type, includeInactive).ToArray();

    public T[] GetComponentsInChildren<T>() => GetComponentsInChildren<T>(false);

    public T[] GetComponentsInChildren<T>(bool includeInactive) =>
        Below(typeof(T), includeInactive).Cast<T>().ToArray();

    public void GetComponentsInChildren<T>(List<T> results) => GetComponentsInChildren(false, results);

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> results) =>
        Fill(results, Below(typeof(T), includeInactive).Cast<T>());

    public Component GetComponentInParent(Type type) => GetComponentInParent(type, false);

    public Component GetComponentInParent(Type type, bool includeInactive) =>
        Above(type, includeInactive).FirstOrDefault();

    public T GetComponentInParent<T>() => GetComponentInParent<T>(false);

    public T GetComponentInParent<T>(bool includeInactive) => First<T>(Above(typeof(T), includeInactive));

    public Component[] GetComponentsInParent(Type type) => GetComponentsInParent(type, false);

    public Component[] GetComponentsInParent(Type type, bool includeInactive) => Above(type, includeInactive).ToArray();

    public T[] GetComponentsInParent<T>() => GetComponentsInParent<T>(false);

    public T[] GetComponentsInParent<T>(bool includeInactive) => Above(typeof(T), includeInactive).Cast<T>().ToArray();

    public void GetComponentsInParent<T>(bool includeInactive, List<T> results) =>
        Fill(results, Above(typeof(T), includeInactive).Cast<T>());

    static T First<T>(IEnumerable<Component> components) => (T)(object)components.FirstOrDefault();

    static void Fill<T>(List<T> results, IEnumerable<T> found)
    {
        results.Clear();
        results.AddRange(found);
    }

    GameObject Alive()
    {
        EnsureAlive();
        return this;
    }

    IEnumerable<Component> Own(Type type) => Alive()._components.Where(type.IsInstanceOfType);

    // As in Unity, an inactive object itself counts only if the caller includes inactive ones.
    IEnumerable<Component> Below(Type type, bool includeInactive) =>
        Alive().Node.Descendants()
            .Where(node => includeInactive || node.Owner.ActiveCached)
            .SelectMany(node => node.Owner._components.Where(type.IsInstanceOfType));

    IEnumerable<Component> Above(Type type, bool includeInactive) =>
        Alive().Node.Ancestors()
            .Where(node => includeInactive || node.Owner.ActiveCached)
            .SelectMany(node => node.Owner._components.Where(type.IsInstanceOfType));
}
