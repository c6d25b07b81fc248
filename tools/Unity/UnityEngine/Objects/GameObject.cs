using System;
using System.Collections.Generic;
using Glint.Host;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public sealed partial class GameObject : Object
{
    readonly List<Component> _components = new();
    string _tag = "Untagged";
    int _layer;
    bool _isStatic;

    public GameObject()
        : this("New Game Object")
    {
    }

    public GameObject(string name)
        : this(name, SceneRegistry.Active)
    {
        ObjectFactory.Attach(this, typeof(Transform));
        ActiveCached = true;
    }

    public GameObject(string name, params Type[] components)
        : this(name)
    {
        foreach (Type component in components)
            AddComponent(component);
    }

    internal GameObject(string name, SceneData scene)
    {
        Name = name ?? "";
        SceneData = scene;
    }

    public Transform transform
    {
        get
        {
            EnsureAlive();
            return Node;
        }
    }

    public GameObject gameObject
    {
        get
        {
            EnsureAlive();
            return this;
        }
    }

    public Scene scene
    {
        get
        {
            EnsureAlive();
            return SceneData is null ? default : new Scene(SceneData);
        }
    }

    public int layer
    {
        get
        {
            EnsureAlive();
            return _layer;
        }
        set
        {
            EnsureAlive();
            if (value is < 0 or > 31)
            {
                Debug.LogError("A game object can only be in one layer. The layer needs to be in the range [0...31]");
                return;
            }
            _layer = value;
        }
    }

    public string tag
    {
        get
        {
            EnsureAlive();
            return _tag;
        }
        set
        {
            EnsureAlive();
            TagManager.RequireTag(value);
            _tag = value;
        }
    }

    public bool isStatic
    {
        get
        {
            EnsureAlive();
            return _isStatic;
        }
        set
        {
            EnsureAlive();
            _isStatic = value;
        }
    }

    public bool activeSelf
    {
        get
        {
            EnsureAlive();
            return ActiveSelf;
        }
    }

    public bool activeInHierarchy
    {
        get
        {
            EnsureAlive();
            return ActiveCached;
        }
    }

    internal Transform Node { get; private set; }

    /// <summary>Null for a prefab asset, which is in no scene and never active.</summary>
    internal SceneData SceneData { get; set; }

    /// <summary>The serialized value, set by the loader before the object wakes.</summary>
    internal bool ActiveSelf { get; set; } = true;

    /// <summary>Active with all its ancestors, as of the last activation that reached this object.</summary>
    internal bool ActiveCached { get; set; }

    /// <summary>OnDisable is being sent to its scripts: no parent is set or left meanwhile.</summary>
    internal bool IsDeactivating { get; set; }

    internal IReadOnlyList<Component> Components => _components;

    public static GameObject CreatePrimitive(PrimitiveType type) => Primitives.Create(type);

    public static GameObject Find(string name) => Finder.ByPath(name);

    public static GameObject FindWithTag(string tag) => Finder.FirstWithTag(tag);

    public static GameObject FindGameObjectWithTag(string tag) => Finder.FirstWithTag(tag);

    public static GameObject[] FindGameObjectsWithTag(string tag) => Finder.WithTag(tag).ToArray();

    public void SetActive(bool value)
    {
        EnsureAlive();
        if (ActiveSelf == value)
            return;
        ActiveSelf = value;
        Activation.Refresh(this);
    }

    public bool CompareTag(string tag)
    {
        EnsureAlive();
        TagManager.RequireTag(tag);
        return _tag == tag;
    }

    internal void Add(Component component)
    {
        component.Owner = this;
        _components.Add(component);
        if (component is Transform node)
        {
            Node = node;
            SceneData?.Roots.Add(node);
        }
    }

    internal void Remove(Component component) => _components.Remove(component);

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        var original = (GameObject)source;
        _tag = original._tag;
        _layer = original._layer;
        _isStatic = original._isStatic;
        ActiveSelf = original.ActiveSelf;
    }
}
