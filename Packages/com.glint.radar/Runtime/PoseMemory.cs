using System;
using System.Linq;
using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// What a pose takes, before it is traced. Trees count with what they take at least;
    /// the buffers of a dispatch as if it took all tiles of the picture, or as many as one may.
    /// <see cref="WorkDone.BytesOnDevice"/> of a result says what it took.
    /// </summary>
    struct PoseMemory
    {
        /// <summary>Bytes of all buffers on the device.</summary>
        public double DeviceBytes;

        /// <summary>
        /// Bytes here: meshes, a copy of their trees, and all rays if all are kept.
        /// Received rays, whose number is not known, are not in it.
        /// </summary>
        public double HostBytes;

        public static PoseMemory Of(in RadarPose pose, KeptRays keep, bool isSoftware)
        {
            var instances = pose.Scene.Instances;
            var meshes = instances.Select(instance => instance.Mesh).Distinct().ToArray();
            double trees = DeviceTrees.LeastBytes(meshes, isSoftware ? TreeShape.Wide : TreeShape.Binary);
            double places =
                instances.Length * (Size<InstanceRecord>() + TopTree.LeastRowsPerBox(TreeShape.Binary) * 16);
            long tiles = PictureTiles.CountIn(pose.Settings);
            return new PoseMemory
            {
                DeviceBytes = trees + places + tiles * (double)sizeof(uint) + BytesADispatch(tiles, keep,
                    instances.Length <= DeviceScene.MostFew && RayTracer.StartsPay(tiles, isSoftware)),
                HostBytes = trees + meshes.Sum(mesh => mesh.Vertices.Length * (double)Size<float3>()
                        + mesh.Indices.Length * (double)sizeof(int))
                    + (keep == KeptRays.All ? pose.Settings.RaysEmitted * (double)Size<RayData>() : 0),
            };
        }

        static double BytesADispatch(long tiles, KeptRays keep, bool usesStarts)
        {
            tiles = Math.Min(tiles, Math.Min(TraceKernel.MostTiles, ExactPass.MostTiles));
            if (keep == KeptRays.All)
                tiles = Math.Min(tiles, KeptRayList.MostTiles);
            double rays = (double)tiles * PictureTiles.Rays;
            double kept =
                keep == KeptRays.All ? rays : keep == KeptRays.Received ? Math.Min(rays, ExactPass.MostRays) : 1;
            return RaySums.Slots * RaySums.WordsPerSlot * sizeof(uint)
                + rays * Size<ReceivedRay>() + kept * Size<RayData>()
                + (usesStarts ? tiles * (double)DeviceScene.MostFew * Size<uint4>() : 0);
        }

        static int Size<T>() where T : struct => Marshal.SizeOf<T>();
    }
}
