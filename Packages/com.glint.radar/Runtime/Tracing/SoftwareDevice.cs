using System;
using UnityEngine;

namespace Glint
{
    /// <summary>Graphics devices that are programs: wide trees suit them better than binary ones.</summary>
    static class SoftwareDevice
    {
        static readonly string[] s_names = { "llvmpipe", "SwiftShader", "Microsoft Basic Render" };

        public static bool IsInUse => Array.Exists(s_names,
            name => SystemInfo.graphicsDeviceName.Contains(name, StringComparison.OrdinalIgnoreCase));

        /// <summary>
        /// Loads Shaders/Wide~/TraceWide.compute; set by the headless host. Null in Unity, which ignores that folder,
        /// so that an import need not compile its kernels: a software device runs those for GPUs there, which take
        /// about twice as long and give the same results.
        /// </summary>
        public static Func<ComputeShader> LoadWideShader { get; set; }

        /// <summary>The shader with the wide kernels; null where there is none.</summary>
        public static ComputeShader WideShader => LoadWideShader?.Invoke();

        /// <summary>Whether rays are traced by the wide kernels.</summary>
        public static bool UsesWideKernels => IsInUse && WideShader != null;
    }
}
