using System.Collections.Generic;
using System.Linq;

namespace Glint.Host;

/// <summary>Tags, layers and the build's scenes from ProjectSettings. A missing file has its defaults.</summary>
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

    /// <summary>Names by layer number; empty for a layer without name.</summary>
    internal IReadOnlyList<string> Layers { get; } = [];

    /// <summary>Asset paths of the build's scenes, in order.</summary>
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
