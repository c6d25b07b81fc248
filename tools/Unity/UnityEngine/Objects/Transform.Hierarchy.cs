using System;
using System.Collections;
using System.Collections.Generic;
using Glint.Host;

namespace UnityEngine;

/// <summary>Parents, children and their order; a transform without parent is a root of its scene.</summary>
public partial class Transform
{
    readonly List<Transform> _children = new();
    Transform _parent;

    public Transform parent
    {
        get => Alive()._parent;
        set => SetParent(value, true);
    }

    public Transform root
    {
        get
        {
            Transform node = Alive();
            while (node._parent is not null)
                node = node._parent;
            return node;
        }
    }

    public int childCount => Alive()._children.Count;

    public int hierarchyCount
    {
        get
        {
            int count = 0;
            foreach (Transform _ in root.Descendants())
                count++;
            return count;
        }
    }

    internal IReadOnlyList<Transform> Children => _children;

    List<Transform> Siblings => _parent is null ? Owner.SceneData?.Roots : _parent._children;

    public void SetParent(Transform p) => SetParent(p, true);

    public void SetParent(Transform parent, bool worldPositionStays)
    {
        if (Refuses(_parent) || Refuses(parent))
            return;
        if (!Reparent(parent, worldPositionStays))
            return;
        if (!Engine.IsPlaying && Owner.SceneData is { } scene && (Owner.Flags & HideFlags.DontSaveInEditor) == 0)
            scene.IsDirty = true;
        Activation.Refresh(Owner);
    }

    public void DetachChildren()
    {
        foreach (Transform child in Alive()._children.ToArray())
            child.SetParent(null, true);
    }

    public Transform GetChild(int index)
    {
        if (index < 0 || index >= childCount)
            throw new UnityException("Transform child out of bounds");
        return _children[index];
    }

    /// <summary>A direct child by name, or a descendant by a path of names with slashes.</summary>
    public Transform Find(string n)
    {
        if (n is null)
            throw new ArgumentNullException(nameof(n));
        Transform node = Alive();
        foreach (string step in n.Split('/'))
        {
            node = node._children.Find(child => child.Name == step);
            if (node is null)
                return null;
        }
        return node;
    }

    public bool IsChildOf(Transform parent)
    {
        for (Transform node = Alive(); node is not null; node = node._parent)
        {
            if (ReferenceEquals(node, parent))
                return true;
        }
        return false;
    }

    public int GetSiblingIndex() => Alive().Siblings?.IndexOf(this) ?? 0;

    public void SetSiblingIndex(int index)
    {
        List<Transform> siblings = Alive().Siblings;
        if (siblings is null)
            return;
        siblings.Remove(this);
        siblings.Insert(Math.Clamp(index, 0, siblings.Count), this);
    }

    public void SetAsFirstSibling() => SetSiblingIndex(0);

    public void SetAsLastSibling() => SetSiblingIndex(int.MaxValue);

    public IEnumerator GetEnumerator()
    {
        for (int index = 0; index < childCount; index++)
            yield return _children[index];
    }

    /// <summary>This transform, then its descendants, parents before children.</summary>
    internal IEnumerable<Transform> Descendants()
    {
        yield return this;
        foreach (Transform child in _children)
        {
            foreach (Transform node in child.Descendants())
                yield return node;
        }
    }

    /// <summary>This transform, then its ancestors up to the root.</summary>
    internal IEnumerable<Transform> Ancestors()
    {
        for (Transform node = this; node is not null; node = node._parent)
            yield return node;
    }

    /// <summary>SetParent without the change of the active state; false if nothing changes.</summary>
    internal bool Reparent(Transform parent, bool worldPositionStays)
    {
        EnsureAlive();
        Transform target = IsNull(parent) ? null : parent;
        if (ReferenceEquals(target, _parent) || (target is not null && target.IsChildOf(this)))
            return false;

        Vector3 worldPosition = position;
        Quaternion worldRotation = rotation;
        Matrix4x4 worldScale = WithoutTranslation(localToWorldMatrix);
        Attach(target);
        if (worldPositionStays)
        {
            SetPositionAndRotation(worldPosition, worldRotation);
            KeepScale(worldScale);
        }
        MarkChanged();
        return true;
    }

    /// <summary>Removes the transform from its parent or scene, before it is destroyed or moved.</summary>
    internal void Detach()
    {
        Siblings?.Remove(this);
        _parent = null;
    }

    bool Refuses(Transform parent)
    {
        if (IsNull(parent) || !parent.Owner.IsDeactivating)
            return false;
        Debug.LogError($"Cannot set the parent of the GameObject '{Owner.Name}' while activating or deactivating "
            + $"the parent GameObject '{parent.Owner.Name}'.", this);
        return true;
    }

    void Attach(Transform target)
    {
        Detach();
        _parent = target;
        if (target is null)
        {
            Owner.SceneData?.Roots.Add(this);
            return;
        }
        target._children.Add(this);
        SceneData scene = target.Owner.SceneData;
        if (ReferenceEquals(scene, Owner.SceneData))
            return;
        foreach (Transform node in Descendants())
            node.Owner.SceneData = scene;
    }

    // The local scale closest to the previous world scale: the diagonal, since it cannot represent shear.
    void KeepScale(Matrix4x4 worldScale)
    {
        localScale = Vector3.one;
        Matrix4x4 relative = WithoutTranslation(localToWorldMatrix).inverse * worldScale;
        localScale = new Vector3(relative.m00, relative.m11, relative.m22);
    }
}
