using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using Complex = System.Numerics.Complex;

namespace Glint
{
    /// <summary>The kernel that finds where ships light the sea: Shaders/SeaLights.hlsl.</summary>
    sealed class ShipSeaKernel : IDisposable
    {
        /// <summary>Rows of a light: LIGHT_ROWS.</summary>
        public const int Rows = 10;

        const int Rays = 1 << 17;

        // Cells across a first grid, which gives the area that the rays share.
        const double RoughCells = 16;

        readonly ComputeShader _shader;
        readonly int _kernel;
        readonly DeviceBuffer<uint4> _lights = new DeviceBuffer<uint4>("lights of a sea");
        readonly DeviceBuffer<TubePose> _poses = new DeviceBuffer<TubePose>("poses of the lights of a sea");
        readonly DeviceBuffer<float4> _receivers = new DeviceBuffer<float4>("receivers of the lights of a sea");

        /// <param name="shader">Shaders/Tubes.compute.</param>
        public ShipSeaKernel(ComputeShader shader) => (_shader, _kernel) = (shader, shader.FindKernel("SeaLights"));

        /// <summary>The echo of a pose's seas and all else at each sample; null where there is nothing else.</summary>
        public ClutterEcho[] Sum(DeviceScene scene, SurfaceBuffers surfaces, CrossSectionPose pose)
        {
            var tiles = pose.Scene.SeaInstances();
            var (min, max) = new RadarScene(pose.Scene.Instances.Where((_, i) => !tiles.Contains(i)).ToArray()).Bound();
            if (!(min.x <= max.x))
                return null;
            // With the image in the water: on a curved earth the level is that of the nearest tile.
            double3 middle = (min + max) / 2;
            double level = tiles.Select(tile => pose.Scene.Instances[tile].ToWorld.Origin)
                .OrderBy(origin => math.distance(origin, middle)).First().y;
            min.y = Math.Min(min.y, 2 * level - max.y);
            var grid = GridOf(pose, scene, min, max);
            Bind(scene, surfaces, pose, grid);
            int count = (int)grid.Count;
            _shader.SetInt(SeaIDs._SeaLightCount, count);
            _shader.DispatchThreads(_kernel, count);
            var read = new uint4[Rows * count];
            _lights.ReadBack(read, read.Length);
            var echo = new ShipSeaEcho(pose);
            double direct = pose.NearerBy(scene.Centre), byRay = grid.PhaseOf(pose, pose.Radar) - direct;
            for (int i = 0; i < count; i++)
                if (read[Rows * i].w != 0)
                    echo.Add(LightOf(read, Rows * i, surfaces.Patches.Parts, direct, byRay), i);
            return echo.Echoes();
        }

        static TubeGrid GridOf(CrossSectionPose pose, DeviceScene scene, double3 min, double3 max)
        {
            double side = Math.Max(math.length(max - min), double.Epsilon) / RoughCells;
            var rough = new TubeGrid(pose, side, scene.Min, scene.Max, min, max);
            return new TubeGrid(pose, side * Math.Sqrt((double)rough.Count / Rays), scene.Min, scene.Max, min, max);
        }

        void Bind(DeviceScene scene, SurfaceBuffers surfaces, CrossSectionPose pose, TubeGrid grid)
        {
            _shader.SetBvhs(_kernel, scene);
            _shader.SetBuffer(_kernel, TubeIDs._Facets, surfaces.Patches.Facets.Buffer);
            _shader.SetBuffer(_kernel, TubeIDs._NormalFields, surfaces.Patches.NormalFields.Buffer);
            _shader.SetBuffer(_kernel, TubeIDs._InstanceFacets, surfaces.Patches.InstanceFacets.Buffer);
            _shader.SetBuffer(_kernel, TubeIDs._Motions, surfaces.Motions.Buffer);
            _shader.SetBuffer(_kernel, TubeIDs._Reflections, surfaces.Reflections.Buffer);
            _poses.Upload(new[] { new TubePose(pose, grid, 1) });
            _shader.SetBuffer(_kernel, TubeIDs._Poses, _poses.Buffer);
            _receivers.Upload(TubeKernels.ReceiverRows(pose, scene.Centre).ToArray());
            _shader.SetBuffer(_kernel, TubeIDs._Receivers, _receivers.Buffer);
            _lights.Reserve(Rows * grid.Count);
            _shader.SetBuffer(_kernel, SeaIDs._SeaLights, _lights.Buffer);
            TubeKernels.SetReceivers(_shader, pose);
            SeaKernel.SetFootprint(_shader, pose.Footprint, scene.Centre);
            _shader.SetVector(ShaderIDs._SceneCentreExtent,
                KernelCalls.ToVector(scene.Centre, (float)grid.Rays.SceneExtent));
            _shader.SetInt(ShaderIDs._MaxBounces, pose.MaxBounces);
            _shader.SetInt(TubeIDs._IsMonostatic, 1);
            _shader.SetInt(TubeIDs._IsMoving, 0);
        }

        static SeaLight LightOf(uint4[] rows, int first, SceneParts parts, double direct, double byRay)
        {
            float4 Row(int row) => math.asfloat(rows[first + row]);
            int instance = (int)rows[first].w - 1;
            float4 fieldV = Row(4), fieldH = Row(5), h = Row(3), normal = Row(6), radar = Row(7), radarV = Row(8),
                radarH = Row(9);
            return new SeaLight
            {
                Instance = instance, Triangle = (int)rows[first + 1].w - parts.FirstOf(instance),
                Direction = Row(1).xyz, V = Row(2).xyz, H = h.xyz, Normal = normal.xyz,
                SentVAlongV = new Complex(fieldV.x, fieldV.y), SentVAlongH = new Complex(fieldV.z, fieldV.w),
                SentHAlongV = new Complex(fieldH.x, fieldH.y), SentHAlongH = new Complex(fieldH.z, fieldH.w),
                StartSection = normal.w, Section = h.w, IsSeen = rows[first + 2].w != 0,
                ToRadar = radar.xyz, RadarV = radarV.xyz, RadarH = radarH.xyz, Strength = radarH.w,
                NearerDirect = radar.w + direct, NearerByRay = byRay - radarV.w
            };
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _lights.Dispose();
            _poses.Dispose();
            _receivers.Dispose();
        }
    }
}
