using System.IO;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Meshes and prefabs written into the project. What is replaced keeps its guid, so that scenes still find it.
    /// </summary>
    static class ProjectAssets
    {
        const string KernelPath = "Packages/com.glint.radar/Shaders/Trace.compute";
        const string MeshesPackage = "Packages/com.glint.meshes";

        /// <summary>The kernel that every radar needs; null where its import failed.</summary>
        public static ComputeShader Kernel => AssetDatabase.LoadAssetAtPath<ComputeShader>(KernelPath);

        /// <summary>What Unity gives new objects to look like.</summary>
        public static Material StandardMaterial =>
            AssetDatabase.GetBuiltinExtraResource<Material>("Default-Material.mat");

        /// <summary>
        /// The asset path of a folder as a user names it; made, with its parents, when it is not there.
        /// </summary>
        /// <exception cref="GlintException">It is outside of the project, or cannot be made.</exception>
        public static string Folder(string given)
        {
            string path = new ProjectPaths(Path.GetDirectoryName(Application.dataPath))
                .ToAssetPath(given, Directory.GetCurrentDirectory());
            Make(path);
            return path;
        }

        /// <summary>A folder for what the project stores itself.</summary>
        /// <exception cref="GlintException">The project has no package for it.</exception>
        public static string StoredFolder(string name)
        {
            if (!AssetDatabase.IsValidFolder(MeshesPackage))
                throw new GlintException($"this project has no {MeshesPackage}, where the stored meshes are: "
                    + $"name a folder with --out, such as --out Assets/{name}");
            return Folder($"{MeshesPackage}/{name}");
        }

        /// <summary>Stores a mesh; returns the asset.</summary>
        public static Mesh Save(Mesh made, string path)
        {
            var stored = AssetDatabase.LoadAssetAtPath<Mesh>(path);
            if (stored == null)
            {
                AssetDatabase.CreateAsset(made, path);
                return made;
            }
            EditorUtility.CopySerialized(made, stored);
            EditorUtility.SetDirty(stored);
            AssetDatabase.SaveAssetIfDirty(stored);
            Object.DestroyImmediate(made);
            return stored;
        }

        /// <summary>Stores an object of the scene, with all below it, as a prefab, and removes it.</summary>
        /// <exception cref="GlintException">Unity could not write it.</exception>
        public static void SavePrefab(GameObject root, string path)
        {
            PrefabUtility.SaveAsPrefabAsset(root, path, out bool isSaved);
            Object.DestroyImmediate(root);
            if (!isSaved)
                throw new GlintException($"{path}: the prefab could not be written: Unity's log says why");
        }

        /// <summary>An object that shows a mesh, below another.</summary>
        public static void AddMesh(GameObject parent, string name, Vector3 position, Mesh mesh)
        {
            var shown = new GameObject(name, typeof(MeshFilter), typeof(MeshRenderer));
            shown.transform.SetParent(parent.transform, false);
            shown.transform.localPosition = position;
            Show(shown, mesh);
        }

        /// <summary>Gives an object a mesh to show, with Unity's standard material.</summary>
        public static void Show(GameObject shown, Mesh mesh)
        {
            shown.GetComponent<MeshFilter>().sharedMesh = mesh;
            shown.GetComponent<MeshRenderer>().sharedMaterial = StandardMaterial;
        }

        static void Make(string folder)
        {
            if (AssetDatabase.IsValidFolder(folder))
                return;
            string parent = folder.Substring(0, folder.LastIndexOf('/'));
            Make(parent);
            if (AssetDatabase.CreateFolder(parent, folder.Substring(parent.Length + 1)).Length == 0)
                throw new GlintException($"{folder}: the folder could not be made: Unity's log says why");
        }
    }
}
