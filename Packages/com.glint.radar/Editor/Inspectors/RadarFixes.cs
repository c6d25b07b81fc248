using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Editor
{
    /// <summary>Actions of the buttons of a radar's inspector, also those beside its findings.</summary>
    static class RadarFixes
    {
        public static Fix Enable(RadarController radar) => new Fix("Enable", () =>
        {
            if (!radar.enabled)
                Fix.Change(radar, "Enable", it => it.enabled = true);
            for (var at = radar.transform; at != null; at = at.parent)
                if (!at.gameObject.activeSelf)
                    Fix.Change(at.gameObject, "Enable", it => it.SetActive(true));
        });

        public static Fix MakeReceiver(RadarController radar) => new Fix("Make a receiver", () =>
        {
            var receiver = MeshFileScene.MakeReceiver(radar.transform,
                radar.TryGetComponent<Camera>(out var camera) && camera.orthographic);
            Undo.RegisterCreatedObjectUndo(receiver.gameObject, "Make a receiver");
            Fix.Change(radar, "Make a receiver", it => it.Receiver = receiver);
        });

        public static Fix AlignReceiver(RadarController radar) => new Fix("Align the receiver", () =>
            Fix.Change(radar.Receiver, "Align the receiver", it =>
            {
                var model = MeshFileScene.MakeReceiver(radar.transform, radar.GetComponent<Camera>().orthographic);
                it.SetPositionAndRotation(model.position, model.rotation);
                Object.DestroyImmediate(model.gameObject);
            }));

        public static Fix AddCamera(RadarController radar) =>
            new Fix("Add a Camera", () => Undo.AddComponent<Camera>(radar.gameObject));

        public static Fix ShowRayPaths(RadarController radar) =>
            new Fix("Show Ray Paths", () => Undo.AddComponent<RayPaths>(radar.gameObject));

        public static Fix FitAperture(RadarController radar) => new Fix("Fit the aperture to the traced objects",
            () => Fix.Change(radar, "Fit the aperture", it => it.FitAperture = true));

        public static Fix RemoveEmptyRoots(RadarController radar) => new Fix("Remove empty entries",
            () => Fix.Change(radar, "Remove empty entries", it => it.Roots.RemoveAll(root => root == null)));

        public static Fix TraceAllLayers(RadarController radar) =>
            new Fix("Trace all layers", () => Fix.Change(radar, "Trace all layers", it => it.Layers = ~0));

        public static Fix TraceWholePicture(RadarController radar) => new Fix("Trace the whole picture", () =>
            Fix.Change(radar, "Trace the whole picture", it =>
            {
                var settings = it.Settings;
                settings.Region = default;
                it.Settings = settings;
            }));

        /// <param name="times">Factor for the rays across and down; null: no fix.</param>
        public static Fix TraceDenser(RadarController radar, int? times)
        {
            if (!(times is int more))
                return null;
            if (radar.IsFitted)
                return new Fix(FormattableString.Invariant($"Set Ray Spacing to {radar.RaySpacing / more:0.####} m"),
                    () => Fix.Change(radar, "Set Ray Spacing", it => it.RaySpacing /= more));
            var denser = RadarFigures.Denser(radar.Settings, more);
            return new Fix($"Trace {denser.RaysAcross} x {denser.RaysDown} rays",
                () => Fix.Change(radar, "Trace more rays", it => it.Settings = denser));
        }

        /// <param name="direction">Where to look, in the world's axes.</param>
        public static Fix LookAt(RadarController radar, double3 direction)
        {
            var forward = math.normalize(direction);
            return new Fix("Turn the radar towards it", () =>
                Fix.Change(radar.transform, "Turn the radar", it => it.rotation =
                    Quaternion.LookRotation(new Vector3((float)forward.x, (float)forward.y, (float)forward.z))));
        }

        /// <summary>Null if the radar has the kernel, or the project has none.</summary>
        public static Fix AssignKernel(RadarController radar) => Assign(radar, "Trace.compute", ProjectAssets.Kernel,
            radar.Kernel, (it, kernel) => it.Kernel = kernel);

        /// <inheritdoc cref="AssignKernel"/>
        public static Fix AssignTubeKernel(RadarController radar) => Assign(radar, "Amplitude.compute",
            ProjectAssets.TubeKernel, radar.TubeKernel, (it, kernel) => it.TubeKernel = kernel);

        /// <inheritdoc cref="AssignKernel"/>
        public static Fix AssignClutterKernel(RadarController radar) => Assign(radar, "Tubes.compute",
            ProjectAssets.TubesKernel, radar.ClutterKernel, (it, kernel) => it.ClutterKernel = kernel);

        static Fix Assign(RadarController radar, string file, ComputeShader kernel, ComputeShader current,
            Action<RadarController, ComputeShader> set) => kernel == null || current == kernel ? null
                : new Fix($"Assign {file}", () => Fix.Change(radar, $"Assign {file}", it => set(it, kernel)));

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

        // A separate mesh asset, or a mesh without a file.
        static bool IsOwn(Mesh mesh)
        {
            string path = AssetDatabase.GetAssetPath(mesh);
            return path.Length == 0 || path.EndsWith(".asset", StringComparison.Ordinal)
                || path.EndsWith(".mesh", StringComparison.Ordinal);
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
