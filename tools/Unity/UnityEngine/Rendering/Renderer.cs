using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;

namespace UnityEngine;

public class Renderer : Component
{
    // A new renderer has one empty material slot.
    Material[] _materials = new Material[1];
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
            _enabled = value;
        }
    }

    /// <summary>Without effect in the host.</summary>
    public bool isVisible => false;

    /// <summary>Not drawn, though enabled. No file holds it.</summary>
    public bool forceRenderingOff { get; set; }

    public bool isPartOfStaticBatch
    {
        get
        {
            EnsureAlive();
            return StaticBatched;
        }
    }

    public Matrix4x4 localToWorldMatrix => transform.localToWorldMatrix;

    public Matrix4x4 worldToLocalMatrix => transform.worldToLocalMatrix;

    public Material sharedMaterial
    {
        get => Materials.FirstOrDefault();
        set => SetFirst(value);
    }

    public Material[] sharedMaterials
    {
        get => (Material[])Materials.Clone();
        set
        {
            EnsureAlive();
            _materials = (Material[])value.Clone();
        }
    }

    public Material material
    {
        get
        {
            if (sharedMaterial != null && sharedMaterial.InstanceOf != this)
                SetFirst(new Material(sharedMaterial) { InstanceOf = this });
            return sharedMaterial;
        }
        set => SetFirst(value);
    }

    /// <summary>World space, axis-aligned: the box around the rotated local box.</summary>
    public Bounds bounds
    {
        get
        {
            Bounds local = localBounds;
            Matrix4x4 matrix = localToWorldMatrix;
            Vector3 extents = local.extents;
            Vector3 reach = new(
                Math.Abs(matrix.m00) * extents.x + Math.Abs(matrix.m01) * extents.y + Math.Abs(matrix.m02) * extents.z,
                Math.Abs(matrix.m10) * extents.x + Math.Abs(matrix.m11) * extents.y + Math.Abs(matrix.m12) * extents.z,
                Math.Abs(matrix.m20) * extents.x + Math.Abs(matrix.m21) * extents.y + Math.Abs(matrix.m22) * extents.z);
            return new Bounds(matrix.MultiplyPoint3x4(local.center), reach * 2f);
        }
    }

    public Bounds localBounds => LocalBounds();

    public LODGroup LODGroup =>
        GetComponentsInParent<LODGroup>(true).FirstOrDefault(group => group.Holds(this));

    /// <summary>Set by the loader if the file says that the renderer was combined with others.</summary>
    internal bool StaticBatched { get; set; }

    Material[] Materials
    {
        get
        {
            EnsureAlive();
            return _materials;
        }
    }

    public void GetSharedMaterials(List<Material> m)
    {
        m.Clear();
        m.AddRange(Materials);
    }

    internal virtual Bounds LocalBounds() => default;

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        var original = (Renderer)source;
        _enabled = original._enabled;
        _materials = original._materials.Select(map.Of).ToArray();
        StaticBatched = original.StaticBatched;
    }

    void SetFirst(Material value)
    {
        Material[] materials = Materials;
        if (materials.Length == 0)
            _materials = new[] { value };
        else
            materials[0] = value;
    }
}
