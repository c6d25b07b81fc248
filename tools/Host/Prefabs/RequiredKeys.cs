using System.Linq;
using Glint.Core;

namespace Glint.Host;

/// <summary>
/// Keys that Unity writes in every object of a class. A truncated file lacks some, and with defaults in their place it
/// would load as a smaller scene.
/// </summary>
internal static class RequiredKeys
{
    /// <exception cref="GlintException">A key is missing.</exception>
    internal static void Check(ObjectRecord record)
    {
        if (Of(record.ClassId).FirstOrDefault(key => !record.Fields.Has(key)) is string lacking)
            throw record.Error($"has no {lacking}, the file has been cut short: restore the file");
    }

    static string[] Of(int classId) => classId switch
    {
        ClassId.GameObject => ["m_Component", "m_IsActive"],
        ClassId.Transform or ClassId.RectTransform =>
            ["m_GameObject", "m_LocalRotation", "m_LocalPosition", "m_LocalScale", "m_Children", "m_Father"],
        ClassId.MeshFilter => ["m_Mesh"],
        ClassId.MeshRenderer => ["m_Enabled"],
        ClassId.LodGroup => ["m_LODs", "m_Enabled"],
        ClassId.Mesh => ["m_SubMeshes", "m_IndexBuffer", "m_VertexData", "m_LocalAABB"],
        _ => [],
    };
}
