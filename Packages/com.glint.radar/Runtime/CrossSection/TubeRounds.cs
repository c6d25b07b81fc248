using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The kernels that divide cells in rounds and sum their tubes: of Shaders/Tubes.compute or Amplitude.compute.
    /// </summary>
    sealed class TubeRounds : IDisposable
    {
        /// <summary>Words of the arguments of the indirect dispatches, and their byte offsets: _ARGUMENTS.</summary>
        public const int ArgumentWords = 15;

        // Rays that a thread traces at most: a software device ends a thread's loops after 65,535 iterations in all.
        readonly int _raysAThread = SoftwareDevice.IsInUse ? 4 : 32;

        /// <inheritdoc cref="ArgumentWords"/>
        public const uint BorderArguments = 0, CellArguments = 12, TubeArguments = 24, BisectArguments = 36, CornerArguments = 48;

        readonly ComputeShader _shader;
        readonly int _clear, _cells, _prepareBorders, _bisect, _borders, _prepareCells, _sums;
        readonly int? _corners;
        int _summing;                      // _sums or another kernel
        readonly GraphicsBuffer _arguments = new GraphicsBuffer(
            GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw, ArgumentWords, sizeof(uint));

        /// <param name="cells">Name of the kernel that takes a thread for a cell.</param>
        /// <param name="borders">Name of the kernel that takes a thread for a border cell.</param>
        /// <param name="corners">
        /// Name of the kernel that takes a thread for a corner of cells, before that of the cells; null: none.
        /// </param>
        public TubeRounds(ComputeShader shader, string cells, string borders, string corners = null)
        {
            _shader = shader;
            _corners = corners == null ? (int?)null : shader.FindKernel(corners);
            _clear = shader.FindKernel("ClearTubes");
            _cells = shader.FindKernel(cells);
            _prepareBorders = shader.FindKernel("PrepareBorders");
            _bisect = shader.FindKernel("TubeBisect");
            _borders = shader.FindKernel(borders);
            _prepareCells = shader.FindKernel("PrepareCells");
            _sums = shader.FindKernel("TubeSums");
            _summing = _sums;
            Tracing = new[] { _cells, _bisect, _borders };
            if (_corners is int traced)
                Tracing = Tracing.Append(traced).ToArray();
        }

        /// <summary>The kernel TubeSums.</summary>
        public int Summing => _sums;

        /// <summary>The kernels that trace rays.</summary>
        public int[] Tracing { get; }

        /// <summary>An element of _WaveNumbers in Shaders/TubeBindings.hlsl.</summary>
        /// <param name="time">Of the sample, seconds.</param>
        public static float4 WaveNumber(double frequency, double time = 0)
        {
            double turns = 1 / Signal.Wavelength(frequency);
            return new float4((float)(2 * Math.PI * turns), (float)turns, DoubleFloat.Lo(turns), (float)time);
        }

        /// <summary>Sums tubes by another kernel; null: by TubeSums.</summary>
        public void SumBy(int? kernel) => _summing = kernel ?? _sums;

        /// <summary>Sets how finely cells are divided and borders found.</summary>
        /// <param name="cellError">Error that a cell may have, of its coefficient times area.</param>
        /// <param name="maxLevel">Divisions of a base cell at most.</param>
        /// <param name="maxBisections">Of the sides of a base cell towards a border.</param>
        public void SetAccuracy(double cellError, int maxLevel, int maxBisections)
        {
            _shader.SetFloat(TubeIDs._CellError, (float)cellError);
            _shader.SetInt(TubeIDs._MaxLevel, maxLevel);
            _shader.SetInt(TubeIDs._MaxBisections, maxBisections);
        }

        /// <summary>Sets the lists that the kernels leave to each other.</summary>
        /// <param name="cellCapacity">Cells of a round at most: the list may be longer.</param>
        public void SetLists(DeviceBuffer<uint> output, DeviceBuffer<Tube> tubes, DeviceBuffer<TubeCell> cells,
            DeviceBuffer<TubeCell> borders, DeviceBuffer<float4> waveNumbers, int cellCapacity)
        {
            foreach (int kernel in Tracing.Concat(new[] { _clear, _prepareBorders, _prepareCells, _sums }))
                _shader.SetBuffer(kernel, ShaderIDs._Sums, output.Buffer);
            foreach (int kernel in new[] { _cells, _bisect, _borders, _sums })
                _shader.SetBuffer(kernel, TubeIDs._Tubes, tubes.Buffer);
            foreach (int kernel in Tracing)
            {
                _shader.SetBuffer(kernel, TubeIDs._TubeCells, cells.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Borders, borders.Buffer);
            }
            foreach (int kernel in new[] { _prepareBorders, _prepareCells })
                _shader.SetBuffer(kernel, ShaderIDs._Arguments, _arguments);
            _shader.SetBuffer(_sums, TubeIDs._WaveNumbers, waveNumbers.Buffer);
            _shader.SetInts(TubeIDs._ListCapacity, tubes.Capacity, cellCapacity, borders.Capacity, 0);
        }

        /// <summary>Clears counts and sums.</summary>
        public void Clear(int count)
        {
            _shader.SetInt(TubeIDs._ClearedWords, count);
            _shader.DispatchThreads(_clear, count);
        }

        /// <summary>Traces base cells, in rounds the parts of those that are divided, and sums the tubes.</summary>
        /// <param name="count">Of the base cells.</param>
        /// <param name="corners">Of their corners, if a kernel takes them.</param>
        public void Trace(int count, int corners, int rounds, int bisections)
        {
            for (int round = 0; round < rounds; round++)
            {
                _shader.SetInt(TubeIDs._Round, round);
                if (_corners is int kernel)
                {
                    if (round == 0)
                        _shader.DispatchThreads(kernel, corners);
                    else
                        _shader.DispatchIndirect(kernel, _arguments, CornerArguments);
                }
                if (round == 0)
                    _shader.DispatchThreads(_cells, count);
                else
                    _shader.DispatchIndirect(_cells, _arguments, CellArguments);
                _shader.Dispatch(_prepareBorders, 1, 1, 1);
                for (int step = 0; step < Math.Max(2, bisections - 2 * round); step += _raysAThread)
                {
                    _shader.SetInts(TubeIDs._BisectSteps, step, step + _raysAThread);
                    _shader.DispatchIndirect(_bisect, _arguments, BisectArguments);
                }
                _shader.DispatchIndirect(_borders, _arguments, BorderArguments);
                _shader.Dispatch(_prepareCells, 1, 1, 1);
            }
            _shader.DispatchIndirect(_summing, _arguments, TubeArguments);
        }

        /// <summary>Sums tubes that another kernel has listed.</summary>
        public void Sum()
        {
            _shader.Dispatch(_prepareCells, 1, 1, 1);
            _shader.DispatchIndirect(_summing, _arguments, TubeArguments);
        }

        public void Dispose() => _arguments.Dispose();
    }
}
