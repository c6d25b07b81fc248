using System;
using System.Linq;
using Glint.Host;

namespace UnityEngine;

public struct LOD
{
    public float screenRelativeTransitionHeight;
    public float fadeTransitionWidth;
    public Renderer[] renderers;

    public LOD(float screenRelativeTransitionHeight, Renderer[] renderers)
    {
        this.screenRelativeTransitionHeight = screenRelativeTransitionHeight;
        fadeTransitionWidth = 0f;
        this.renderers = renderers;
    }
}

public class LODGroup : Component
{
    LOD[] _levels = Array.Empty<LOD>();
    bool _enabled = true;

    public int lodCount => Levels.Length;

    public float size { get; set; } = 1f;

    public Vector3 localReferencePoint { get; set; }

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

    LOD[] Levels
    {
        get
        {
            EnsureAlive();
            return _levels;
        }
    }

    public LOD[] GetLODs() => Levels.Select(level => Copy(level, level.renderers)).ToArray();

    public void SetLODs(LOD[] lods)
    {
        EnsureAlive();
        _levels = lods.Select(level => Copy(level, level.renderers)).ToArray();
    }

    internal bool Holds(Renderer renderer) =>
        Levels.Any(level => level.renderers is not null && Array.IndexOf(level.renderers, renderer) >= 0);

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        var original = (LODGroup)source;
        _enabled = original._enabled;
        size = original.size;
        localReferencePoint = original.localReferencePoint;
        _levels = original._levels.Select(level => Copy(level, level.renderers?.Select(map.Of).ToArray())).ToArray();
    }

    static LOD Copy(LOD level, Renderer[] renderers) =>
        new(level.screenRelativeTransitionHeight, renderers?.ToArray() ?? Array.Empty<Renderer>())
        {
            fadeTransitionWidth = level.fadeTransitionWidth,
        };
}
