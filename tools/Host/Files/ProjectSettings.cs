using System.Collections.Generic;
using System.Linq;

namespace Glint.Host;

/// <summary>
/// What ProjectSettings says of tags, layers and the scenes of the build; a file that is absent has its defaults.
/// </summary>
internal sealed class ProjectSettings
{
    const string TagManagerPath = "ProjectSettings/TagManager.asset",
        BuildSettingsPath = "ProjectSettings/EditorBuildSettings.asset";

    internal ProjectSettings(ProjectFiles files)
    {
        if (Read(files, TagManagerPath) is FieldMap tags)
        {
            Tags = tags.Texts("tags");
            Layers = tags.Texts("layers");
        }
        if (Read(files, BuildSettingsPath) is FieldMap build)
            BuildScenes = build.Maps("m_Scenes").Where(scene => scene.Flag("enabled", true))
                .Select(scene => scene.Text("path")).ToList();
    }

    internal IReadOnlyList<string> Tags { get; } = [];

    /// <summary>Names by layer number; empty where the layer has none.</summary>
    internal IReadOnlyList<string> Layers { get; } = [];

    /// <summary>Asset paths, in the order of the build.</summary>
    internal IReadOnlyList<string> BuildScenes { get; } = [];

    static FieldMap? Read(ProjectFiles files, string path)
    {
        if (!files.Exists(path))
            return null;
        UnityFile file = files.ReadObjects(path);
        UnityDocument document = file.Documents[0];
        return new ObjectRecord(file.ShownPath, document.ClassId, document.TypeName,
            document.Id, document.Fields).Fields;
    }
}
