using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>The project on disk, as the editor's part of the stand-ins writes it. Paths are asset paths.</summary>
/// <remarks>
/// What cannot be written is refused with a UnityException of one line, and leaves the file as it was.
/// </remarks>
public interface IAssetStore
{
    /// <summary>Writes the object as a new asset, or in the place of what is there, whose guid stays.</summary>
    void CreateAsset(Object asset, string path);

    /// <summary>Writes an asset's present content into its file.</summary>
    void SaveAsset(Object asset);

    /// <summary>Writes the object with all below it, and gives the prefab as it is read back.</summary>
    GameObject SavePrefab(GameObject root, string path);

    bool IsFolder(string path);

    /// <summary>Makes a folder with its .meta and gives its guid.</summary>
    string CreateFolder(string path);

    /// <summary>Forgets which file has which guid, for files may have come and gone.</summary>
    void Refresh();
}
