using System;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Tests
{
    static class TestKernels
    {
        /// <summary>True if the wide kernels exist: in the headless host, which defines the symbol.</summary>
#if GLINT_HOST
        public const bool HasWide = true;
#else
        public const bool HasWide = false;
#endif

        /// <summary>Values of asSoftware of a <see cref="RayTracer"/>: true only if the wide kernels exist.</summary>
        public static readonly bool[] AsSoftware = HasWide ? new[] { true, false } : new[] { false };

        public static ComputeShader Trace => Load("Packages/com.glint.radar/Shaders/Trace.compute");

        public static ComputeShader Tubes => Load("Packages/com.glint.radar/Shaders/Tubes.compute");

        public static ComputeShader Amplitude => Load("Packages/com.glint.radar/Shaders/Amplitude.compute");

        public static ComputeShader Layout => Load("Packages/com.glint.tests/EditMode/Shaders/Layout.compute");

        public static ComputeShader TubeLayout => Load("Packages/com.glint.tests/EditMode/Shaders/TubeLayout.compute");

        public static ComputeShader DoubleFloat =>
            Load("Packages/com.glint.tests/EditMode/Shaders/DoubleFloat.compute");

        public static ComputeShader Channels => Load("Packages/com.glint.tests/EditMode/Shaders/Channels.compute");

        public static ComputeShader FastMath => Load("Packages/com.glint.tests/EditMode/Shaders/FastMath.compute");

        public static ComputeShader Shadow => Load("Packages/com.glint.tests/EditMode/Shaders/Shadow.compute");

        public static ComputeShader Speckle => Load("Packages/com.glint.tests/EditMode/Shaders/Speckle.compute");

        public static ComputeShader Backprojection => Load("Packages/com.glint.radar/Shaders/Backprojection.compute");

        public static ComputeShader SeaField => Load("Packages/com.glint.radar/Shaders/SeaField.compute");

        public static ComputeShader Screen => Load("Packages/com.glint.radar/Shaders/Screen.compute");

        public static ComputeShader SeaFieldLayout =>
            Load("Packages/com.glint.tests/EditMode/Shaders/SeaFieldLayout.compute");

        public static ComputeShader SeaMarch => Load("Packages/com.glint.tests/EditMode/Shaders/SeaMarch.compute");

        /// <summary>The tracer's kernels with other group sizes.</summary>
        public static ComputeShader OtherGroups =>
            Load("Packages/com.glint.tests/EditMode/Shaders/OtherGroups.compute");

        /// <summary>One pose of a mesh in world axes with the product's kernel.</summary>
        public static RadarResult TraceOnce(TriangleMesh mesh, in RadarSettings settings, in RadarView view,
            RayReadback readback = RayReadback.Received)
        {
            using (var tracer = new RayTracer(Trace))
            {
                return tracer.Trace(new RadarPose(new RadarScene(mesh), settings, view), readback);
            }
        }

        static ComputeShader Load(string path)
        {
            var shader = AssetDatabase.LoadAssetAtPath<ComputeShader>(path);
            return shader != null ? shader : throw new InvalidOperationException($"{path} is missing");
        }
    }
}
