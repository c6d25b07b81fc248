using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>Fixes for findings about traced meshes.</summary>
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
        /// Null if none of the meshes belongs to a model, is an asset of its own, or is only in the scene.
        /// A model is reimported, which Undo does not revert.
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

        // A mesh asset of its own, or a mesh without a file.
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
