using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The factors that bring the sea of a radar screen to a published level, over direction and grazing angle: from the
    /// mean echo of its own at the time of the first frame, which waits for the device.
    /// </summary>
    sealed class ScreenSeaLevels : IDisposable
    {
        /// <summary>Directions, each with a table: SEA_DIRECTIONS in Shaders/ScreenSeaLevels.hlsl.</summary>
        public const int Directions = 8;

        /// <summary>Facets of a mean: SEA_MEAN_FACETS.</summary>
        public const int Facets = 4096;

        readonly DeviceBuffer<float4> _levels = new DeviceBuffer<float4>("levels of a sea");
        int _count;

        /// <summary>Whether there are tables, or none are needed.</summary>
        public bool AreMade { get; private set; }

        /// <summary>Sets the tables.</summary>
        public void Set(ComputeShader shader, int kernel)
        {
            shader.SetInt(SeaIDs._SeaLevelCount, _count);
            shader.SetBuffer(kernel, SeaIDs._SeaLevels, _levels.Buffer);
        }

        /// <summary>Makes the tables.</summary>
        /// <param name="setSea">Sets what means of the sea need for a kernel.</param>
        /// <exception cref="GlintException">The model does not hold for the sea.</exception>
        public void Make(ComputeShader shader, SeaClutter clutter, double frequency, Action<int> setSea)
        {
            var model = ClutterModel.Of(clutter.Settings.Level);
            var tables = Array.Empty<ClutterLevelTable>();
            if (model != null)
                tables = TablesOf(shader, model, clutter, frequency, setSea);
            _levels.Upload(tables.SelectMany(table => table.Values).ToArray());
            (_count, AreMade) = (tables.Length == 0 ? 0 : tables[0].Values.Count, true);
        }

        /// <summary>Releases the buffer on the device.</summary>
        public void Dispose() => _levels.Dispose();

        static ClutterLevelTable[] TablesOf(ComputeShader shader, ClutterModel model, SeaClutter clutter, double frequency,
            Action<int> setSea)
        {
            Func<double, ClutterConditions> At(int direction) =>
                grazing => clutter.ConditionsAt(frequency, 360.0 * direction / Directions, grazing);
            double[] angles = ClutterLevelTable.AnglesOf(model, At(0)).ToArray();
            int kernel = shader.FindKernel("ScreenSeaMean");
            var means = new float[Directions * angles.Length * Facets];
            using (var buffer = new DeviceBuffer<float>("facets of a mean"))
            {
                buffer.Reserve(means.Length);
                setSea(kernel);
                shader.SetBuffer(kernel, ScreenIDs._SeaMeans, buffer.Buffer);
                for (int view = 0; view < Directions * angles.Length; view++)
                {
                    double3 toRadar = RadarAspect.At(360.0 * (view / angles.Length) / Directions,
                        angles[view % angles.Length]).ToRadar;
                    shader.SetVector(ScreenIDs._SeaMeanView, toRadar.ToVector(view));
                    shader.DispatchThreads(kernel, Facets);
                }
                buffer.ReadBack(means, means.Length);
            }
            return Enumerable.Range(0, Directions).Select(direction => new ClutterLevelTable(model, angles,
                angles.Select((_, angle) => MeanOf(means, direction * angles.Length + angle)).ToArray(),
                At(direction))).ToArray();
        }

        // The mean is that of the radar's polarisation, for which alone the factors are.
        static Sigma0 MeanOf(float[] means, int view)
        {
            double mean = new ArraySegment<float>(means, view * Facets, Facets).Sum(sigma => (double)sigma) / Facets;
            return new Sigma0(mean, mean, mean);
        }
    }
}
