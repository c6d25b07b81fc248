using Glint.Host;

namespace UnityEngine;

/// <summary>Velocities that scripts give it: the host has no physics, and moves nothing.</summary>
public class Rigidbody : Component
{
    Vector3 _linearVelocity, _angularVelocity, _centerOfMass;

    public Vector3 linearVelocity
    {
        get
        {
            EnsureAlive();
            return _linearVelocity;
        }
        set
        {
            EnsureAlive();
            _linearVelocity = value;
        }
    }

    public Vector3 angularVelocity
    {
        get
        {
            EnsureAlive();
            return _angularVelocity;
        }
        set
        {
            EnsureAlive();
            _angularVelocity = value;
        }
    }

    /// <summary>In the object's coordinates.</summary>
    public Vector3 centerOfMass
    {
        get
        {
            EnsureAlive();
            return _centerOfMass;
        }
        set
        {
            EnsureAlive();
            _centerOfMass = value;
        }
    }

    public Vector3 worldCenterOfMass => transform.position + transform.rotation * centerOfMass;

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        var body = (Rigidbody)source;
        (_linearVelocity, _angularVelocity, _centerOfMass) =
            (body._linearVelocity, body._angularVelocity, body._centerOfMass);
    }
}
