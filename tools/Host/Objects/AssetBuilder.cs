using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Makes the objects of an asset file: meshes, materials (the name only), ScriptableObjects.</summary>
internal sealed class AssetBuilder
{
    readonly LoadedFile _file;
    readonly ScriptCatalog _scripts;
    readonly LoadWarnings _warnings;

    internal AssetBuilder(LoadedFile file, ScriptCatalog scripts, LoadWarnings warnings)
    {
        _file = file;
        _scripts = scripts;
        _warnings = warnings;
    }

    internal void Build(Links links)
    {
        foreach (ObjectRecord record in _file.Table.Records)
        {
            if (Make(record) is not Object made)
                continue;
            made.name = record.Fields.Text("m_Name");
            _file.Add(record, made);
        }
        foreach ((ObjectRecord record, Object made) in _file.Objects)
        {
            if (made is ScriptableObject)
                FieldReader.Fill(made, record, links);
        }
        foreach (Object made in _file.Objects.Values)
            Callbacks.AfterDeserialize(made);
        foreach (Object made in _file.Objects.Values)
        {
            if (made is ScriptableObject script)
                ObjectFactory.Awaken(script);
        }
    }

    Object Make(ObjectRecord record) => record.ClassId switch
    {
        ClassId.Mesh => MeshMaker.Make(new MeshRecord(record)),
        ClassId.Material => ObjectFactory.NewAsset<Material>(),
        ClassId.MonoBehaviour => _scripts.Find(record, typeof(ScriptableObject), _warnings) is Type type
            ? ObjectFactory.NewAsset(type)
            : null,
        _ => null,
    };
}
