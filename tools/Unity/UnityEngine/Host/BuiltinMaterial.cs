using UnityEngine;

namespace Glint.Host;

/// <summary>The material that the editor gives to new objects.</summary>
internal static class BuiltinMaterial
{
    internal const string AssetPath = "Resources/unity_builtin_extra";
    internal const string ResourceName = "Default-Material.mat";
    internal const long FileId = 10303;

    static Material _material;

    internal static Material Get()
    {
        if (_material == null)
        {
            _material = ObjectFactory.NewAsset<Material>();
            _material.name = "Default-Material";
            _material.AssetPath = AssetPath;
            _material.FileId = FileId;
        }
        return _material;
    }
}
