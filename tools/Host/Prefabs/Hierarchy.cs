using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint.Host;

/// <summary>
/// Links the objects of a table: components to their GameObjects and children to their parents, in Unity's order.
/// </summary>
internal sealed class Hierarchy
{
    // Deeper than any real scene; the limit prevents a stack overflow in recursive walks.
    const int MaxDepth = 500;

    readonly ObjectTable _table;
    readonly List<HierarchyNode> _nodes = new();
    readonly Dictionary<ObjectRecord, HierarchyNode> _owners = new();
    readonly HashSet<HierarchyNode> _listed = new();

    Hierarchy(ObjectTable table) => _table = table;

    /// <summary>The roots, in the hierarchy's order.</summary>
    /// <exception cref="GlintException">The file contradicts itself, or lacks objects that it refers to.</exception>
    internal static IReadOnlyList<HierarchyNode> Read(ObjectTable table, bool isScene)
    {
        Hierarchy hierarchy = new(table);
        foreach (ObjectRecord record in table.Records.Where(record => record.ClassId == ClassId.GameObject))
            hierarchy._nodes.Add(hierarchy.ReadNode(record));
        if (table.Records.FirstOrDefault(record => record.IsTransform
            && !hierarchy._owners.ContainsKey(record)) is ObjectRecord loose)
            throw loose.Error("belongs to no GameObject: restore the file");
        foreach (HierarchyNode node in hierarchy._nodes)
            node.Parent = hierarchy.ParentOf(node);
        foreach (HierarchyNode node in hierarchy._nodes)
            hierarchy.ListChildren(node);
        foreach (HierarchyNode node in hierarchy._nodes.Where(node => node.Parent is not null
            && !hierarchy._listed.Contains(node)))
            node.Parent.Children.Add(node);
        IReadOnlyList<HierarchyNode> roots = hierarchy.Roots(isScene);
        hierarchy.NameOwners(roots);
        return roots;
    }

    HierarchyNode ReadNode(ObjectRecord gameObject)
    {
        HierarchyNode node = new(gameObject);
        foreach (FieldMap entry in gameObject.Fields.Maps("m_Component"))
        {
            if (!entry.Has("component"))
                throw gameObject.Flaw("an entry of m_Component names no component: restore the file");
            ObjectReference reference = entry.Reference("component");
            if (reference.IsNone || _table.IsSkipped(reference.FileId))
                continue;
            ObjectRecord component = Require(gameObject, reference, "a component");
            if (!_owners.TryAdd(component, node))
                throw gameObject.Flaw($"{component.TypeName} &{component.Id} is a component of two "
                    + "objects: restore the file");
            if (!component.IsTransform)
                node.Components.Add(component);
            else if (node.Transform is null)
                node.Transform = component;
            else
                throw gameObject.Error("has two Transforms: restore the file");
        }
        return node.Transform is not null ? node : throw gameObject.Error("has no Transform: restore the file");
    }

    HierarchyNode ParentOf(HierarchyNode node)
    {
        ObjectReference father = node.Transform.Fields.Reference("m_Father");
        if (father.IsNone)
            return null;
        ObjectRecord parent = Require(node.GameObject, father, "a parent");
        return parent.IsTransform && _owners.TryGetValue(parent, out HierarchyNode owner)
            ? owner : throw node.GameObject.Flaw($"its parent &{father.FileId} is not a Transform of an "
                + "object: restore the file");
    }

    void ListChildren(HierarchyNode node)
    {
        foreach (ObjectReference reference in node.Transform.Fields.References("m_Children")
            .Where(reference => !reference.IsNone))
        {
            ObjectRecord record = Require(node.GameObject, reference, "a child");
            if (!_owners.TryGetValue(record, out HierarchyNode child) || child.Parent != node)
                throw node.GameObject.Error($"lists &{reference.FileId} as a child, "
                    + "which has another parent: restore the file");
            if (_listed.Add(child))
                node.Children.Add(child);
        }
    }

    IReadOnlyList<HierarchyNode> Roots(bool isScene)
    {
        IEnumerable<HierarchyNode> roots = _nodes.Where(node => node.Parent is null);
        if (!isScene)
            return roots.ToList();
        if (_table.Records.FirstOrDefault(record => record.ClassId == ClassId.SceneRoots) is ObjectRecord list)
            return list.Fields.References("m_Roots").Select(root => ListedRoot(list, root))
                .Where(node => node.Parent is null)
                .Concat(roots).Distinct().ToList();

        // Scenes older than SceneRoots have each Transform's position among its siblings instead.
        const string Order = "m_RootOrder";
        if (_nodes.Any(node => !node.Transform.Fields.Has(Order)) || _nodes.Count == 0)
            throw new GlintException($"{_table.ShownPath}: ends without SceneRoots, "
                + "it has been cut short: restore the file");
        return roots.OrderBy(node => node.Transform.Fields.Integer(Order)).ToList();
    }

    HierarchyNode ListedRoot(ObjectRecord list, ObjectReference reference) =>
        _table.FindRoot(reference.FileId) is ObjectRecord record && _owners.TryGetValue(record, out HierarchyNode node)
            ? node : throw list.Error($"refers to object &{reference.FileId}, "
                + "which is not in the file: restore the file");

    ObjectRecord Require(ObjectRecord holder, ObjectReference reference, string role) => _table.Find(reference.FileId)
        ?? throw holder.Error($"has {role} &{reference.FileId}, which is not in the file: restore the file");

    // Gives every object its path for messages. Objects that no root reaches are in a ring.
    void NameOwners(IReadOnlyList<HierarchyNode> roots)
    {
        Stack<(HierarchyNode Node, string Path, int Depth)> open = new(roots.Select(root => (root, "", 1)));
        int reached = 0;
        while (open.TryPop(out (HierarchyNode Node, string Path, int Depth) next))
        {
            reached++;
            string path = next.Path + next.Node.GameObject.Fields.Text("m_Name");
            if (next.Depth > MaxDepth)
                throw next.Node.GameObject.Error($"is more than {MaxDepth} objects deep in the "
                    + "hierarchy: flatten it");
            next.Node.Transform.Owner = path;
            foreach (ObjectRecord component in next.Node.Components)
                component.Owner = path;
            foreach (HierarchyNode child in next.Node.Children)
                open.Push((child, path + "/", next.Depth + 1));
        }
        if (reached < _nodes.Count)
            throw _nodes.First(node => node.Transform.Owner is null)
                .GameObject.Error("is its own ancestor, or below one that is: restore the file");
    }
}
