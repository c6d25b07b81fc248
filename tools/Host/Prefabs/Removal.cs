using System;
using System.Collections.Generic;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// Removes objects from a table: a GameObject with its components and descendants, and their entries in lists.
/// </summary>
internal sealed class Removal
{
    readonly ObjectTable _table;
    readonly HashSet<ObjectRecord> _removed = new();

    Removal(ObjectTable table) => _table = table;

    internal static void Apply(ObjectTable table, IReadOnlyCollection<ObjectRecord> chosen)
    {
        if (chosen.Count == 0)
            return;
        Removal removal = new(table);
        removal.Follow(chosen);
        foreach (ObjectRecord record in table.Records.Where(record => !removal._removed.Contains(record)))
        {
            removal.Unlist(record, "m_Component", item => (item as YamlMappingNode)?.Child("component"));
            removal.Unlist(record, "m_Children", item => item);
        }
        table.Remove(removal._removed);
    }

    void Follow(IEnumerable<ObjectRecord> chosen)
    {
        Dictionary<ObjectRecord, List<ObjectRecord>> followers = Followers();
        Stack<ObjectRecord> open = new(chosen);
        while (open.TryPop(out ObjectRecord record))
        {
            if (!_removed.Add(record))
                continue;
            foreach (ObjectRecord follower in followers.GetValueOrDefault(record, []))
                open.Push(follower);
        }
    }

    // Objects that are removed with another object.
    Dictionary<ObjectRecord, List<ObjectRecord>> Followers()
    {
        Dictionary<ObjectRecord, List<ObjectRecord>> followers = new();
        void Add(ObjectRecord leader, ObjectRecord follower)
        {
            if (leader is null)
                return;
            if (!followers.TryGetValue(leader, out List<ObjectRecord> list))
                followers.Add(leader, list = new List<ObjectRecord>(4));
            list.Add(follower);
        }

        foreach (ObjectRecord record in _table.Records)
        {
            ObjectRecord owner = _table.Find(record.Fields.Reference("m_GameObject").FileId);
            Add(owner, record);
            if (!record.IsTransform)
                continue;
            Add(_table.Find(record.Fields.Reference("m_Father").FileId), record);
            if (owner is not null)
                Add(record, owner);
        }
        return followers;
    }

    void Unlist(ObjectRecord record, string key, Func<YamlNode, YamlNode> reference)
    {
        bool IsRemoved(YamlNode item) => ObjectReference.TryRead(reference(item), out ObjectReference found)
            && _table.Find(found.FileId) is ObjectRecord listed && _removed.Contains(listed);
        IList<YamlNode> items = record.Fields.Node.Items(key);
        if (items.Any(IsRemoved))
            record.Fields.Node.Set(key, new YamlSequenceNode(items.Where(item => !IsRemoved(item))));
    }
}
