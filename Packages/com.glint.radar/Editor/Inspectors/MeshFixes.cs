using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>What the buttons beside findings of traced meshes do.</summary>
    static class MeshFixes
    {
        public static bool IsBatchingStatic(Renderer renderer) =>
            GameObjectUtility.AreStaticEditorFlagsSet(renderer.gameObject, StaticEditorFlags.BatchingStatic);

        public static Fix ClearBatching(IReadOnlyList<MeshRenderer> renderers) => new Fix("Clear Batching Static", () =>
        {
            foreach (var renderer in renderers)
                Fix.Change(renderer.gameObject, "Clear Batching Static", it => GameObjectUtility.SetStaticEditorFlags(
                    it, GameObjectUtility.GetStaticEditorFlags(it) & ~StaticEditorFlags.BatchingStatic));
        });

        /// <summary>
        /// Null when none of the meshes is a model's, an asset of its own, or only in the scene.
        /// A model is imported anew, which Undo does not take back.
        /// </summary>
        public static Fix MakeReadable(IReadOnlyList<Mesh> meshes)
        {
            var own = meshes.Where(IsOwn).ToList();
            var models = meshes.Select(Importer).Where(importer => importer != null).Distinct().ToList();
            return own.Count + models.Count == 0 ? null : new Fix("Make readable", () =>
            {
                own.ForEach(SetReadable);
                foreach (var model in models)
                {
                    model.isReadable = true;
                    model.SaveAndReimport();
                }
            });
        }

        // Its file is the mesh itself, or it has none.
        static bool IsOwn(Mesh mesh)
        {
            string path = AssetDatabase.GetAssetPath(mesh);
            return path.Length == 0 || path.EndsWith(".asset") || path.EndsWith(".mesh");
        }

        static ModelImporter Importer(Mesh mesh) =>
            AssetImporter.GetAtPath(AssetDatabase.GetAssetPath(mesh)) as ModelImporter;

        static void SetReadable(Mesh mesh)
        {
            using (var fields = new SerializedObject(mesh))
            {
                fields.FindProperty("m_IsReadable").boolValue = true;
                fields.ApplyModifiedProperties();
            }
        }
    }
}
