using System;
using System.Collections;
using Glint.Host;

namespace UnityEngine;

public enum Space
{
    World,
    Self,
}

/// <summary>Position, rotation and scale relative to the parent; world values are calculated on request.</summary>
public partial class Transform : Component, IEnumerable
{
    Vector3 _localPosition = Vector3.zero;
    Quaternion _localRotation = Quaternion.identity;
    Vector3 _localScale = Vector3.one;

    protected Transform()
    {
    }

    public Vector3 localPosition
    {
        get => Alive()._localPosition;
        set
        {
            if (!Accepts("localPosition", value))
                return;
            _localPosition = value;
            MarkChanged();
        }
    }

    public Quaternion localRotation
    {
        get => Alive()._localRotation;
        set
        {
            if (!Accepts("localRotation", value))
                return;
            _localRotation = value.normalized;
            MarkChanged();
        }
    }

    public Vector3 localEulerAngles
    {
        get => localRotation.eulerAngles;
        set => localRotation = Quaternion.Euler(value);
    }

    public Vector3 localScale
    {
        get => Alive()._localScale;
        set
        {
            if (!Accepts("localScale", value))
                return;
            _localScale = value;
            MarkChanged();
        }
    }

    public Vector3 position
    {
        get => _parent is null ? Alive()._localPosition : Alive()._parent.TransformPoint(_localPosition);
        set
        {
            if (Accepts("position", value))
                localPosition = _parent is null ? value : _parent.InverseTransformPoint(value);
        }
    }

    /// <summary>A mirrored ancestor mirrors the rotations below it, so the signs of its scale are included.</summary>
    public Quaternion rotation
    {
        get
        {
            Quaternion result = Alive()._localRotation;
            for (Transform node = _parent; node is not null; node = node._parent)
                result = node._localRotation * Mirrored(result, node._localScale);
            return result;
        }
        set
        {
            if (Accepts("rotation", value))
                localRotation = _parent is null ? value : _parent.IntoLocal(value);
        }
    }

    public Vector3 eulerAngles
    {
        get => rotation.eulerAngles;
        set => rotation = Quaternion.Euler(value);
    }

    public Vector3 right
    {
        get => rotation * Vector3.right;
        set => rotation = Quaternion.FromToRotation(Vector3.right, value);
    }

    public Vector3 up
    {
        get => rotation * Vector3.up;
        set => rotation = Quaternion.FromToRotation(Vector3.up, value);
    }

    public Vector3 forward
    {
        get => rotation * Vector3.forward;
        set => rotation = Quaternion.LookRotation(value);
    }

    /// <summary>The world matrix's scale along the rotated axes, without shear.</summary>
    public Vector3 lossyScale
    {
        get
        {
            Matrix4x4 scale = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * WithoutTranslation(localToWorldMatrix);
            return new Vector3(scale.m00, scale.m11, scale.m22);
        }
    }

    public Matrix4x4 localToWorldMatrix
    {
        get
        {
            Matrix4x4 local = Matrix4x4.TRS(Alive()._localPosition, _localRotation, _localScale);
            return _parent is null ? local : _parent.localToWorldMatrix * local;
        }
    }

    public Matrix4x4 worldToLocalMatrix => localToWorldMatrix.inverse;

    public bool hasChanged { get; set; } = true;

    public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
    {
        this.position = position;
        this.rotation = rotation;
    }

    public void SetLocalPositionAndRotation(Vector3 localPosition, Quaternion localRotation)
    {
        this.localPosition = localPosition;
        this.localRotation = localRotation;
    }

    public void GetPositionAndRotation(out Vector3 position, out Quaternion rotation)
    {
        position = this.position;
        rotation = this.rotation;
    }

    public void GetLocalPositionAndRotation(out Vector3 localPosition, out Quaternion localRotation)
    {
        localPosition = this.localPosition;
        localRotation = this.localRotation;
    }

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        var original = (Transform)source;
        _localPosition = original._localPosition;
        _localRotation = original._localRotation;
        _localScale = original._localScale;
    }

    static Matrix4x4 WithoutTranslation(Matrix4x4 matrix)
    {
        matrix.SetColumn(3, new Vector4(0f, 0f, 0f, 1f));
        return matrix;
    }

    // S R S for the diagonal matrix S of the scale's signs: again a rotation, about the mirrored axis.
    static Quaternion Mirrored(Quaternion rotation, Vector3 scale)
    {
        float x = MathF.CopySign(1f, scale.x), y = MathF.CopySign(1f, scale.y), z = MathF.CopySign(1f, scale.z);
        return new Quaternion(rotation.x * y * z, rotation.y * z * x, rotation.z * x * y, rotation.w);
    }

    Quaternion IntoLocal(Quaternion world)
    {
        Quaternion below = _parent is null ? world : _parent.IntoLocal(world);
        return Mirrored(Quaternion.Inverse(_localRotation) * below, _localScale);
    }

    Transform Alive()
    {
        EnsureAlive();
        return this;
    }

    void MarkChanged()
    {
        hasChanged = true;
        foreach (Transform child in _children)
            child.MarkChanged();
    }
}
