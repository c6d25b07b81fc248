using System.Collections.Generic;
using Glint.Core;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// One object of a scene, prefab or asset, prefab instances resolved, before anything of the engine is made of it.
/// </summary>
internal sealed class ObjectRecord
{
    /// <param name="file">Path for messages of the file in which the object is written.</param>
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

    /// <summary>The objects of prefabs that this one came from, that of the innermost prefab first.</summary>
    internal IReadOnlyList<ObjectReference> Origins { get; init; } = [];

    /// <summary>Path of GameObjects from the root, for messages; null where there is none.</summary>
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

    /// <param name="predicate">
    /// What the object does or lacks, and what to do: "has two Transforms: restore the file".
    /// </param>
    internal GlintException Error(string predicate) => new($"{File}: {Subject} {predicate}");

    /// <param name="clause">What is wrong within the object, and what to do: "m_Layer must be a number".</param>
    internal GlintException Flaw(string clause) => new($"{File}: {Subject}: {clause}");
}
