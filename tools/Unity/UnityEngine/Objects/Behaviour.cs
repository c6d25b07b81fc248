using Glint.Host;

namespace UnityEngine;

public class Behaviour : Component
{
    bool _enabled = true;

    public bool enabled
    {
        get
        {
            EnsureAlive();
            return _enabled;
        }
        set
        {
            EnsureAlive();
            if (_enabled == value)
                return;
            _enabled = value;
            OnEnabledChanged();
        }
    }

    public bool isActiveAndEnabled
    {
        get
        {
            EnsureAlive();
            return _enabled && gameObject.activeInHierarchy;
        }
    }

    /// <summary>The serialized value, set by the loader before the object wakes.</summary>
    internal bool EnabledSelf
    {
        get => _enabled;
        set => _enabled = value;
    }

    internal virtual void OnEnabledChanged()
    {
    }

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        _enabled = ((Behaviour)source)._enabled;
    }
}
