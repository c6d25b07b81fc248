using System.Linq;

namespace Glint.Host.Tests;

/// <summary>Writes minimal scenes and prefabs in Unity's format.</summary>
public static class UnityText
{
    public const string Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
    public const string CubeMesh = "{fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}";

    /// <summary>Objects, and the list of roots at the end of a scene.</summary>
    public static string Scene(string objects, params long[] roots) =>
        Header + objects + "--- !u!1660057539 &9223372036854775807\nSceneRoots:\n  m_ObjectHideFlags: 0\n  m_Roots:"
        + (roots.Length == 0 ? " []\n" : "\n" + string.Concat(roots.Select(root => $"  - {{fileID: {root}}}\n")));

    public static string Prefab(string objects) => Header + objects;

    /// <summary>A GameObject and its Transform, whose id is greater by one.</summary>
    public static string Object(long id, string name, long father = 0, long[] children = null, string components = "",
        string fields = "", string position = "{x: 0, y: 0, z: 0}") =>
        $"""
        --- !u!1 &{id}
        GameObject:
          serializedVersion: 6
          m_Component:
          - component: {Reference(id + 1)}
        {components}  m_Layer: 0
          m_Name: {name}
          m_TagString: Untagged
          m_StaticEditorFlags: 0
          m_IsActive: 1
        {fields}--- !u!4 &{id + 1}
        Transform:
          m_GameObject: {Reference(id)}
          serializedVersion: 2
          m_LocalRotation: {Vector("0", "0", "0", "1")}
          m_LocalPosition: {position}
          m_LocalScale: {Vector("1", "1", "1")}
          m_Children: {(children is null ? "[]" : "\n  - " + string.Join("\n  - ", children.Select(Reference)))}
          m_Father: {Reference(father)}

        """;

    public static string Component(params long[] ids) =>
        string.Concat(ids.Select(id => $"  - component: {Reference(id)}\n"));

    public static string MeshFilter(long id, long owner, string mesh = CubeMesh) =>
        $"--- !u!33 &{id}\nMeshFilter:\n  m_GameObject: {Reference(owner)}\n  m_Mesh: {mesh}\n";

    public static string MeshRenderer(long id, long owner, string fields = "  m_Enabled: 1\n  m_Materials: []\n") =>
        $"--- !u!23 &{id}\nMeshRenderer:\n  m_GameObject: {Reference(owner)}\n{fields}";

    public static string Script(long id, long owner, int guid, string fields) =>
        $"--- !u!114 &{id}\nMonoBehaviour:\n  m_GameObject: {Reference(owner)}\n  m_Enabled: 1\n"
        + $"  m_Script: {Asset(11500000, guid)}\n  m_Name: \n{fields}";

    public static string Instance(long id, int prefab, long father = 0, string modifications = " []\n",
        string removedComponents = " []\n", string removedObjects = " []\n", string addedObjects = " []\n",
        string addedComponents = " []\n") =>
        $"--- !u!1001 &{id}\nPrefabInstance:\n  m_ObjectHideFlags: 0\n  serializedVersion: 2\n  m_Modification:\n"
        + $"    serializedVersion: 3\n    m_TransformParent: {Reference(father)}\n"
        + $"    m_Modifications:{modifications}    m_RemovedComponents:{removedComponents}    "
        + $"m_RemovedGameObjects:{removedObjects}    m_AddedGameObjects:{addedObjects}    "
        + $"m_AddedComponents:{addedComponents}"
        + $"  m_SourcePrefab: {Asset(100100000, prefab)}\n";

    public static string Change(long target, int prefab, string path, string value, string reference = "{fileID: 0}") =>
        $"    - target: {Asset(target, prefab)}\n      propertyPath: {path}\n      value: {value}\n"
        + $"      objectReference: {reference}\n";

    public static string Added(long target, int prefab, long added, int index = -1) =>
        $"    - targetCorrespondingSourceObject: {Asset(target, prefab)}\n      insertIndex: {index}\n"
        + $"      addedObject: {Reference(added)}\n";

    public static string StandIn(int classId, long id, long source, int prefab, long instance) =>
        $"--- !u!{classId} &{id} stripped\nTransform:\n  m_CorrespondingSourceObject: {Asset(source, prefab)}\n"
        + $"  m_PrefabInstance: {Reference(instance)}\n  m_PrefabAsset: {Reference(0)}\n";

    public static string Reference(long id) => $"{{fileID: {id}}}";

    public static string Asset(long id, int guid, int type = 3) =>
        $"{{fileID: {id}, guid: {TemporaryProject.Guid(guid)}, type: {type}}}";

    static string Vector(string x, string y, string z) => $"{{x: {x}, y: {y}, z: {z}}}";

    static string Vector(string x, string y, string z, string w) => $"{{x: {x}, y: {y}, z: {z}, w: {w}}}";
}
