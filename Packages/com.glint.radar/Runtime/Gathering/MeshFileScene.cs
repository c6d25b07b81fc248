using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The objects of a mesh file in a scene: the mesh, a radar that looks at it, and the radar's receiver.
    /// </summary>
    public static class MeshFileScene
    {
        // As in the published experiment.
        const float ReceiverBehindCamera = 0.2f;

        internal const string ReceiverName = "Receiver";

        /// <summary>Makes the objects in the active scene.</summary>
        /// <param name="file">Triangles in metres.</param>
        /// <param name="placement">Pose, view and receiver of the radar.</param>
        /// <param name="settings">
        /// Frequency, rays, bounces. With parallel rays their spacing decides the number of rays.
        /// </param>
        /// <param name="kernel">Shaders/Trace.compute.</param>
        /// <exception cref="GlintException">The spacing takes too many rays.</exception>
        public static SweepSetup Create(MeshFile file, in RadarPlacement placement,
            in RadarSettings settings, ComputeShader kernel)
        {
            var target = MakeObject(file);

            var aim = new GameObject("Radar Aim").transform;
            aim.localPosition = new Vector3((float)placement.Aim.x, (float)placement.Aim.y, (float)placement.Aim.z);
            var camera = MakeChild("Radar Camera", aim, 0).gameObject.AddComponent<Camera>();

            var radar = camera.gameObject.AddComponent<RadarController>();
            radar.Settings = settings;
            radar.Receiver = MakeReceiver(camera.transform, placement.RaySpacing > 0);
            radar.ReceiverSize = new Vector2((float)placement.ReceiverSize.x, (float)placement.ReceiverSize.y);
            radar.Kernel = kernel;
            if (placement.RaySpacing > 0)
                MakeParallel(radar, camera, placement);
            else
                camera.fieldOfView = (float)placement.VerticalFovDegrees;
            return new SweepSetup(radar, SweepPlan.Single)
            {
                Target = target, Orbit = RadarOrbit.Of(aim, camera.transform, placement)
            };
        }

        static void MakeParallel(RadarController radar, Camera camera, in RadarPlacement placement)
        {
            camera.orthographic = true;
            radar.FitAperture = math.all(placement.ApertureSize == 0);
            radar.RaySpacing = placement.RaySpacing;
            if (radar.FitAperture)
                return;
            var pose = new RadarPose { Settings = radar.Settings };
            ApertureFit.Divide(placement.ApertureSize, placement.RaySpacing, ref pose, "aperture");
            radar.Settings = pose.Settings;
            camera.orthographicSize = (float)(pose.View.ApertureHeight / 2);
        }

        /// <summary>
        /// A receiver below a camera, as in the published experiment; that of parallel rays is in the aperture.
        /// </summary>
        public static Transform MakeReceiver(Transform camera, bool isParallel) =>
            MakeChild(ReceiverName, camera, isParallel ? 0 : -ReceiverBehindCamera);

        static Transform MakeChild(string name, Transform parent, float z)
        {
            var child = new GameObject(name).transform;
            child.SetParent(parent, false);
            child.localPosition = new Vector3(0, 0, z);
            return child;
        }

        /// <summary>
        /// The mesh as an object of the active scene, at the origin, with a <see cref="RadarSurface"/> for each
        /// material that the file names.
        /// </summary>
        public static Transform MakeObject(MeshFile file)
        {
            var made = new GameObject(file.Name);
            made.AddComponent<MeshFilter>().sharedMesh = MeshMaker.Make(file);
            made.AddComponent<MeshRenderer>();
            for (int i = 0; i < file.Surfaces.Count; i++)
                if (file.Surfaces[i].Material is string name)
                {
                    var surface = made.AddComponent<RadarSurface>();
                    surface.Material = RadarMaterial.Of(new SurfaceMaterial(name));
                    surface.Submesh = i;
                }
            return made.transform;
        }
    }
}
