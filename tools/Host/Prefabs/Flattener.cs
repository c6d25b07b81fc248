using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Host;

/// <summary>Turns a file with prefab instances into one table of objects without instances.</summary>
internal sealed class Flattener
{
    // Deeper than any real prefab; the limit prevents a stack overflow.
    const int MaxDepth = 100;

    readonly ProjectFiles _files;
    readonly Dictionary<string, ObjectTable> _prefabs = new();
    readonly List<string> _open = new();

    internal Flattener(ProjectFiles files) => _files = files;

    /// <summary>Table of a scene or an asset; read from the file at each call.</summary>
    internal ObjectTable Read(string assetPath)
    {
        if (_open.Contains(assetPath))
        {
            string chain =
                string.Join(" -> ", _open.SkipWhile(path => path != assetPath).Append(assetPath).Select(_files.Shown));
            throw new GlintException($"{_files.Shown(assetPath)}: the prefab holds itself: {chain}: "
                + "remove one of these instances");
        }
        if (_open.Count > MaxDepth)
            throw new GlintException($"{_files.Shown(_open[0])}: its prefabs lie more than {MaxDepth} deep in each "
                + $"other, down to {_files.Shown(assetPath)}: flatten them");
        _open.Add(assetPath);
        try
        {
            return Flatten(_files.ReadObjects(assetPath), _files.Guids.GuidOf(assetPath));
        }
        finally
        {
            _open.RemoveAt(_open.Count - 1);
        }
    }

    /// <summary>Table of a prefab. It is cached and must not be changed.</summary>
    internal ObjectTable Prefab(string assetPath)
    {
        if (_prefabs.TryGetValue(assetPath, out ObjectTable table))
            return table;
        table = Read(assetPath);
        // Checked here, where objects still have the ids of their own file, for messages.
        IReadOnlyList<HierarchyNode> roots = Hierarchy.Read(table, isScene: false);
        if (roots.Count != 1)
            throw new GlintException($"{table.ShownPath}: has {roots.Count} root objects, "
                + "and a prefab has one: restore the file");
        table.Root = roots[0].Transform;
        _prefabs.Add(assetPath, table);
        return table;
    }

    /// <summary>Discards all prefabs, since a changed one may be part of others.</summary>
    internal void ForgetPrefabs() => _prefabs.Clear();

    ObjectTable Flatten(UnityFile file, string guid)
    {
        ObjectTable table = new(file.ShownPath, guid);
        foreach (UnityDocument document in file.Documents)
        {
            if (document.IsStripped || document.ClassId == ClassId.PrefabInstance)
                continue;
            if (!ClassId.IsKnown(document.ClassId))
            {
                table.AddSkipped(document.Id);
                continue;
            }
            ObjectRecord record =
                new(file.ShownPath, document.ClassId, document.TypeName, document.Id, document.Fields);
            RequiredKeys.Check(record);
            table.Add(record);
        }

        // Overrides may name objects of other instances, so all instances are copied before the first override is
        // applied.
        List<PrefabInstance> instances = Instances(file).ToList();
        table.Reserve(instances.Sum(instance => instance.CopySize));
        foreach (PrefabInstance instance in instances)
            instance.AddObjects(table);
        foreach (PrefabInstance instance in instances)
            instance.Change(table);
        Removal.Apply(table, instances.SelectMany(instance => instance.Removed()).ToList());
        return table;
    }

    IEnumerable<PrefabInstance> Instances(UnityFile file)
    {
        ILookup<long, UnityDocument> standIns = file.Documents.Where(document => document.IsStripped)
            .ToLookup(document => FieldsOf(file, document).Reference("m_PrefabInstance").FileId);
        foreach (UnityDocument document in file.Documents)
        {
            if (document.ClassId != ClassId.PrefabInstance || document.IsStripped)
                continue;
            FieldMap fields = FieldsOf(file, document);
            yield return new PrefabInstance(document.Id, fields, Source(file, document, fields), standIns[document.Id]
                .Select(standIn => (standIn.Id, FieldsOf(file, standIn).Reference("m_CorrespondingSourceObject"))));
        }
    }

    ObjectTable Source(UnityFile file, UnityDocument document, FieldMap fields)
    {
        ObjectRecord Record() => new(file.ShownPath, document.ClassId, document.TypeName, document.Id, document.Fields);
        ObjectReference source = fields.Reference("m_SourcePrefab");
        if (source.IsNone || source.IsLocal)
            throw Record().Error("has no m_SourcePrefab: restore the file, or delete the instance");
        string path = _files.PathOf(source.Guid)
            ?? throw Record().Error($"refers to the prefab with guid {source.Guid}, which no .meta in the project has: "
                + "restore the prefab, or delete the instance");
        if (!path.EndsWith(".prefab", StringComparison.OrdinalIgnoreCase))
            throw Record().Error($"is an instance of {_files.Shown(path)}, a model, which only Unity reads: "
                + "make it a prefab with Mesh assets");
        return Prefab(path);
    }

    static FieldMap FieldsOf(UnityFile file, UnityDocument document) =>
        new ObjectRecord(file.ShownPath, document.ClassId, document.TypeName, document.Id, document.Fields).Fields;
}
