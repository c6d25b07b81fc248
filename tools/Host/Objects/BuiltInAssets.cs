using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Unity's built-in assets, which are not in the project.</summary>
internal static class BuiltInAssets
{
    const string ResourceGuid = "0000000000000000e000000000000000", ExtraGuid = "0000000000000000f000000000000000";

    internal static bool IsOne(ObjectReference reference) => reference.Guid is ResourceGuid or ExtraGuid;

    /// <summary>Null for assets that the host leaves out: skyboxes, fonts, shaders.</summary>
    internal static Object Find(ObjectReference reference) => reference.Guid == ResourceGuid
        ? BuiltinMeshes.ByFileId(reference.FileId) : reference.FileId
            == BuiltinMaterial.FileId ? BuiltinMaterial.Get() : null;

    /// <summary>The guid of a path that means all built-in assets of a kind; null for a project's path.</summary>
    internal static string GuidOf(string assetPath) => assetPath switch
    {
        BuiltinMeshes.AssetPath => ResourceGuid,
        BuiltinMaterial.AssetPath => ExtraGuid,
        _ => null,
    };
}
