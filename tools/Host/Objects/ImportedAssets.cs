using System;
using System.Collections.Generic;
using System.IO;
using Glint.Core;
using Glint.Vulkan;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Assets imported from files of other formats: compute shaders and text.</summary>
internal static class ImportedAssets
{
    const long ComputeShaderId = 7200000, TextId = 4900000;

    /// <summary>Null for kinds that the host leaves out, for example textures.</summary>
    internal static Object Make(ProjectFiles files, string path)
    {
        string shown = files.Shown(path);
        switch (Path.GetExtension(path).ToLowerInvariant())
        {
            case ".compute":
                return WithId(ComputeShaderId, () =>
                    new ComputeShader(Path.GetFileNameWithoutExtension(path), files.Paths.Root, shown, Kernels(shown)));
            case ".txt" or ".json" or ".csv" or ".xml" or ".md" or ".bytes" or ".html" or ".htm" or ".yaml" or ".fnt":
                byte[] bytes = AssetText.ReadBytes(files.Physical(path), shown);
                return WithId(TextId, () => new TextAsset(bytes.AsSpan()));
            default:
                return null;
        }
    }

    static Object WithId<T>(long fileId, Func<T> constructor)
        where T : Object
    {
        T made = ObjectRegistry.Make(true, constructor);
        made.FileId = fileId;
        return made;
    }

    static IReadOnlyList<string> Kernels(string computePath)
    {
        try
        {
            return ShaderLibrary.Kernels(computePath);
        }
        catch (VulkanException error)
        {
            throw new GlintException(error.Message, error);
        }
    }
}
