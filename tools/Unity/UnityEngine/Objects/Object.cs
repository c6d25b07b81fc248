using Glint.Host;

namespace UnityEngine;

/// <summary>Base of everything with an instance id. A destroyed object equals null.</summary>
public partial class Object
{
    readonly int _instanceId;
    string _name = "";
    HideFlags _hideFlags;

    public Object() => _instanceId = ObjectRegistry.Add(this);

    public string name
    {
        get
        {
            EnsureAlive();
            return Name;
        }
        set
        {
            EnsureAlive();
            Name = value ?? "";
        }
    }

    public HideFlags hideFlags
    {
        get
        {
            EnsureAlive();
            return _hideFlags;
        }
        set
        {
            EnsureAlive();
            _hideFlags = value;
        }
    }

    internal bool IsDestroyed { get; private set; }

    /// <summary>Asset path of an object in a project file; null for objects made at run time.</summary>
    internal string AssetPath { get; set; }

    /// <summary>The object's id within its asset's file.</summary>
    internal long FileId { get; set; }

    /// <summary>How often it was marked as changed since its asset was last written.</summary>
    internal int DirtyCount { get; set; }

    internal bool IsDirty => DirtyCount > 0;

    internal virtual string Name
    {
        get => _name;
        set => _name = value;
    }

    internal HideFlags Flags => _hideFlags;

    public static implicit operator bool(Object exists) => !IsNull(exists);

    public static bool operator ==(Object x, Object y) => Same(x, y);

    public static bool operator !=(Object x, Object y) => !Same(x, y);

    public int GetInstanceID() => _instanceId;

    public override int GetHashCode() => _instanceId;

    public override bool Equals(object other) => other is null or Object && Same(this, other as Object);

    public override string ToString() => IsDestroyed ? "null" : $"{Name} ({GetType()})";

    internal static bool IsNull(Object item) => item is null || item.IsDestroyed;

    /// <summary>Called first by every member that Unity implements natively.</summary>
    internal void EnsureAlive()
    {
        if (IsDestroyed)
            throw new MissingReferenceException(
                $"The object of type '{GetType().FullName}' has been destroyed but you are still trying to access it.\n"
                + "Your script should either check if it is null or you should not destroy the object.");
    }

    /// <summary>Copies the serialized data of a built-in type; a clone starts from the defaults.</summary>
    internal virtual void CopyFrom(Object source, CloneMap map)
    {
        _name = source._name;
        _hideFlags = source._hideFlags;
    }

    /// <summary>Releases resources outside managed memory.</summary>
    internal virtual void OnDestroyed()
    {
    }

    internal void MarkDestroyed()
    {
        if (IsDestroyed)
            return;
        OnDestroyed();
        IsDestroyed = true;
        ObjectRegistry.Remove(this);
    }

    static bool Same(Object x, Object y)
    {
        if (IsNull(x))
            return IsNull(y);
        return ReferenceEquals(x, y);
    }
}
