using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>The meshes and prefabs of <c>glint sea</c> and <c>glint ship</c>.</summary>
    static class GeneratedAssets
    {
        const string ShipName = "Ship";

        /// <summary>
        /// Writes the sea of a command line, or the stored seas: snapshots, each a mesh and a prefab with its tiles and
        /// its recipe.
        /// </summary>
        /// <returns>The exit code: 0 done, 130 cancelled.</returns>
        /// <exception cref="GlintException">A setting is out of its range, or a file cannot be written.</exception>
        public static int WriteSea(CommandLine line, IProgressSink progress)
        {
            var asked = SeaOptions.Read(line);
            var seas = asked == null
                ? StoredSeas.All.Select(stored => (folder: ProjectAssets.StoredFolder(stored.Name), recipe: stored))
                    .ToArray()
                : new[] { (folder: ProjectAssets.Folder(line.Get(Options.AssetFolder)), recipe: asked) };
            progress.Start("sea", seas.Sum(sea => sea.recipe.Times.Count));
            try
            {
                int done = 0;
                foreach (var (folder, recipe) in seas)
                    if (!Write(folder, recipe, progress, ref done))
                        return Batch.Cancelled;
            }
            finally
            {
                progress.Finish();
            }
            return Batch.Done;
        }

        /// <summary>
        /// Writes the ship of a command line, or the stored ship: a mesh and a prefab with its measures, or a file.
        /// </summary>
        /// <returns>The exit code: 0 done.</returns>
        /// <exception cref="GlintException">A measure is out of range, or a file cannot be written.</exception>
        public static int WriteShip(CommandLine line, IProgressSink progress)
        {
            var asked = ShipOptions.Read(line);
            var settings = asked ?? ShipSettings.Default;
            var made = ShipModel.Build(settings);
            string path = line.IsGiven(ShipOptions.Stl)
                ? WriteStl(line.Get(ShipOptions.Stl), made)
                : WritePrefab(asked.HasValue
                    ? ProjectAssets.Folder(line.Get(Options.AssetFolder))
                    : ProjectAssets.StoredFolder(ShipName), settings, made);
            progress.Print(string.Format(CultureInfo.InvariantCulture, "{0}: {1} triangles, {2} m long", path,
                made.TriangleCount, settings.Length));
            return Batch.Done;
        }

        static string WriteStl(string path, TriangleMesh made)
        {
            try
            {
                FileDraft.Write(path, file => StlFile.Write(file, made));
                return path;
            }
            catch (Exception error) when (error is IOException || error is UnauthorizedAccessException
                || error is ArgumentException || error is NotSupportedException)
            {
                throw new GlintException($"{path}: the ship cannot be written: {error.Message.TrimEnd('.')}; "
                    + $"name another file with {ShipOptions.Stl.Flag}", error);
            }
        }

        static string WritePrefab(string folder, in ShipSettings settings, TriangleMesh made)
        {
            ProjectAssets.CheckIsOwn<Ship>(folder, ShipName);
            var mesh = ProjectAssets.Save(MeshMaker.Make(ShipName, made.Vertices, made.Indices),
                $"{folder}/{ShipName}.asset");
            var root = new GameObject(ShipName, typeof(Ship));
            ProjectAssets.Show(root, mesh);
            root.GetComponent<Ship>().Settings = settings;
            string path = $"{folder}/{ShipName}.prefab";
            ProjectAssets.SavePrefab(root, path);
            return ProjectAssets.Shown(path);
        }

        static bool Write(string folder, SeaRecipe recipe, IProgressSink progress, ref int done)
        {
            for (int i = 0; i < recipe.Times.Count; i++)
                ProjectAssets.CheckIsOwn<SeaSnapshot>(folder, SnapshotName(i + 1));
            var surface = new SeaSurface(recipe.Settings);
            progress.Print(string.Format(CultureInfo.InvariantCulture, "{0}: height factor {1:g6}",
                ProjectAssets.Shown(folder), recipe.Settings.HeightFactor));
            progress.Print("  snapshot  seconds  wave height m");
            for (int i = 0; i < recipe.Times.Count; i++)
            {
                if (progress.Cancel.IsCancellationRequested)
                {
                    WarnOfOthers(folder, i);
                    return false;
                }
                double time = recipe.Times[i], height = surface.MeasuredWaveHeight(time);
                Write(folder, SnapshotName(i + 1), surface, time, height, recipe);
                progress.Print(
                    string.Format(CultureInfo.InvariantCulture, "  {0,8}  {1,7}  {2,13:0.000}", i + 1, time, height));
                progress.Advance(++done, SnapshotName(i + 1));
            }
            WarnOfOthers(folder, recipe.Times.Count);
            return true;
        }

        // A Sea of a scene may have them beside the new ones.
        static void WarnOfOthers(string folder, int count)
        {
            int last = count;
            while (File.Exists(FileUtil.GetPhysicalPath($"{folder}/{SnapshotName(last + 1)}.prefab")))
                last++;
            if (last > count)
                Debug.LogWarning($"{ProjectAssets.Shown(folder)}: {SnapshotName(count + 1)}"
                    + (last > count + 1 ? $" to {SnapshotName(last)} are" : " is")
                    + " of an earlier sea: remove what is not used any more, or write the new sea to another folder");
        }

        static void Write(string folder, string name, SeaSurface surface, double time, double height, SeaRecipe recipe)
        {
            var tile = surface.Mesh(time);
            var mesh = ProjectAssets.Save(MeshMaker.Make(name, tile.Vertices, tile.Indices), $"{folder}/{name}.asset");
            var root = new GameObject(name);
            root.AddComponent<SeaSnapshot>().Set(mesh, recipe.Settings, time, height);
            for (int z = 0; z < recipe.Tiles.y; z++)
                for (int x = 0; x < recipe.Tiles.x; x++)
                    ProjectAssets.AddMesh(root, "Tile",
                        SeaTiles.PositionOf(x, z, recipe.Tiles, surface.Settings.TileSize), mesh);
            ProjectAssets.SavePrefab(root, $"{folder}/{name}.prefab");
        }

        // At least two digits, so that names sort by number.
        static string SnapshotName(int number) => "Snapshot " + number.ToString("00", CultureInfo.InvariantCulture);
    }
}
