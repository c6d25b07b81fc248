using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The meshes of a radar screen on the device: their BVHs, and the points of their surfaces that echo. Instances move
    /// without a wait for the device and without an allocation.
    /// </summary>
    sealed class ScreenTargets : IDisposable
    {
        /// <summary>Rows of an instance in _SurfaceFrames of Shaders/ScreenTargets.hlsl.</summary>
        const int FrameRows = 4;

        readonly string _owner;
        readonly ScreenGeometry _geometry;
        readonly DeviceScene _scene;
        readonly DeviceBuffer<SurfaceSample> _points = new DeviceBuffer<SurfaceSample>("points of surfaces");
        readonly DeviceBuffer<float4> _frames = new DeviceBuffer<float4>("rows of instances"),
            _scatter = new DeviceBuffer<float4>("surfaces");
        float4[] _rows = Array.Empty<float4>();

        /// <param name="owner">Name of the owner, for messages.</param>
        public ScreenTargets(string owner, ScreenGeometry geometry)
        {
            (_owner, _geometry) = (owner, geometry);
            _scene = new DeviceScene(BvhLayout.Binary, owner, long.MaxValue);
        }

        /// <summary>Points of the surfaces.</summary>
        public int Count { get; private set; }

        /// <inheritdoc cref="SurfaceSamples.Spacing"/>
        public double Spacing { get; private set; }

        /// <summary>Bytes on the device.</summary>
        public long Bytes => _scene.Bytes + _points.Bytes + _frames.Bytes + _scatter.Bytes;

        /// <summary>Sets the scene: builds the BVHs of new meshes, and lays points on all surfaces.</summary>
        /// <param name="isOwnShip">
        /// Of each instance: paths that meet only such instances have no echo, but they shade what is behind.
        /// </param>
        /// <exception cref="GlintException">
        /// The scene is too large for the device, or a material has no data at the radar's frequency.
        /// </exception>
        public void SetScene(RadarScene scene, bool[] isOwnShip)
        {
            Count = 0; // until everything is complete
            _scene.Set(scene, new TraceStatistics(), (mesh, layout) => MeshBvh.Build(mesh, layout));
            _scene.RequireOnePage(_owner, "a radar screen takes", ", or leave layers out");
            var samples = SurfaceSamples.Of(scene, _geometry.CellSize / 2, _owner);
            _points.Upload(samples.Points);
            _scatter.Upload(scene.Surfaces.Select(ScatterOf).ToArray());
            _rows = new float4[FrameRows * scene.Instances.Length];
            for (int i = 0; i < isOwnShip.Length; i++)
                _rows[FrameRows * i + 3].x = isOwnShip[i] ? 1 : 0;
            _frames.Reserve(Math.Max(1, _rows.Length));
            WriteFrames();
            (Count, Spacing) = (samples.Points.Length, samples.Spacing);
        }

        /// <summary>Takes the instances of the scene to where they are now.</summary>
        public void Move()
        {
            _scene.Move();
            WriteFrames();
        }

        /// <summary>Sets what a kernel of Shaders/ScreenTargets.hlsl reads.</summary>
        /// <param name="antenna">In the scene's frame, metres.</param>
        /// <param name="seaLevel">Mean height of the sea in it.</param>
        /// <param name="northTurns">Rotation about Y from the scene's Z to north, turns.</param>
        public void Set(ComputeShader shader, int kernel, double3 antenna, double seaLevel, double northTurns)
        {
            var radar = _geometry.Radar;
            double north = 2 * Math.PI * northTurns;
            shader.SetBvhs(kernel, _scene);
            shader.SetBuffer(kernel, ScreenIDs._SurfaceSamples, _points.Buffer);
            shader.SetBuffer(kernel, ScreenIDs._SurfaceFrames, _frames.Buffer);
            shader.SetBuffer(kernel, ScreenIDs._SurfaceScatter, _scatter.Buffer);
            shader.SetInt(ScreenIDs._SurfaceSampleCount, Count);
            shader.SetVector(ScreenIDs._ScreenAntenna,
                (antenna - _scene.Centre).ToVector((float)(antenna.y - seaLevel)));
            shader.SetVector(ScreenIDs._ScreenNorth, new Vector4((float)Math.Cos(north), (float)Math.Sin(north),
                (float)(AntennaPattern.GaussianExponent(_geometry.BeamWidth) / 2), 0));
            shader.SetVector(ScreenIDs._ScreenWaves, new Vector4((float)(1 / Signal.Wavelength(radar.Frequency)),
                (float)radar.SeaReflection, (float)(1 / (2 * ClutterGeometry.EarthRadius)), 0));
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _scene.Dispose();
            _points.Dispose();
            _frames.Dispose();
            _scatter.Dispose();
        }

        void WriteFrames()
        {
            var instances = _scene.Scene.Instances;
            for (int i = 0; i < instances.Length; i++)
            {
                var place = instances[i].ToWorld;
                double3 origin = place.Origin - _scene.Centre;
                _rows[FrameRows * i] = (float4)new double4(place.X.x, place.Y.x, place.Z.x, origin.x);
                _rows[FrameRows * i + 1] = (float4)new double4(place.X.y, place.Y.y, place.Z.y, origin.y);
                _rows[FrameRows * i + 2] = (float4)new double4(place.X.z, place.Y.z, place.Z.z, origin.z);
            }
            if (_rows.Length > 0)
                _frames.Write(_rows, 0, 0, _rows.Length);
        }

        float4 ScatterOf(SurfaceMaterial surface)
        {
            // Both polarisations reflect the same at normal incidence.
            var reflected = surface.Reflection(1, _geometry.Radar.Frequency).S;
            return new float4((float)(4 * surface.Slope * surface.Slope), (float)PowerLevel.FromDecibels(surface.GammaDb),
                (float)PowerLevel.Of(reflected), 0);
        }
    }
}
