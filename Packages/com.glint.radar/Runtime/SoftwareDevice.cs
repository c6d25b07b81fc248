using System;
using UnityEngine;

namespace Glint
{
    /// <summary>Graphics devices that are programs: they want another kernel than a GPU.</summary>
    static class SoftwareDevice
    {
        static readonly string[] s_names = { "llvmpipe", "SwiftShader", "Microsoft Basic Render" };

        public static bool IsInUse => Array.Exists(s_names,
            name => SystemInfo.graphicsDeviceName.Contains(name, StringComparison.OrdinalIgnoreCase));
    }
}
