using System;
using UnityEngine;

namespace Glint
{
    /// <summary>Software graphics devices, for which wide BVHs are faster than binary ones.</summary>
    public static class SoftwareDevice
    {
        static readonly string[] s_names = { "llvmpipe", "SwiftShader", "Microsoft Basic Render" };

        /// <summary>Whether Unity renders on a software device.</summary>
        public static bool IsInUse => Array.Exists(s_names,
            name => SystemInfo.graphicsDeviceName.Contains(name, StringComparison.OrdinalIgnoreCase));

        /// <summary>
        /// Loads Shaders/Wide~/TraceWide.compute; set by the headless host. Null in Unity, which ignores that folder
        /// and thus compiles no wide kernels on import: a software device runs the kernels for GPUs there, in about
        /// twice the time, with the same results.
        /// </summary>
        public static Func<ComputeShader> LoadWideShader { get; set; }

        /// <summary>The shader with the wide kernels; null if there is none.</summary>
        public static ComputeShader WideShader => LoadWideShader?.Invoke();

        /// <summary>Whether rays are traced by the wide kernels.</summary>
        public static bool UsesWideKernels => IsInUse && WideShader != null;
    }
}
