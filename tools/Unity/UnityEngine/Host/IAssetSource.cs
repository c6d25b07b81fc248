using System;
using System.Collections.Generic;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>The project on disk, for the stand-ins. Paths are asset paths: Assets/... or Packages/name/...</summary>
public interface IAssetSource
{
    string ProjectRoot { get; }

    bool Exists(string assetPath);

    /// <summary>Fills the scene with the file's objects and awakens them.</summary>
    void LoadScene(string assetPath, Scene scene);

    /// <summary>The asset's main object of a type; null if there is none.</summary>
    Object LoadAsset(string assetPath, Type type);

    /// <summary>The fields of a script, by name, that its .meta file gives a new component in edit mode.</summary>
    IEnumerable<KeyValuePair<string, Object>> DefaultReferences(Type script);

    string GuidToPath(string guid);

    string PathToGuid(string assetPath);

    /// <summary>Path on disk: an embedded or local package's folder need not be under Packages.</summary>
    string ToPhysicalPath(string assetPath);
}
