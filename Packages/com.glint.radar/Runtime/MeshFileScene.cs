using Glint.Core;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>The objects that stand for a mesh file in a scene: the mesh, a radar that looks at it, and the radar's receiver.</summary>
    public sealed class MeshFileScene
    {
        // As in the published experiment.
        const float ReceiverBehindCamera = 0.2f;

        MeshFileScene(Transform target, RadarController radar)
        {
            Target = target;
            Radar = radar;
        }

        /// <summary>The mesh; its origin is the file's.</summary>
        public Transform Target { get; }

        public RadarController Radar { get; }

        /// <summary>Makes the objects in the active scene.</summary>
        /// <param name="file">Triangles in metres.</param>
        /// <param name="stand">Where the radar stands.</param>
        /// <param name="settings">Frequency, rays, bounces.</param>
        /// <param name="receiverSize">Width and height in metres.</param>
        /// <param name="kernel">Shaders/Trace.compute.</param>
        public static MeshFileScene Create(MeshFile file, in RadarStand stand, in RadarSettings settings, Vector2 receiverSize, ComputeShader kernel)
        {
            var target = MakeObject(file);

            var camera = new GameObject("Radar Camera").AddComponent<Camera>();
            var rotation = Quaternion.Euler((float)stand.GrazingDegrees, (float)stand.AzimuthDegrees, 0);
            var aim = new Vector3((float)stand.Aim.x, (float)stand.Aim.y, (float)stand.Aim.z);
            camera.transform.SetPositionAndRotation(aim - rotation * Vector3.forward * (float)stand.Distance, rotation);
            camera.fieldOfView = (float)stand.VerticalFovDegrees;

            var receiver = new GameObject("Receiver").transform;
            receiver.SetParent(camera.transform, false);
            receiver.localPosition = new Vector3(0, 0, -ReceiverBehindCamera);

            var radar = camera.gameObject.AddComponent<RadarController>();
            radar.Settings = settings;
            radar.Receiver = receiver;
            radar.ReceiverSize = receiverSize;
            radar.Kernel = kernel;
            return new MeshFileScene(target, radar);
        }

        /// <summary>The mesh as an object of the active scene, at the origin.</summary>
        internal static Transform MakeObject(MeshFile file)
        {
            var made = new GameObject(file.Name);
            made.AddComponent<MeshFilter>().sharedMesh = MakeMesh(file);
            made.AddComponent<MeshRenderer>();
            return made.transform;
        }

        static Mesh MakeMesh(MeshFile file)
        {
            var vertices = System.Array.ConvertAll(file.Vertices, v => new Vector3(v.x, v.y, v.z));
            var mesh = new Mesh { name = file.Name, indexFormat = IndexFormat.UInt32 };
            mesh.SetVertices(vertices);
            mesh.SetIndices(file.Indices, MeshTopology.Triangles, 0);
            return mesh;
        }
    }
}
