using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Makes the GameObjects of a scene or prefab. All objects are made before their fields are read, since these refer to
/// each other.
/// </summary>
internal sealed class ObjectBuilder
{
    readonly LoadedFile _file;
    readonly Scene _scene;
    readonly ScriptCatalog _scripts;
    readonly LoadWarnings _warnings;

    /// <param name="scene">The objects' scene; default for a prefab.</param>
    internal ObjectBuilder(LoadedFile file, Scene scene, ScriptCatalog scripts, LoadWarnings warnings)
    {
        _file = file;
        _scene = scene;
        _scripts = scripts;
        _warnings = warnings;
    }

    internal IReadOnlyList<GameObject> Build(IReadOnlyList<HierarchyNode> roots, Links links)
    {
        List<GameObject> made = new();
        Stack<(HierarchyNode Node, Transform Parent)> open =
            new(roots.Reverse().Select(root => (root, (Transform)null)));
        while (open.TryPop(out (HierarchyNode Node, Transform Parent) next))
        {
            GameObject item = Make(next.Node, next.Parent);
            if (next.Parent is null)
                made.Add(item);
            for (int i = next.Node.Children.Count - 1; i >= 0; i--)
                open.Push((next.Node.Children[i], item.transform));
        }
        // Meshes of the file are made when a MeshFilter refers to them, of which those without an enabled renderer may
        // lack theirs.
        var components = _file.Objects.Where(each => each.Value is Component)
            .OrderBy(each => each.Value is MeshFilter).ToArray();
        foreach ((ObjectRecord record, Object target) in components)
            ComponentReader.Fill((Component)target, record, links);
        foreach (Object target in _file.Objects.Values)
            Callbacks.AfterDeserialize(target);
        return made;
    }

    GameObject Make(HierarchyNode node, Transform parent)
    {
        FieldMap fields = node.GameObject.Fields;
        GameObject item = ObjectFactory.NewGameObject(fields.Text("m_Name"), _scene);
        _file.Add(node.GameObject, item);
        long layer = fields.Integer("m_Layer");
        item.layer = layer is >= 0 and < 32
            ? (int)layer
            : throw fields.Wrong("m_Layer", "a layer from 0 to 31", layer.ToString());
        SetTag(item, node.GameObject);
        item.isStatic = fields.Integer("m_StaticEditorFlags") != 0;
        item.ActiveSelf = fields.Flag("m_IsActive", true);

        Attach(item, typeof(Transform), node.Transform);
        item.transform.Reparent(parent, false);
        ComponentReader.Fill(item.transform, node.Transform.Fields);
        foreach (ObjectRecord record in node.Components)
        {
            if (TypeOf(record) is Type type)
                Attach(item, type, record);
            else if (record.ClassId == ClassId.Terrain)
                _warnings.Add(record, "terrains are not traced: make a mesh of it to include it");
        }
        foreach (ObjectRecord record in node.Components)
            RequireOthers(item, record);
        return item;
    }

    // The editor adds required components together with the script, so only a damaged or hand-written file lacks one.
    void RequireOthers(GameObject item, ObjectRecord record)
    {
        if (_file.Find(record) is MonoBehaviour script
            && ComponentAdder.Requirements(script.GetType())
                .FirstOrDefault(type => !type.IsAbstract && item.GetComponent(type) is null) is Type lacking)
            throw new GlintException($"{record.File}: '{record.Owner}': "
                + $"{script.GetType().Name} needs a {lacking.Name} on the same object: add one");
    }

    void Attach(GameObject item, Type type, ObjectRecord record) => _file.Add(record, ObjectFactory.Attach(item, type));

    void SetTag(GameObject item, ObjectRecord record)
    {
        string tag = record.Fields.Text("m_TagString", item.tag);
        try
        {
            item.tag = tag;
        }
        catch (UnityException)
        {
            _warnings.Add(record, $"has the tag '{tag}', which the project does not define: it is left untagged, "
                + "add the tag to ProjectSettings/TagManager.asset");
        }
    }

    Type TypeOf(ObjectRecord record) => record.ClassId switch
    {
        ClassId.Camera => typeof(Camera),
        ClassId.MeshFilter => typeof(MeshFilter),
        ClassId.MeshRenderer => typeof(MeshRenderer),
        ClassId.SkinnedMeshRenderer => typeof(SkinnedMeshRenderer),
        ClassId.LodGroup => typeof(LODGroup),
        ClassId.MonoBehaviour => _scripts.Find(record, typeof(MonoBehaviour), _warnings),
        _ => null,
    };
}
