using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Host;

/// <summary>Reads the fields of the engine's own components.</summary>
internal static class ComponentReader
{
    internal static void Fill(Component target, ObjectRecord record, Links links)
    {
        switch (target)
        {
            case Camera camera:
                Fill(camera, record.Fields);
                break;
            case MeshFilter filter:
                filter.sharedMesh = links.Mesh(record, IsShown(filter));
                break;
            case MeshRenderer renderer:
                Fill(renderer, record, links);
                break;
            case SkinnedMeshRenderer skinned:
                Fill(skinned, record, links);
                skinned.sharedMesh = links.Mesh(record, isTraced: false);
                break;
            case LODGroup group:
                Fill(group, record, links);
                break;
            case MonoBehaviour script:
                script.EnabledSelf = record.Fields.Flag("m_Enabled", true);
                FieldReader.Fill(script, record, links);
                break;
        }
    }

    // Prefabs are in no scene, so that each parent is asked.
    static bool IsShown(MeshFilter filter)
    {
        for (Transform at = filter.transform; at is not null; at = at.parent)
        {
            if (!at.gameObject.activeSelf)
                return false;
        }
        return filter.TryGetComponent(out MeshRenderer renderer) && renderer.enabled;
    }

    internal static void Fill(Transform target, FieldMap fields)
    {
        target.Load(
            EngineValues.Vector(fields.Map("m_LocalPosition")), EngineValues.Rotation(fields.Map("m_LocalRotation")),
            EngineValues.Vector(fields.Map("m_LocalScale"), Vector3.one));
    }

    static void Fill(Camera camera, FieldMap fields)
    {
        camera.EnabledSelf = fields.Flag("m_Enabled", true);
        camera.fieldOfView = fields.Number("field of view", camera.fieldOfView);
        camera.nearClipPlane = fields.Number("near clip plane", camera.nearClipPlane);
        camera.farClipPlane = fields.Number("far clip plane", camera.farClipPlane);
        camera.orthographic = fields.Flag("orthographic", false);
        camera.orthographicSize = fields.Number("orthographic size", camera.orthographicSize);
        camera.depth = fields.Number("m_Depth");
        camera.cullingMask = fields.Map("m_CullingMask").Bits("m_Bits", -1);
        camera.rect = EngineValues.Rect(fields.Map("m_NormalizedViewPortRect"), camera.rect);
    }

    static void Fill(Renderer renderer, ObjectRecord record, Links links)
    {
        renderer.enabled = record.Fields.Flag("m_Enabled", true);
        renderer.StaticBatched = record.Fields.Map("m_StaticBatchInfo").Integer("subMeshCount") > 0;
        renderer.sharedMaterials = record.Fields.References("m_Materials")
            .Select((material, index) =>
                (Material)links.Resolve(material, typeof(Material), record, $"m_Materials[{index}]")).ToArray();
    }

    static void Fill(LODGroup group, ObjectRecord record, Links links)
    {
        FieldMap fields = record.Fields;
        group.enabled = fields.Flag("m_Enabled", true);
        group.size = fields.Number("m_Size", 1f);
        group.localReferencePoint = EngineValues.Vector(fields.Map("m_LocalReferencePoint"));
        IReadOnlyList<FieldMap> levels = fields.Maps("m_LODs");
        group.SetLODs(levels.Select(level =>
            new LOD(level.Number("screenRelativeHeight"), Renderers(level, record, links))
            {
                fadeTransitionWidth = level.Number("fadeTransitionWidth"),
            }).ToArray());
    }

    static Renderer[] Renderers(FieldMap level, ObjectRecord record, Links links) => level.Maps("renderers")
        .Select(entry => (Renderer)links.Resolve(entry.Reference("renderer"), typeof(Renderer), record, "m_LODs"))
        .Where(renderer => renderer is not null).ToArray();
}
