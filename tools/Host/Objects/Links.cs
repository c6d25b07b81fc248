using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Resolves the references of one file: its own objects by id, others through the project's assets.</summary>
internal sealed class Links : ILinks
{
    readonly LoadedFile _file;
    readonly AssetLibrary _assets;
    readonly LoadWarnings _warnings;

    internal Links(LoadedFile file, AssetLibrary assets, LoadWarnings warnings)
    {
        _file = file;
        _assets = assets;
        _warnings = warnings;
    }

    public Object Resolve(ObjectReference reference, Type type, ObjectRecord holder, string path)
    {
        Object found = Find(reference, out string problem);
        if (problem is null && found is not null && !type.IsInstanceOfType(found))
            problem = $"a {found.GetType().Name}, where a {type.Name} is needed";
        if (problem is null)
            return found;
        _warnings.Add(holder,
            $"{path} refers to {problem}: the field is left empty, and what needs it may fail: assign it again");
        return typeof(ScriptableObject).IsAssignableFrom(type) ? Lost(type) : null;
    }

    // As in the editor: it equals null, and has a number.
    static Object Lost(Type type)
    {
        Object lost = ScriptableObject.CreateInstance(type);
        Object.DestroyImmediate(lost);
        return lost;
    }

    /// <summary>The mesh of a MeshFilter or SkinnedMeshRenderer; null if none is assigned.</summary>
    /// <param name="isTraced">
    /// True for a mesh that may be traced: it must exist, since the result depends on it.
    /// </param>
    /// <exception cref="Core.GlintException">A traced mesh is missing.</exception>
    internal Mesh Mesh(ObjectRecord holder, bool isTraced)
    {
        ObjectReference reference = holder.Fields.Reference("m_Mesh");
        if (!isTraced)
            return (Mesh)Resolve(reference, typeof(Mesh), holder, "m_Mesh");
        if (reference.IsNone)
            return null;
        Object found = Find(reference, out string problem);
        problem ??= found is null ? $"{reference}, which is not a mesh"
            : found is not UnityEngine.Mesh ? $"a {found.GetType().Name}, which is not a mesh"
            : null;
        return problem is null ? (Mesh)found : throw holder.Error($"refers to {problem}: restore the file, "
            + "or assign another mesh (an .asset or a built-in one)");
    }

    Object Find(ObjectReference reference, out string problem)
    {
        problem = null;
        if (reference.IsNone)
            return null;
        if (!reference.IsLocal)
            return _assets.Find(reference, out problem);
        ObjectRecord record = _file.Table.Find(reference.FileId);
        if (record is null && !_file.Table.IsSkipped(reference.FileId))
            problem = $"object &{reference.FileId}, which is not in the file";
        // Meshes of a scene or prefab itself: those that are used.
        if (record?.ClassId == ClassId.Mesh && _file.Find(record) is null)
        {
            Mesh made = MeshMaker.Make(new MeshRecord(record));
            made.name = record.Fields.Text("m_Name");
            _file.Add(record, made);
        }
        return record is null ? null : _file.Find(record);
    }
}
