using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>What the classes of kernels call on their shader.</summary>
    static class KernelCalls
    {
        /// <summary>Threads of a group.</summary>
        public static int GroupOf(this ComputeShader shader, int kernel)
        {
            shader.GetKernelThreadGroupSizes(kernel, out uint size, out _, out _);
            return (int)size;
        }

        /// <summary>Most threads of a dispatch of any kernel.</summary>
        public const long MaxThreads = (long)TraceKernel.MaxTiles * PictureTiles.Rays;

        /// <summary>Dispatches at least as many threads, in rows of groups; none for 0.</summary>
        /// <exception cref="GlintException">They are more than a device dispatches at once.</exception>
        public static void DispatchThreads(this ComputeShader shader, int kernel, long threads)
        {
            int across = TraceKernel.GroupsARow;
            long size = shader.GroupOf(kernel), groups = (threads + size - 1) / size;
            if (groups > TraceKernel.MaxTiles)
                throw new GlintException(FormattableString.Invariant($"compute shader '{shader.name}' needs {threads:N0} ")
                    + FormattableString.Invariant($"threads at once, and a device takes {size * TraceKernel.MaxTiles:N0}: ")
                    + "the scene has too many triangles");
            if (groups > 0)
                shader.Dispatch(kernel, (int)Math.Min(groups, across), (int)((groups + across - 1) / across), 1);
        }

        /// <summary>Sets the rays of a picture.</summary>
        public static void SetRays(this ComputeShader shader, RayGrid grid)
        {
            shader.SetPoint(ShaderIDs._Origin, grid.Origin);
            shader.SetPoint(ShaderIDs._OriginDx, grid.OriginDx);
            shader.SetPoint(ShaderIDs._OriginDy, grid.OriginDy);
            shader.SetPoint(ShaderIDs._Direction, grid.Direction);
            shader.SetPoint(ShaderIDs._DirectionDx, grid.DirectionDx);
            shader.SetPoint(ShaderIDs._DirectionDy, grid.DirectionDy);
            shader.SetNumber(ShaderIDs._OriginDepth, grid.OriginDepth);
            shader.SetVector(ShaderIDs._ReferencePixel,
                new Vector4(grid.ReferencePixel.x, grid.ReferencePixel.y, 0, 0));
        }

        /// <summary>Sets the receiver.</summary>
        public static void SetReceiver(this ComputeShader shader, in RadarView view, RayGrid grid)
        {
            shader.SetPoint(ShaderIDs._ReceiverCentre, view.ReceiverCentre - grid.SceneCentre);
            shader.SetPoint(ShaderIDs._ReceiverRight, view.ReceiverRight);
            shader.SetPoint(ShaderIDs._ReceiverUp, view.ReceiverUp);
            shader.SetPoint(ShaderIDs._ReceiverForward, view.ReceiverForward);
            double2 half = view.ReceiverSize / 2;
            shader.SetVector(ShaderIDs._ReceiverHalfSize,
                new Vector4((float)half.x, DoubleFloat.Lo(half.x), (float)half.y, DoubleFloat.Lo(half.y)));
        }

        /// <summary>Sets the BVHs, instances and ranges of a scene.</summary>
        public static void SetBvhs(this ComputeShader shader, int kernel, DeviceScene scene)
        {
            shader.SetInt(ShaderIDs._InstanceBvhRoot, (int)scene.InstanceBvhRoot);
            shader.SetBuffer(kernel, ShaderIDs._InstanceBvh, scene.InstanceBvhRows.Buffer);
            shader.SetBuffer(kernel, ShaderIDs._Instances, scene.Instances.Buffer);
            shader.SetBuffer(kernel, ShaderIDs._Ranges, scene.Ranges.Buffer);
            // Every page that a kernel declares needs a buffer, even if it is not read.
            for (int page = 0; page < DeviceBvhs.MaxPages; page++)
                shader.SetBuffer(kernel, ShaderIDs._Bvh[page],
                    scene.Pages[page < scene.Pages.Count ? page : 0].Rows.Buffer);
        }

        /// <summary>A vector rounded to float32, and a fourth number.</summary>
        public static Vector4 ToVector(this double3 v, float w = 0) => new Vector4((float)v.x, (float)v.y, (float)v.z, w);

        /// <summary>Sets three double-floats: the numbers rounded to float32, and their Lo parts.</summary>
        public static void SetPoint(this ComputeShader shader, (int value, int lo) id, double3 v)
        {
            shader.SetVector(id.value, new Vector4((float)v.x, (float)v.y, (float)v.z, 0));
            shader.SetVector(id.lo, new Vector4(DoubleFloat.Lo(v.x), DoubleFloat.Lo(v.y), DoubleFloat.Lo(v.z), 0));
        }

        /// <summary>Sets a double-float: the number rounded to float32, and its Lo part.</summary>
        public static void SetNumber(this ComputeShader shader, int id, double value) =>
            shader.SetVector(id, new Vector4((float)value, DoubleFloat.Lo(value), 0, 0));
    }
}
