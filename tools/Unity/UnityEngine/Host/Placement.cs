using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host;

/// <summary>Parent and transform of Instantiate's clone.</summary>
internal readonly struct Placement
{
    readonly Transform _parent;
    readonly bool _worldPositionStays;
    readonly SceneData _scene;
    readonly (Vector3 Position, Quaternion Rotation)? _pose;

    Placement(Transform parent, bool worldPositionStays, SceneData scene, (Vector3, Quaternion)? pose)
    {
        _parent = parent;
        _worldPositionStays = worldPositionStays;
        _scene = scene;
        _pose = pose;
    }

    internal static Placement AsIs => default;

    internal SceneData Scene => _scene ?? SceneRegistry.Active;

    internal static Placement In(Scene scene) => new(null, false, scene.Data, null);

    internal static Placement Under(Transform parent, bool worldPositionStays) =>
        new(parent, worldPositionStays, null, null);

    internal static Placement At(Vector3 position, Quaternion rotation, Transform parent) =>
        new(parent, false, null, (position, rotation));

    internal void Apply(Transform clone)
    {
        if (!Object.IsNull(_parent))
            clone.Reparent(_parent, _worldPositionStays);
        if (_pose is var (position, rotation))
            clone.SetPositionAndRotation(position, rotation);
    }
}
