using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// One PrefabInstance document. It copies the prefab's objects into a table under new ids, and applies its overrides.
/// </summary>
internal sealed class PrefabInstance
{
    const long PositiveMask = long.MaxValue;

    readonly long _id;
    readonly FieldMap _modification;
    readonly ObjectTable _source;
    readonly Dictionary<ObjectRecord, List<long>> _standIns = new();
    readonly List<long> _skippedStandIns = new();
    readonly Dictionary<ObjectRecord, ObjectRecord> _copies = new();

    /// <param name="standIns">Ids of the stripped documents for each object of the prefab.</param>
    internal PrefabInstance(long id, FieldMap fields, ObjectTable source,
        IEnumerable<(long Id, ObjectReference Source)> standIns)
    {
        _id = id;
        _modification = fields.Map("m_Modification");
        _source = source;
        foreach ((long standIn, ObjectReference reference) in standIns)
        {
            if (source.Resolve(reference) is not ObjectRecord original)
            {
                if (source.IsSkipped(reference.FileId))
                    _skippedStandIns.Add(standIn);
                continue;
            }
            if (!_standIns.TryGetValue(original, out List<long> ids))
                _standIns.Add(original, ids = new List<long>(1));
            ids.Add(standIn);
        }
    }

    /// <summary>Memory of the copies, as a number of values.</summary>
    internal long CopySize => _source.CopySize;

    internal void AddObjects(ObjectTable table)
    {
        Dictionary<ObjectRecord, long> ids = new();
        HashSet<long> taken = new();
        foreach (ObjectRecord original in _source.Records)
            ids.Add(original, NewId(original, table, taken));

        long Rename(long id) => _source.Find(id) is ObjectRecord original ? ids[original] : OutsideId(id);
        foreach (ObjectRecord original in _source.Records)
        {
            ObjectRecord copy = new(original.File, original.ClassId, original.TypeName, ids[original],
                original.Fields.Node.CloneFields(Rename))
            {
                Origins = [.. original.Origins, new ObjectReference(original.Id, _source.Guid)],
            };
            table.Add(copy);
            _copies.Add(original, copy);
        }
        foreach (long skipped in _source.Skipped)
            table.AddSkipped(OutsideId(skipped));
        foreach (long standIn in _skippedStandIns)
            table.AddSkipped(standIn);
        foreach ((ObjectRecord original, ObjectRecord copy) in _copies)
        {
            table.AddAlias(OutsideId(original.Id), copy);
            foreach (long id in _standIns.GetValueOrDefault(original, []))
                table.AddAlias(id, copy);
        }
    }

    internal void Change(ObjectTable table)
    {
        foreach (FieldMap line in _modification.Maps("m_Modifications"))
        {
            PropertyOverride change = new(line, table);
            // Unity too drops overrides of objects that the prefab no longer has.
            if (Copy(change.Target) is ObjectRecord target)
                change.ApplyTo(target);
        }
        SetParent(table);
        foreach (FieldMap added in _modification.Maps("m_AddedGameObjects"))
            Insert(Copy(added.Reference("targetCorrespondingSourceObject")), "m_Children", added);
        foreach (FieldMap added in _modification.Maps("m_AddedComponents"))
            Insert(Copy(added.Reference("targetCorrespondingSourceObject")), "m_Component", added);
    }

    /// <summary>Copies that the instance removes, for <see cref="Removal"/>.</summary>
    internal IEnumerable<ObjectRecord> Removed() => _modification.References("m_RemovedComponents")
        .Concat(_modification.References("m_RemovedGameObjects"))
        .Select(Copy).Where(record => record is not null);

    /// <summary>Id of a prefab's object in the enclosing file, if no stripped document gives it one.</summary>
    long OutsideId(long id) => (_id ^ id) & PositiveMask;

    long NewId(ObjectRecord original, ObjectTable table, HashSet<long> taken)
    {
        long id = _standIns.TryGetValue(original, out List<long> standIns) ? standIns[0] : OutsideId(original.Id);
        while (!table.IsFree(id) || !taken.Add(id))
            id = table.FreeId();
        return id;
    }

    ObjectRecord Copy(ObjectReference target) =>
        _source.Resolve(target) is ObjectRecord original ? _copies[original] : null;

    void SetParent(ObjectTable table)
    {
        ObjectRecord root = _copies[_source.Root];
        ObjectReference parent = _modification.Reference("m_TransformParent");
        root.Fields.Node.Set("m_Father", parent.ToNode());
        if (parent.IsNone)
        {
            table.AddInstanceRoot(_id, root);
            return;
        }
        ObjectRecord father = table.Find(parent.FileId)
            ?? throw new GlintException($"{table.ShownPath}: PrefabInstance &{_id} is below object &{parent.FileId}, "
                + "which is not in the file: restore the file");
        // Added as the last child. If it is already listed, its first entry counts.
        YamlNode children = father.Fields.Node.Child("m_Children");
        if (children.IsEmpty() || children is YamlSequenceNode)
            father.Fields.Node.ListAt("m_Children").Add(new ObjectReference(root.Id).ToNode());
    }

    // Inserts a child or a component at its index, or at the end.
    static void Insert(ObjectRecord target, string listName, FieldMap added)
    {
        ObjectReference item = added.Reference("addedObject");
        if (target is null || item.IsNone)
            return;
        YamlSequenceNode list = target.Fields.Node.ListAt(listName);
        YamlMappingNode node = item.ToNode();
        if (listName == "m_Component")
        {
            YamlMappingNode entry = new();
            entry.Set("component", node);
            node = entry;
            if (list.Children.Contains(node))
                return;
        }
        long index = added.Integer("insertIndex", -1);
        if (index < 0 || index > list.Children.Count)
            list.Children.Add(node);
        else
            list.Children.Insert((int)index, node);
    }
}
