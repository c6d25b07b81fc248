using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>The project on disk, as the editor's stand-ins write to it. Paths are asset paths.</summary>
/// <remarks>
/// A failure throws a UnityException of one line and leaves the file unchanged.
/// </remarks>
public interface IAssetStore
{
    /// <summary>Writes the object as a new asset, or replaces the existing one and keeps its guid.</summary>
    void CreateAsset(Object asset, string path);

    /// <summary>Writes an asset's present content into its file.</summary>
    void SaveAsset(Object asset);

    /// <summary>Writes the object with its children, and returns the prefab as read back.</summary>
    GameObject SavePrefab(GameObject root, string path);

    bool IsFolder(string path);

    /// <summary>Makes a folder with its .meta and returns its guid.</summary>
    string CreateFolder(string path);

    /// <summary>Discards the map of guids, since files may have changed.</summary>
    void Refresh();
}
