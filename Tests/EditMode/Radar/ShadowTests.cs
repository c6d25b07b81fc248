using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The kernel's shadow query against the reference tracer's.</summary>
    public sealed class ShadowTests
    {
        const int Rays = 4096;

        [Test]
        public void AnyHit_RandomRaysInClutter_IsAsTheReferenceSays([Values("Shadow", "ShadowRefine")] string kernel)
        {
            var scene = new RadarScene(
                new MeshInstance { Mesh = TestRadar.Clutter(500, seed: 3), ToWorld = Affine.Identity },
                new MeshInstance
                {
                    Mesh = TestRadar.Trihedral(0, 6),
                    ToWorld = Affine.FromTransform(double3(-1, 2, 3), double4(0.1, 0.7, -0.3, 0.6), double3(1, 1, -1.2))
                });
            var bvh = new ReferenceBvh(scene);
            using (var device = new DeviceScene(BvhLayout.Binary, "test", long.MaxValue))
            {
                device.Set(scene, new TraceStatistics(), (mesh, layout) => MeshBvh.Build(mesh, layout));
                var rays = RandomRays();
                var shadows = Ask(device, kernel, rays);
                int hits = 0, ambiguous = 0;
                for (int i = 0; i < Rays; i++)
                {
                    double3 origin = device.Centre + double3(rays[2 * i].xyz) - bvh.Centre,
                        direction = double3(rays[2 * i + 1].xyz);
                    float reach = rays[2 * i].w;
                    ambiguous += shadows[i] >> 1 != 0 ? 1 : 0;
                    bool expected = bvh.AnyHit(origin, direction, reach);
                    hits += expected ? 1 : 0;
                    bool isAtReach = bvh.AnyHit(origin, direction, reach - 1e-3)
                        != bvh.AnyHit(origin, direction, reach + 1e-3);
                    if (shadows[i] < 2 && !isAtReach)
                        Assert.That(shadows[i] == 1, Is.EqualTo(expected), $"ray {i}");
                }
                Assert.That(hits, Is.InRange(Rays / 10, Rays * 9 / 10));
                Assert.That(ambiguous, Is.LessThan(Rays / 100));
            }
        }

        // Two rows for each ray: its origin relative to the scene's centre and the query's length; its direction.
        static float4[] RandomRays()
        {
            var random = new System.Random(7);
            float Next() => 2 * (float)random.NextDouble() - 1;
            var rays = new float4[2 * Rays];
            for (int i = 0; i < Rays; i++)
            {
                rays[2 * i] = float4(12 * Next(), 12 * Next(), 12 * Next(), 10.5f + 9.5f * Next());
                rays[2 * i + 1] = float4(normalize(float3(Next(), Next(), Next())), 0);
            }
            return rays;
        }

        static uint[] Ask(DeviceScene scene, string name, float4[] rays)
        {
            var shader = TestKernels.Shadow;
            int kernel = shader.FindKernel(name);
            var rayBuffer = new ComputeBuffer(rays.Length, 16);
            var shadows = new ComputeBuffer(Rays, 4);
            try
            {
                rayBuffer.SetData(rays);
                shader.SetBuffer(kernel, "_RayIn", rayBuffer);
                shader.SetBuffer(kernel, "_Shadows", shadows);
                shader.SetBuffer(kernel, "_InstanceBvh", scene.InstanceBvhRows.Buffer);
                shader.SetBuffer(kernel, "_Instances", scene.Instances.Buffer);
                shader.SetBuffer(kernel, "_Bvh0", scene.Pages[0].Rows.Buffer);
                shader.SetInt("_InstanceBvhRoot", (int)scene.InstanceBvhRoot);
                shader.SetVector("_SceneCentreExtent", new Vector4(0, 0, 0, 40));
                shader.Dispatch(kernel, Rays / 64, 1, 1);
                var result = new uint[Rays];
                shadows.GetData(result);
                return result;
            }
            finally
            {
                rayBuffer.Release();
                shadows.Release();
            }
        }
    }
}
