using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>What comes with Unity instead of lying in the project.</summary>
internal static class BuiltInAssets
{
    const string ExtraGuid = "0000000000000000e000000000000000", ResourceGuid = "0000000000000000f000000000000000";
    const long DefaultMaterial = 10303;

    static Material _defaultMaterial;

    internal static bool IsOne(ObjectReference reference) => reference.Guid is ExtraGuid or ResourceGuid;

    /// <summary>Null for what the host leaves out: skyboxes, fonts, shaders.</summary>
    internal static Object Find(ObjectReference reference) => reference.Guid == ExtraGuid
        ? BuiltinMeshes.ByFileId(reference.FileId) : reference.FileId == DefaultMaterial ? Default() : null;

    static Material Default()
    {
        if (_defaultMaterial == null)
        {
            _defaultMaterial = ObjectFactory.NewAsset<Material>();
            _defaultMaterial.name = "Default-Material";
        }
        return _defaultMaterial;
    }
}
