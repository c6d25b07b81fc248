using System;
using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host;

/// <summary>Tags and layer names; a project's TagManager.asset adds to Unity's own.</summary>
public static class TagManager
{
    static readonly string[] _builtInTags =
    {
        "Untagged", "Respawn", "Finish", "EditorOnly", "MainCamera", "Player", "GameController",
    };

    static readonly Dictionary<int, string> _builtInLayers = new()
    {
        [0] = "Default", [1] = "TransparentFX", [2] = "Ignore Raycast", [4] = "Water", [5] = "UI",
    };

    static HashSet<string> _tags = new(_builtInTags);
    static string[] _layers = Layers(Array.Empty<string>());

    internal static IReadOnlyCollection<string> Tags => _tags;

    /// <summary>Sets a project's own tags and its layer names by index; an empty name means no layer.</summary>
    public static void Set(IEnumerable<string> tags, IReadOnlyList<string> layers)
    {
        _tags = new HashSet<string>(_builtInTags);
        _tags.UnionWith(tags);
        _layers = Layers(layers);
    }

    internal static string LayerToName(int layer) => layer is >= 0 and < 32 ? _layers[layer] : "";

    internal static int NameToLayer(string name) =>
        string.IsNullOrEmpty(name) ? -1 : Array.IndexOf(_layers, name);

    internal static void RequireTag(string tag)
    {
        if (string.IsNullOrEmpty(tag) || !_tags.Contains(tag))
            throw new UnityException($"Tag: {tag} is not defined.");
    }

    static string[] Layers(IReadOnlyList<string> names)
    {
        var layers = new string[32];
        for (int index = 0; index < layers.Length; index++)
        {
            string name = index < names.Count ? names[index] : null;
            layers[index] = !string.IsNullOrEmpty(name) ? name : _builtInLayers.GetValueOrDefault(index, "");
        }
        return layers;
    }
}
