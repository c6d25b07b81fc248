using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace Glint.Core
{
    /// <summary>
    /// Maps paths on disk to Unity's asset paths and back:
    /// <c>Scenes/X.unity</c> on disk is <c>Packages/com.glint.scenes/X.unity</c> in Unity when the manifest says
    /// <c>"com.glint.scenes": "file:../Scenes"</c>.
    /// </summary>
    public sealed class ProjectPaths
    {
        const string ManifestPath = "Packages/manifest.json";
        static readonly bool OnWindows = Path.DirectorySeparatorChar == '\\';
        static readonly StringComparison PathComparison =
            OnWindows ? StringComparison.OrdinalIgnoreCase : StringComparison.Ordinal;

        readonly SortedDictionary<string, string> _packages =
            new SortedDictionary<string, string>(StringComparer.Ordinal);

        /// <summary>Reads the project's manifest and its embedded packages.</summary>
        /// <param name="root">Folder that holds Assets and Packages.</param>
        /// <exception cref="GlintException">
        /// No manifest, a malformed one, or one that names a folder that is not there.
        /// </exception>
        public ProjectPaths(string root)
        {
            Root = Normalize(root);
            AddEmbedded();
            AddLocal();
        }

        /// <summary>Absolute path of the project's folder, with '/', without a trailing one.</summary>
        public string Root { get; }

        /// <summary>
        /// Name and absolute folder of each package whose files belong to the project:
        /// embedded ones and those with a <c>file:</c> line.
        /// </summary>
        public IReadOnlyDictionary<string, string> Packages => _packages;

        /// <summary>
        /// The project that a folder is in: the nearest folder upwards with Packages/manifest.json and ProjectSettings;
        /// null when there is none.
        /// </summary>
        public static string FindRoot(string directory)
        {
            for (var folder = new DirectoryInfo(Path.GetFullPath(directory)); folder != null; folder = folder.Parent)
            {
                if (File.Exists(Path.Combine(folder.FullName, ManifestPath))
                    && Directory.Exists(Path.Combine(folder.FullName, "ProjectSettings")))
                    return Normalize(folder.FullName);
            }
            return null;
        }

        /// <summary>
        /// Asset path of a file named in any of the usual ways: as asset path, absolute,
        /// relative to the current directory or to the project.
        /// Of several possible readings the first that exists is taken, in this order. The file need not exist.
        /// </summary>
        /// <exception cref="GlintException">The path is empty or lies outside of the project.</exception>
        public string ToAssetPath(string path, string currentDirectory)
        {
            var readings = Readings(path, currentDirectory);
            var existing = readings.FirstOrDefault(reading => File.Exists(reading) || Directory.Exists(reading));
            var inside = readings.FirstOrDefault(reading => TryFromPhysical(reading) != null);
            return FromPhysical(path, existing ?? inside ?? readings[0]);
        }

        /// <summary>
        /// The absolute paths on disk, with '/', that <see cref="ToAssetPath"/> tries for a path, in its order.
        /// </summary>
        /// <exception cref="GlintException">The path is empty.</exception>
        public IReadOnlyList<string> Readings(string path, string currentDirectory)
        {
            if (string.IsNullOrWhiteSpace(path))
                throw new GlintException("the path is empty: give an asset path or a path on disk");
            if (Path.IsPathRooted(path))
                return new[] { Normalize(path) };
            var readings = new List<string>(3);
            if (IsAssetPath(path))
                readings.Add(Normalize(ToPhysicalPath(path)));
            readings.Add(Normalize(Path.Combine(currentDirectory, path)));
            readings.Add(Normalize(Path.Combine(Root, path)));
            return readings.Distinct().ToArray();
        }

        /// <summary>
        /// Absolute path on disk, with '/', of an asset path; other paths (ProjectSettings/...)
        /// are relative to the project's folder.
        /// </summary>
        public string ToPhysicalPath(string assetPath)
        {
            var parts = Slashes(assetPath).Split(new[] { '/' }, 3);
            if (parts.Length > 1 && parts[0] == "Packages" && _packages.TryGetValue(parts[1], out var folder))
                return parts.Length == 2 ? folder : folder + "/" + parts[2];
            return Normalize(Path.Combine(Root, assetPath));
        }

        bool IsAssetPath(string path)
        {
            var parts = Slashes(path).Split('/');
            return parts[0] == "Assets"
                || parts.Length > 1 && parts[0] == "Packages" && _packages.ContainsKey(parts[1]);
        }

        string FromPhysical(string asGiven, string physical) => TryFromPhysical(physical) ?? throw new GlintException(
            $"{asGiven}: outside of the Unity project {Root}: scenes and assets must be in its Assets, "
            + $"in an embedded package, or in a folder that {ManifestPath} names by a file: line");

        string TryFromPhysical(string physical)
        {
            // The innermost of nested folders owns the file.
            var owner = _packages.Where(package => IsWithin(physical, package.Value))
                .OrderByDescending(package => package.Value.Length).FirstOrDefault();
            if (owner.Key != null)
                return "Packages/" + owner.Key + physical.Substring(owner.Value.Length);
            var assets = Root + "/Assets";
            return IsWithin(physical, assets) ? "Assets" + physical.Substring(assets.Length) : null;
        }

        void AddEmbedded()
        {
            var packages = Path.Combine(Root, "Packages");
            if (!Directory.Exists(packages))
                return;
            foreach (var folder in Directory.GetDirectories(packages))
            {
                var file = Path.Combine(folder, "package.json");
                if (File.Exists(file))
                    _packages[PackageName(file)] = Normalize(folder);
            }
        }

        void AddLocal()
        {
            var manifest = Path.Combine(Root, ManifestPath);
            if (!File.Exists(manifest))
                throw new GlintException($"{Root}: not a Unity project: it has no {ManifestPath}");
            var dependencies = ReadObject(manifest)["dependencies"];
            if (dependencies == null)
                return;
            if (!(dependencies is JObject lines))
                throw new GlintException($"{manifest}: \"dependencies\" must be an object of "
                    + "package names and versions");
            foreach (var line in lines.Properties())
            {
                if (line.Value.Type != JTokenType.String)
                    throw new GlintException($"{manifest}: the version of {line.Name} must be a string, "
                        + "such as \"1.0.0\" or \"file:../Folder\"");
                var version = (string)line.Value;
                if (version.StartsWith("file:", StringComparison.Ordinal)
                    && !version.EndsWith(".tgz", StringComparison.OrdinalIgnoreCase))
                    AddLocal(manifest, line.Name, version);
            }
        }

        void AddLocal(string manifest, string name, string version)
        {
            // As in Unity, the path is relative to the folder of the manifest.
            var folder = Normalize(Path.Combine(Root, "Packages", version.Substring("file:".Length)));
            var file = folder + "/package.json";
            if (!File.Exists(file))
                throw new GlintException($"{manifest}: {name} is at {version}, but there is no {file}");
            if (PackageName(file) != name)
                throw new GlintException($"{manifest}: {name} is at {version}, but {file} is of {PackageName(file)}");
            _packages[name] = folder;
        }

        static string PackageName(string file)
        {
            var name = ReadObject(file)["name"];
            return name != null && name.Type == JTokenType.String
                ? (string)name
                : throw new GlintException($"{file}: has no \"name\"");
        }

        static JObject ReadObject(string file)
        {
            try
            {
                // A pipe or device has length 0 too; opening one may block.
                if (new FileInfo(file).Length == 0)
                    throw new GlintException($"{file}: is empty, or a pipe or device instead of a file: restore the "
                        + "file");
                return JObject.Parse(File.ReadAllText(file));
            }
            catch (JsonReaderException error)
            {
                throw new GlintException(
                    FormattableString.Invariant($"{file}: malformed JSON in line {error.LineNumber}: correct the line"), error);
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException)
            {
                throw new GlintException($"{file}: cannot be read: {error.Message}", error);
            }
        }

        static bool IsWithin(string path, string folder) =>
            path.StartsWith(folder, PathComparison) && (path.Length == folder.Length || path[folder.Length] == '/');

        static string Normalize(string path)
        {
            var full = Slashes(Path.GetFullPath(path));
            return full.Length > 1 ? full.TrimEnd('/') : full;
        }

        // A backslash is a separator on Windows only; elsewhere it may be part of a name.
        static string Slashes(string path) => OnWindows ? path.Replace('\\', '/') : path;
    }
}
