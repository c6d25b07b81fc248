using Glint.Core;
using Glint.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// <c>glint reflector</c>: the corner reflector of the published experiment and its radar, each as a prefab.
    /// </summary>
    static class CornerReflectorAssets
    {
        const string Reflector = "Corner Reflector", Radar = "Corner Reflector Radar", MainCameraTag = "MainCamera";

        const float CameraDepth = -1; // Unity's default for a scene's main camera

        /// <summary>Writes both prefabs.</summary>
        /// <returns>The exit code: 0 done.</returns>
        /// <exception cref="GlintException">A file cannot be written, or the kernel is missing.</exception>
        public static int Write(CommandLine line, IProgressSink progress)
        {
            string folder = ProjectAssets.StoredFolder("CornerReflector");
            foreach (var root in new[] { MakeReflector(), MakeRadar() })
            {
                string path = $"{folder}/{root.name}.prefab";
                ProjectAssets.SavePrefab(root, path);
                progress.Print(ProjectAssets.Shown(path));
            }
            return Batch.Done;
        }

        /// <summary>Three cubes scaled to plates, about the turning point.</summary>
        public static GameObject MakeReflector()
        {
            var reflector = new GameObject(Reflector);
            var axes = CornerReflector.Axes;
            var frame = new GameObject("Frame").transform;
            frame.SetParent(reflector.transform, false);
            frame.localPosition = ToVector(axes.Origin);
            frame.localRotation = Quaternion.LookRotation(ToVector(axes.Z), ToVector(axes.Y));
            for (int normal = 0; normal < 3; normal++)
            {
                var (boxMin, boxMax) = CornerReflector.Plate(normal);
                var plate = GameObject.CreatePrimitive(PrimitiveType.Cube).transform;
                plate.name = $"Plate {"XYZ"[normal]}";
                plate.SetParent(frame, false);
                plate.localPosition = ToVector((boxMin + boxMax) / 2);
                plate.localScale = ToVector(boxMax - boxMin);
            }
            return reflector;
        }

        // The camera is a child, because Unity stores position and rotation of a prefab's root with each scene.
        static GameObject MakeRadar()
        {
            var root = new GameObject(Radar);
            var camera = new GameObject("Radar Camera", typeof(Camera)) { tag = MainCameraTag };
            camera.transform.SetParent(root.transform, false);
            camera.transform.localPosition = ToVector(CornerReflector.View.Position);
            camera.transform.localRotation = Quaternion.Euler((float)CornerReflector.PitchDegrees, 0, 0);
            camera.GetComponent<Camera>().depth = CameraDepth;

            var receiver = new GameObject("Receiver").transform;
            receiver.SetParent(camera.transform, false);
            receiver.localPosition = ToVector(CornerReflector.ReceiverOffset);
            receiver.localRotation = Quaternion.Euler(-(float)CornerReflector.ReceiverTiltDegrees, 0, 0);

            var radar = camera.AddComponent<RadarController>();
            (radar.Kernel, radar.Receiver) = (ProjectAssets.Kernel, receiver);
            camera.AddComponent<RayPaths>();
            return root;
        }

        static Vector3 ToVector(double3 v) => new Vector3((float)v.x, (float)v.y, (float)v.z);
    }
}
