using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor;

/// <summary>The host has no importers with settings; a test assigns importers to paths.</summary>
public class AssetImporter : UnityEngine.Object
{
    public string assetPath { get; internal set; } = "";

    internal static Dictionary<string, AssetImporter> Known { get; } = new();

    public static AssetImporter GetAtPath(string path) => Known.GetValueOrDefault(path);

    public void SaveAndReimport() => Import();

    internal virtual void Import()
    {
    }
}

public class ModelImporter : AssetImporter
{
    public bool isReadable { get; set; }

    /// <summary>The model's meshes.</summary>
    internal List<Mesh> Meshes { get; } = new();

    internal override void Import()
    {
        foreach (Mesh mesh in Meshes)
            mesh.Contents.IsReadable = isReadable;
    }
}
