using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text.Json;

namespace Glint.Vulkan;

/// <summary>
/// The kernels compiled with this program: shaders/COMPUTE/KERNEL.spv beside it, where COMPUTE is the .compute file's
/// path from the project's root. sources.json in the same folder has the kernels' names, their byte address buffers and
/// the SHA-256 of every source file.
/// </summary>
public static class ShaderLibrary
{
    const string Remedy = "build the tools again, tools/glint does so; or unpack the release again";

    /// <summary>Names of the kernels of a .compute file, in order.</summary>
    public static IReadOnlyList<string> Kernels(string computePath) => Manifest.Read(computePath).Kernels;

    /// <summary>Throws if the source files of a project have changed since the kernels were compiled.</summary>
    /// <param name="projectRoot">The project's folder.</param>
    /// <param name="computePath">
    /// Path from there, for example "Packages/com.glint.radar/Shaders/Trace.compute".
    /// </param>
    public static void RequireSources(string projectRoot, string computePath)
    {
        foreach (var (path, hash) in Manifest.Read(computePath).Sources)
        {
            string file = Path.Combine(projectRoot, path);
            if (!File.Exists(file))
                throw new VulkanException($"{computePath} was compiled with {path}, "
                    + $"which {projectRoot} lacks; {Remedy}");
            if (Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(file))) != hash)
                throw new VulkanException($"{path} changed since {computePath} was compiled; {Remedy}");
        }
    }

    /// <summary>SPIR-V of a kernel as compiled, without a check of the source files.</summary>
    public static byte[] Load(string computePath, string kernel)
    {
        var kernels = Kernels(computePath);
        if (!((ICollection<string>)kernels).Contains(kernel))
            throw new VulkanException($"{computePath} has no kernel {kernel}; it has {string.Join(", ", kernels)}");
        return File.ReadAllBytes(Path.Combine(Folder(computePath), kernel + ".spv"));
    }

    /// <summary>
    /// Names of the byte address buffers that a kernel's source declares. In SPIR-V they are structured buffers of
    /// uint.
    /// </summary>
    public static IReadOnlyCollection<string> ByteAddressBuffers(string computePath, string kernel) =>
        Manifest.Read(computePath).ByteAddressBuffers[kernel];

    static string Folder(string computePath) => Path.Combine(AppContext.BaseDirectory, "shaders", computePath);

    sealed record Manifest(string[] Kernels, Dictionary<string, string[]> ByteAddressBuffers,
        Dictionary<string, string> Sources)
    {
        // Written without reflection, which a trimmed publish lacks.
        internal static Manifest Read(string computePath)
        {
            string path = Path.Combine(Folder(computePath), "sources.json");
            if (!File.Exists(path))
                throw new VulkanException($"{computePath} was not compiled; {Remedy}");
            using var json = JsonDocument.Parse(File.ReadAllBytes(path));
            return new Manifest(
                Strings(json.RootElement.GetProperty("kernels")),
                json.RootElement.GetProperty("byteAddressBuffers").EnumerateObject()
                    .ToDictionary(kernel => kernel.Name, kernel => Strings(kernel.Value)),
                json.RootElement.GetProperty("sources").EnumerateObject()
                    .ToDictionary(source => source.Name, source => source.Value.GetString()));
        }

        static string[] Strings(JsonElement array) =>
            array.EnumerateArray().Select(element => element.GetString()).ToArray();
    }
}
