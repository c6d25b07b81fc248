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

        /// <summary>Dispatches at least as many threads, in rows of groups; none for 0.</summary>
        public static void DispatchThreads(this ComputeShader shader, int kernel, long threads)
        {
            int size = shader.GroupOf(kernel), groups = (int)((threads + size - 1) / size),
                across = TraceKernel.GroupsARow;
            if (groups > 0)
                shader.Dispatch(kernel, math.min(groups, across), (groups + across - 1) / across, 1);
        }

        /// <summary>Sets a double-float: the number rounded to float32, and its Lo part.</summary>
        public static void SetNumber(this ComputeShader shader, int id, double value) =>
            shader.SetVector(id, new Vector4((float)value, DoubleFloat.Lo(value), 0, 0));
    }
}
