using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The sea of a radar screen: a height field that moves, and what its facets scatter back. It is one tile that
    /// repeats, without choppiness.
    /// </summary>
    sealed class ScreenSea : IDisposable
    {
        /// <summary>Largest depth of a facet in metres, up to <see cref="MaxFacets"/> a cell.</summary>
        const double FacetDepth = 10;

        const int MaxFacets = 8;

        readonly SeaField _field;
        readonly SeaClutter _clutter;
        readonly FacetTable _table;
        readonly ScreenGeometry _geometry;
        readonly double _breakingAcceleration;
        readonly DeviceBuffer<float4> _values = new DeviceBuffer<float4>("elements of a table of facets");
        readonly ScreenSeaLevels _levels = new ScreenSeaLevels();

        /// <param name="shader">Shaders/SeaField.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">
        /// A setting is out of its range, the grid of the waves is finer than a field's, or the device runs no kernels.
        /// </exception>
        public ScreenSea(ComputeShader shader, string owner, ScreenGeometry geometry, SeaSettings waves,
            in SeaClutterSettings clutter)
        {
            // Facets are those of the field's grid.
            (waves.Cells, waves.Choppiness) = (SeaField.Side, 0);
            var surface = new SeaSurface(waves);
            double angle = math.radians(waves.WindDirectionDegrees);
            _geometry = geometry;
            _clutter = new SeaClutter(surface, 0, new double3(Math.Sin(angle), 0, Math.Cos(angle)), clutter);
            _table = _clutter.TableAt(geometry.Radar.Frequency);
            _breakingAcceleration = BreakingAcceleration(surface);
            FacetsOfACell = (int)Math.Max(1, Math.Min(MaxFacets, Math.Ceiling(geometry.CellSize / FacetDepth)));
            _field = new SeaField(shader, owner, surface);
            SeaSigma.Upload(_table, _values);
        }

        /// <summary>Facets along the range of a cell.</summary>
        public int FacetsOfACell { get; }

        /// <summary>The height field.</summary>
        public SeaField Field => _field;

        /// <summary>Moves the sea to a time. It waits for nothing.</summary>
        public void Update(double timeSeconds) => _field.Update(timeSeconds);

        /// <summary>Sets what the kernels of Shaders/ScreenSea.hlsl read.</summary>
        /// <param name="radar">Position of the antenna in the sea's frame, metres: y above the mean level.</param>
        /// <param name="northTurns">Rotation about Y from the sea's Z to north, turns.</param>
        /// <exception cref="GlintException">The published level does not hold for the sea.</exception>
        public void Set(ComputeShader shader, int kernel, double3 radar, double northTurns)
        {
            if (!_levels.AreMade)
                MakeLevels(shader);
            SetFacets(shader, kernel, northTurns);
            _levels.Set(shader, kernel);
            _field.SetMarch(shader, kernel, radar);
            shader.SetInt(ScreenIDs._ScreenSeaSeed, (int)_clutter.Seed);
        }

        void MakeLevels(ComputeShader shader) => _levels.Make(shader, _clutter, _geometry.Radar.Frequency, mean =>
        {
            SetFacets(shader, mean, 0);
            _field.SetMarch(shader, mean, default, double.PositiveInfinity);
        });

        void SetFacets(ComputeShader shader, int kernel, double northTurns)
        {
            shader.SetBuffer(kernel, SeaIDs._FacetTable, _values.Buffer);
            shader.SetVector(SeaIDs._SeaWind, _clutter.Wind.ToVector());
            SeaSigma.SetMirrorPoints(shader, _table);
            shader.SetVector(ScreenIDs._ScreenSea, new Vector4((float)northTurns, FacetsOfACell,
                (float)_breakingAcceleration, 0));
            bool isHorizontal = _geometry.Radar.Polarisation == ScreenPolarisation.Horizontal;
            shader.SetVector(ScreenIDs._ScreenSeaCorner, new Vector4(_clutter.Wind.x > 0 ? 0 : 1,
                _clutter.Wind.z > 0 ? 0 : 1, isHorizontal ? 2 : 0, (float)_geometry.FillFactor));
        }

        // That of the fraction of the grid's points that breaks.
        double BreakingAcceleration(SeaSurface surface)
        {
            double[] accelerations = surface.Accelerations(0);
            Array.Sort(accelerations);
            int count = (int)Math.Round(_clutter.BreakingFraction * accelerations.Length);
            return count > 0 ? accelerations[Math.Min(count, accelerations.Length - 1)] : double.NegativeInfinity;
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _field.Dispose();
            _values.Dispose();
            _levels.Dispose();
        }
    }
}
