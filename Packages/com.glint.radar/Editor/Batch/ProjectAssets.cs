using System.IO;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Writes meshes and prefabs into the project. A replaced asset keeps its guid, so that scenes still refer to it.
    /// </summary>
    static class ProjectAssets
    {
        const string ShaderFolder = "Packages/com.glint.radar/Shaders/";
        const string MeshesPackage = "Packages/com.glint.meshes";
        const string WayOut = "free the disk or the folder, or name another folder with --out";

        /// <summary>The kernel of every radar; null if its import failed.</summary>
        public static ComputeShader Kernel => LoadShader("Trace.compute");

        /// <summary>The kernels of cross sections; null if their import failed.</summary>
        public static ComputeShader TubesKernel => LoadShader("Tubes.compute");

        /// <summary>The kernel of images; null if its import failed.</summary>
        public static ComputeShader ImageKernel => LoadShader("Backprojection.compute");

        /// <summary>The kernels of radars with a tolerance; null if their import failed.</summary>
        public static ComputeShader TubeKernel => LoadShader("Amplitude.compute");

        /// <summary>The kernels of radar screens; null if their import failed.</summary>
        public static ComputeShader ScreenKernel => LoadShader("Screen.compute");

        /// <summary>The kernels of a sea's height field; null if their import failed.</summary>
        public static ComputeShader SeaKernel => LoadShader("SeaField.compute");

        /// <summary>Unity's material of new objects in the current render pipeline.</summary>
        public static Material StandardMaterial => PipelineMaterial.Default != null ? PipelineMaterial.Default
            : AssetDatabase.GetBuiltinExtraResource<Material>("Default-Material.mat");

        /// <summary>
        /// The asset path of a folder given by a user; created, with its parents, if it does not exist.
        /// </summary>
        /// <exception cref="GlintException">It is outside the project, or cannot be created.</exception>
        public static string Folder(string given)
        {
            string path = new ProjectPaths(Path.GetDirectoryName(Application.dataPath))
                .ToAssetPath(given, Directory.GetCurrentDirectory());
            Make(path);
            return path;
        }

        /// <summary>A folder of the project's own assets.</summary>
        /// <exception cref="GlintException">The project has no package for it.</exception>
        public static string StoredFolder(string name)
        {
            if (!AssetDatabase.IsValidFolder(MeshesPackage))
                throw new GlintException($"this project has no {MeshesPackage}, where the stored meshes are: "
                    + $"name a folder with --out, such as --out Assets/{name}");
            return Folder($"{MeshesPackage}/{name}");
        }

        /// <summary>An asset path as a user finds it: outside of a project the path on disk.</summary>
        public static string Shown(string path) =>
            ProjectPaths.FindRoot(Directory.GetCurrentDirectory()) == null ? FileUtil.GetPhysicalPath(path) : path;

        /// <summary>Refuses to replace a mesh and prefab of a name that are not of a kind.</summary>
        /// <typeparam name="T">The component of such a prefab.</typeparam>
        /// <exception cref="GlintException">There is another one.</exception>
        public static void CheckIsOwn<T>(string folder, string name)
            where T : Component
        {
            string prefab = $"{folder}/{name}.prefab", mesh = $"{folder}/{name}.asset";
            bool isPrefabOther = File.Exists(FileUtil.GetPhysicalPath(prefab))
                && AssetDatabase.LoadAssetAtPath<T>(prefab) == null,
                isMeshOther = File.Exists(FileUtil.GetPhysicalPath(mesh))
                    && AssetDatabase.LoadAssetAtPath<Mesh>(mesh) == null;
            if (isPrefabOther || isMeshOther)
                throw new GlintException($"{Shown(isPrefabOther ? prefab : mesh)}: is there, and is not one that glint "
                    + "made: name another folder with --out");
        }

        /// <summary>Stores a mesh; returns the asset.</summary>
        /// <exception cref="GlintException">It cannot be written.</exception>
        public static Mesh Save(Mesh made, string path)
        {
            try
            {
                return Store(made, path);
            }
            catch (UnityException error)
            {
                throw new GlintException($"{error.Message.TrimEnd('.')}: {WayOut}", error);
            }
        }

        static Mesh Store(Mesh made, string path)
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
        /// <exception cref="GlintException">It cannot be written.</exception>
        public static void SavePrefab(GameObject root, string path)
        {
            PrefabUtility.SaveAsPrefabAsset(root, path, out bool isSaved);
            Object.DestroyImmediate(root);
            if (!isSaved)
                throw new GlintException($"{path}: the prefab could not be written, the log says why: {WayOut}");
        }

        /// <summary>Adds a child that shows a mesh.</summary>
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

        static ComputeShader LoadShader(string file) =>
            AssetDatabase.LoadAssetAtPath<ComputeShader>(ShaderFolder + file);

        static void Make(string folder)
        {
            if (AssetDatabase.IsValidFolder(folder))
                return;
            string parent = folder.Substring(0, folder.LastIndexOf('/'));
            Make(parent);
            if (AssetDatabase.CreateFolder(parent, folder.Substring(parent.Length + 1)).Length == 0)
                throw new GlintException($"{folder}: the folder could not be made, the log says why: {WayOut}");
        }
    }
}
