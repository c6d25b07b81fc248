using Glint.Core;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>What every trace needs of the graphics device and of its shader.</summary>
    static class DeviceCheck
    {
        /// <summary>Refuses a device that cannot trace.</summary>
        /// <exception cref="GlintException">The message says why, and the way out.</exception>
        public static void RequireDevice()
        {
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null)
                throw new GlintException("there is no graphics device (graphics device type Null): "
                    + "start Unity without -nographics");
            if (!SystemInfo.supportsComputeShaders)
                throw new GlintException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) runs no "
                    + "compute shaders: use Vulkan or Direct3D 11 or 12");
            if (SystemInfo.graphicsDeviceType == GraphicsDeviceType.OpenGLES3)
                throw new GlintException($"{SystemInfo.graphicsDeviceName} (OpenGLES3) does not guarantee the rounding "
                    + "that path lengths need, as OpenGL ES has no 'precise': use Vulkan");
        }

        /// <summary>Refuses a device that cannot trace, and a shader that is missing or another one.</summary>
        /// <param name="name">Of the shader's file in Packages/com.glint.radar/Shaders.</param>
        /// <param name="kernel">A kernel that only this shader has.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">The message says why, and the way out.</exception>
        public static void Require(ComputeShader shader, string name, string kernel, string owner)
        {
            RequireDevice();
            if (shader == null)
                throw new GlintException($"{owner} has no kernel: "
                    + $"assign Packages/com.glint.radar/Shaders/{name}.compute");
            if (!shader.HasKernel(kernel))
                throw new GlintException($"{owner}: compute shader '{shader.name}' has no kernel '{kernel}': "
                    + $"assign Packages/com.glint.radar/Shaders/{name}.compute");
            RequireSupported(shader, shader.FindKernel(kernel));
        }

        /// <summary>Refuses kernels that the device does not run.</summary>
        /// <exception cref="GlintException">A kernel did not compile for the device.</exception>
        public static void RequireSupported(ComputeShader shader, params int[] kernels)
        {
            foreach (int kernel in kernels)
                if (!shader.IsSupported(kernel))
                    throw new GlintException($"a kernel of compute shader '{shader.name}' does not run on "
                        + $"{SystemInfo.graphicsDeviceName}: see the shader's import messages");
        }
    }
}
