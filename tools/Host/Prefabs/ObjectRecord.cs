using System.Collections.Generic;
using Glint.Core;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>One object of a scene, prefab or asset as YAML, after prefab instances are resolved.</summary>
internal sealed class ObjectRecord
{
    /// <param name="file">Path of the file with the object, for messages.</param>
    internal ObjectRecord(string file, int classId, string typeName, long id, YamlMappingNode node)
    {
        File = file;
        ClassId = classId;
        TypeName = typeName;
        Id = id;
        Fields = new FieldMap(this, node);
    }

    internal string File { get; }

    internal int ClassId { get; }

    internal string TypeName { get; set; }

    internal long Id { get; }

    internal FieldMap Fields { get; }

    /// <summary>The prefab objects that this one was copied from, innermost prefab first.</summary>
    internal IReadOnlyList<ObjectReference> Origins { get; init; } = [];

    /// <summary>Path of GameObjects from the root, for messages; null without one.</summary>
    internal string Owner { get; set; }

    internal bool IsTransform => Host.ClassId.IsTransform(ClassId);

    internal string Subject
    {
        get
        {
            if (Owner is not null)
                return $"{TypeName} of '{Owner}'";
            string name = (Fields.Node.Child("m_Name") as YamlScalarNode)?.Value;
            return string.IsNullOrEmpty(name) ? $"{TypeName} &{Id}" : $"{TypeName} '{name}'";
        }
    }

    /// <param name="predicate">Problem of the object and the way out: "has two Transforms: restore the file".</param>
    internal GlintException Error(string predicate) => new($"{File}: {Subject} {predicate}");

    /// <param name="clause">Problem within the object and the way out: "m_Layer must be a number".</param>
    internal GlintException Flaw(string clause) => new($"{File}: {Subject}: {clause}");
}
