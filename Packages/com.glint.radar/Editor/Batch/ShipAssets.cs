using System.Globalization;
using Glint.Core;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary><c>glint ship</c>: a ship as a mesh and a prefab that carries its measures.</summary>
    static class ShipAssets
    {
        const string Name = "Ship";

        /// <summary>Writes the ship of a command line, or the stored ship.</summary>
        /// <returns>The exit code: 0 done.</returns>
        /// <exception cref="GlintException">A measure is out of range, or a file cannot be written.</exception>
        public static int Write(CommandLine line, IProgressSink progress)
        {
            var asked = ShipOptions.Read(line);
            string folder =
                asked.HasValue ? ProjectAssets.Folder(line.Get(Options.AssetFolder)) : ProjectAssets.StoredFolder(Name);
            var settings = asked ?? ShipSettings.Default;
            var made = ShipModel.Build(settings);
            var mesh = ProjectAssets.Save(MeshMaker.Make(Name, made.Vertices, made.Indices), $"{folder}/{Name}.asset");
            var root = new GameObject(Name, typeof(MeshFilter), typeof(MeshRenderer), typeof(Ship));
            ProjectAssets.Show(root, mesh);
            root.GetComponent<Ship>().Settings = settings;
            ProjectAssets.SavePrefab(root, $"{folder}/{Name}.prefab");
            progress.Print(string.Format(CultureInfo.InvariantCulture, "{0}/{1}.prefab: {2} triangles, {3} m long",
                folder, Name, made.TriangleCount, settings.Length));
            return Batch.Done;
        }
    }
}
