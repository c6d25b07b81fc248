using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Writes GameObjects and their components with all keys of Unity 6000.0. Keys that the host does not know get Unity's
/// defaults.
/// </summary>
internal sealed class ComponentWriter
{
    // All of the editor's static flags; GameObject.isStatic means all of them.
    const int AllStatic = int.MaxValue;

    readonly YamlWriter _yaml;
    readonly ReferenceText _references;
    readonly IReadOnlyDictionary<Object, long> _ids;
    readonly ScriptCatalog _scripts;

    internal ComponentWriter(YamlWriter yaml, ReferenceText references,
        IReadOnlyDictionary<Object, long> ids, ScriptCatalog scripts)
    {
        _yaml = yaml;
        _references = references;
        _ids = ids;
        _scripts = scripts;
    }

    /// <param name="name">Name of the object in the file.</param>
    internal void Write(GameObject item, string name)
    {
        Begin(item, ClassId.GameObject, "GameObject");
        _yaml.Field("serializedVersion", 6);
        _yaml.List("m_Component", item.Components.Count,
            index => _yaml.Field("component", Own(item.Components[index])));
        _yaml.Field("m_Layer", item.layer);
        _yaml.Field("m_Name", ScalarText.Of(name));
        _yaml.Field("m_TagString", ScalarText.Of(item.tag));
        _yaml.Field("m_Icon", ReferenceText.None);
        _yaml.Field("m_NavMeshLayer", 0);
        _yaml.Field("m_StaticEditorFlags", item.isStatic ? AllStatic : 0);
        _yaml.Field("m_IsActive", item.activeSelf);
    }

    /// <exception cref="UnityException">Only Unity writes a component of this kind.</exception>
    internal void Write(Component component, bool isRoot)
    {
        switch (component)
        {
            case Transform transform:
                BeginComponent(component, ClassId.Transform, "Transform");
                Write(transform, isRoot);
                break;
            case MeshFilter filter:
                BeginComponent(component, ClassId.MeshFilter, "MeshFilter");
                _yaml.Field("m_Mesh", _references.Of(filter.sharedMesh, filter, "m_Mesh"));
                break;
            case MeshRenderer renderer:
                BeginComponent(component, ClassId.MeshRenderer, "MeshRenderer");
                Write(renderer);
                break;
            case Camera camera:
                BeginComponent(component, ClassId.Camera, "Camera");
                Write(camera);
                break;
            case MonoBehaviour script:
                BeginComponent(component, ClassId.MonoBehaviour, "MonoBehaviour");
                Script(_yaml, script, script.enabled, _scripts.GuidOf(script.GetType()), "");
                FieldWriter.Write(_yaml, _references, script);
                break;
            default:
                throw new UnityException($"{component.GetType().Name} of '{component.name}' is not written outside of "
                    + "Unity: leave it out, or save the prefab in Unity");
        }
    }

    /// <summary>Keys before the fields of a script.</summary>
    internal static void Script(YamlWriter yaml, Object script, bool isEnabled, string guid, string name)
    {
        yaml.Field("m_Enabled", isEnabled);
        yaml.Field("m_EditorHideFlags", 0);
        yaml.Field("m_Script", ReferenceText.Script(guid));
        yaml.Field("m_Name", ScalarText.Of(name));
        yaml.Field("m_EditorClassIdentifier", "");
    }

    /// <summary>Keys that begin every object.</summary>
    internal static void Head(YamlWriter yaml, Object item)
    {
        yaml.Field("m_ObjectHideFlags", (int)item.hideFlags);
        yaml.Field("m_CorrespondingSourceObject", ReferenceText.None);
        yaml.Field("m_PrefabInstance", ReferenceText.None);
        yaml.Field("m_PrefabAsset", ReferenceText.None);
    }

    void Begin(Object item, int classId, string typeName)
    {
        _yaml.Object(classId, _ids[item], typeName);
        Head(_yaml, item);
    }

    void BeginComponent(Component component, int classId, string typeName)
    {
        Begin(component, classId, typeName);
        _yaml.Field("m_GameObject", Own(component.gameObject));
    }

    void Write(Transform transform, bool isRoot)
    {
        _yaml.Field("serializedVersion", 2);
        _yaml.Field("m_LocalRotation", EngineValueWriter.Line(transform.localRotation));
        _yaml.Field("m_LocalPosition", EngineValueWriter.Line(transform.localPosition));
        _yaml.Field("m_LocalScale", EngineValueWriter.Line(transform.localScale));
        _yaml.Field("m_ConstrainProportionsScale", 0);
        _yaml.List("m_Children", transform.childCount, index => _yaml.Item(Own(transform.GetChild(index))));
        _yaml.Field("m_Father", isRoot ? ReferenceText.None : Own(transform.parent));
        _yaml.Field("m_LocalEulerAnglesHint", EngineValueWriter.Line(Vector3.zero));
    }

    void Write(MeshRenderer renderer)
    {
        _yaml.Field("m_Enabled", renderer.enabled);
        Defaults("m_CastShadows: 1", "m_ReceiveShadows: 1", "m_DynamicOccludee: 1", "m_StaticShadowCaster: 0",
            "m_MotionVectors: 1", "m_LightProbeUsage: 1",
            "m_ReflectionProbeUsage: 1", "m_RayTracingMode: 2", "m_RayTraceProcedural: 0",
            "m_RenderingLayerMask: 1", "m_RendererPriority: 0");
        Material[] materials = renderer.sharedMaterials;
        _yaml.List("m_Materials", materials.Length,
            index => _yaml.Item(_references.Of(materials[index], renderer, $"m_Materials[{index}]")));
        _yaml.Map("m_StaticBatchInfo", () => Defaults("firstSubMesh: 0", "subMeshCount: 0"));
        Defaults("m_StaticBatchRoot: {fileID: 0}", "m_ProbeAnchor: {fileID: 0}",
            "m_LightProbeVolumeOverride: {fileID: 0}", "m_ScaleInLightmap: 1", "m_ReceiveGI: 1",
            "m_PreserveUVs: 0", "m_IgnoreNormalsForChartDetection: 0", "m_ImportantGI: 0",
            "m_StitchLightmapSeams: 1", "m_SelectedEditorRenderState: 3",
            "m_MinimumChartSize: 4", "m_AutoUVMaxDistance: 0.5", "m_AutoUVMaxAngle: 89",
            "m_LightmapParameters: {fileID: 0}", "m_SortingLayerID: 0",
            "m_SortingLayer: 0", "m_SortingOrder: 0", "m_AdditionalVertexStreams: {fileID: 0}",
            "m_RayTracingAccelStructBuildFlagsOverride: 0",
            "m_RayTracingAccelStructBuildFlags: 1", "m_SmallMeshCulling: 1");
    }

    void Write(Camera camera)
    {
        _yaml.Field("m_Enabled", camera.enabled);
        Defaults("serializedVersion: 2", "m_ClearFlags: 1",
            "m_BackGroundColor: {r: 0.19215687, g: 0.3019608, b: 0.4745098, a: 0}", "m_projectionMatrixMode: 1",
            "m_GateFitMode: 2", "m_FOVAxisMode: 0", "m_Iso: 200", "m_ShutterSpeed: 0.005",
            "m_Aperture: 16", "m_FocusDistance: 10", "m_FocalLength: 50",
            "m_BladeCount: 5", "m_Curvature: {x: 2, y: 11}", "m_BarrelClipping: 0.25", "m_Anamorphism: 0",
            "m_SensorSize: {x: 36, y: 24}", "m_LensShift: {x: 0, y: 0}");
        _yaml.Map("m_NormalizedViewPortRect", () =>
        {
            Defaults("serializedVersion: 2");
            _yaml.Field("x", ScalarText.Of(camera.rect.x));
            _yaml.Field("y", ScalarText.Of(camera.rect.y));
            _yaml.Field("width", ScalarText.Of(camera.rect.width));
            _yaml.Field("height", ScalarText.Of(camera.rect.height));
        });
        _yaml.Field("near clip plane", ScalarText.Of(camera.nearClipPlane));
        _yaml.Field("far clip plane", ScalarText.Of(camera.farClipPlane));
        _yaml.Field("field of view", ScalarText.Of(camera.fieldOfView));
        _yaml.Field("orthographic", camera.orthographic);
        _yaml.Field("orthographic size", ScalarText.Of(camera.orthographicSize));
        _yaml.Field("m_Depth", ScalarText.Of(camera.depth));
        _yaml.Map("m_CullingMask", () =>
        {
            Defaults("serializedVersion: 2");
            _yaml.Field("m_Bits", (uint)camera.cullingMask);
        });
        Defaults("m_RenderingPath: -1", "m_TargetTexture: {fileID: 0}", "m_TargetDisplay: 0", "m_TargetEye: 3",
            "m_HDR: 1", "m_AllowMSAA: 1", "m_AllowDynamicResolution: 0",
            "m_ForceIntoRT: 0", "m_OcclusionCulling: 1", "m_StereoConvergence: 10", "m_StereoSeparation: 0.022");
    }

    void Defaults(params string[] lines)
    {
        foreach (string line in lines)
            _yaml.Item(line);
    }

    string Own(Object item) => $"{{fileID: {_ids[item]}}}";
}
