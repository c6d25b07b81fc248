using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The kernels that divide cells in rounds and sum their tubes: of Shaders/Tubes.compute or Amplitude.compute.
    /// </summary>
    sealed class TubeRounds : IDisposable
    {
        /// <summary>Words of the arguments of the indirect dispatches, and their byte offsets: _ARGUMENTS.</summary>
        public const int ArgumentWords = 30;

        /// <inheritdoc cref="ArgumentWords"/>
        public const uint BorderArguments = 0, CellArguments = 12, TubeArguments = 24, BisectArguments = 36,
            CornerArguments = 48, CentreArguments = 60, OutlineArguments = 72, WholeArguments = 84, ChangeArguments = 96,
            BorderRayArguments = 108;

        // Rays that a thread traces at most: a software device ends a thread's loops after 65,535 iterations in all.
        readonly int _raysAThread = SoftwareDevice.IsInUse ? 4 : 32;

        readonly ComputeShader _shader;
        readonly int _clear, _corners, _cells, _prepareBorders, _bisect, _borders, _prepareCells, _sums;
        readonly RayKernels _rays;
        readonly int? _borderRays;
        int _summing;                      // _sums or another kernel
        TubeLists _lists;
        readonly GraphicsBuffer _arguments = new GraphicsBuffer(
            GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw, ArgumentWords, sizeof(uint));

        /// <summary>Kernels beside that of the cells, which traces no rays then.</summary>
        public sealed class RayKernels
        {
            /// <summary>Before it, that of sides of divided cells, which traces none either.</summary>
            public readonly int Reveals;

            /// <summary>After: groups for those that the kernel of the cells has listed.</summary>
            public readonly int Prepare;

            /// <summary>
            /// Then those beside outlines, those through the centres of cells, and of border cells that are summed as a whole.
            /// </summary>
            public readonly int Outlines, Centres, Wholes;

            /// <summary>After all rounds: those of tubes again, at a finite range.</summary>
            public readonly int Changes;

            public RayKernels(ComputeShader shader)
            {
                Reveals = shader.FindKernel("TubeReveals");
                Prepare = shader.FindKernel("PrepareRays");
                Outlines = shader.FindKernel("TubeOutlines");
                Centres = shader.FindKernel("TubeCentres");
                Wholes = shader.FindKernel("TubeWholes");
                Changes = shader.FindKernel("TubeChanges");
            }
        }

        /// <param name="corners">Name of the kernel that traces the rays through the corners of cells.</param>
        /// <param name="cells">Name of the kernel that takes a thread for a cell.</param>
        /// <param name="borders">Name of the kernel of border cells.</param>
        /// <param name="rays">Null: the kernel of the cells traces their rays.</param>
        /// <param name="borderRays">Name of the kernel that traces those of border cells; null: their own kernel does.</param>
        public TubeRounds(ComputeShader shader, string corners, string cells, string borders, RayKernels rays = null,
            string borderRays = null)
        {
            (_shader, _rays) = (shader, rays);
            _clear = shader.FindKernel("ClearTubes");
            _corners = shader.FindKernel(corners);
            _cells = shader.FindKernel(cells);
            _prepareBorders = shader.FindKernel("PrepareBorders");
            _bisect = shader.FindKernel("TubeBisect");
            _borders = shader.FindKernel(borders);
            _prepareCells = shader.FindKernel("PrepareCells");
            _sums = shader.FindKernel("TubeSums");
            _summing = _sums;
            Kernels = new[] { _corners, _cells, _bisect, _borders };
            if (borderRays != null)
            {
                _borderRays = shader.FindKernel(borderRays);
                Kernels = Kernels.Append(_borderRays.Value).ToArray();
            }
            if (rays != null)
                Kernels = Kernels.Concat(new[]
                {
                    rays.Reveals, rays.Outlines, rays.Centres, rays.Wholes, rays.Changes
                }).ToArray();
        }

        /// <summary>Whether currents change along tubes: at a finite range.</summary>
        public bool FindsChanges { get; set; }

        /// <summary>The kernel of corners.</summary>
        public int Corners => _corners;

        /// <summary>The kernel TubeSums.</summary>
        public int Summing => _sums;

        /// <summary>The kernels of corners, cells, borders and rays.</summary>
        public int[] Kernels { get; }

        /// <summary>Sums tubes by another kernel; null: by TubeSums.</summary>
        public void SumBy(int? kernel) => _summing = kernel ?? _sums;

        /// <summary>Sets the lists that the kernels leave to each other.</summary>
        public void SetLists(TubeLists lists)
        {
            _lists = lists;
            var stages = new List<int> { _clear, _prepareBorders, _prepareCells };
            if (_rays != null)
                stages.Add(_rays.Prepare);
            foreach (int kernel in stages)
                _shader.SetBuffer(kernel, ShaderIDs._Arguments, _arguments);
            foreach (int kernel in Kernels.Concat(stages).Append(_sums))
                _shader.SetBuffer(kernel, ShaderIDs._Sums, lists.Output.Buffer);
            foreach (int kernel in Kernels.Append(_sums))
                _shader.SetBuffer(kernel, TubeIDs._Tubes, lists.Tubes.Buffer);
            foreach (int kernel in Kernels)
            {
                _shader.SetBuffer(kernel, TubeIDs._Borders, lists.Borders.Buffer);
                if (_rays == null)
                    continue;
                _shader.SetBuffer(kernel, TubeIDs._Centres, lists.Centres.Buffer);
                _shader.SetBuffer(kernel, TubeIDs._Outlines, lists.Outlines.Buffer);
            }
            _shader.SetBuffer(_sums, TubeIDs._WaveNumbers, lists.WaveNumbers.Buffer);
            _shader.SetInts(TubeIDs._ListCapacity, lists.Tubes.Capacity, lists.CellCapacity, lists.Borders.Capacity / 2,
                lists.Centres.Capacity / TubeLists.CentreWords);
        }

        /// <summary>Clears counts and sums.</summary>
        public void Clear(int count)
        {
            _shader.SetInt(TubeIDs._ClearedWords, count);
            _shader.DispatchThreads(_clear, count);
        }

        /// <summary>Traces base cells, in rounds the parts of those that are divided, and sums the tubes.</summary>
        /// <param name="count">Of the base cells.</param>
        /// <param name="corners">Of their corners.</param>
        /// <param name="bisections">Of the sides of a base cell at most.</param>
        public void Trace(int count, int corners, int rounds, int bisections)
        {
            for (int round = 0; round < rounds; round++)
            {
                SetRound(round);
                Dispatch(_corners, round, corners, CornerArguments);
                if (_rays != null && round > 0)
                    _shader.DispatchIndirect(_rays.Reveals, _arguments, CellArguments);
                Dispatch(_cells, round, count, CellArguments);
                if (_rays != null)
                {
                    _shader.Dispatch(_rays.Prepare, 1, 1, 1);
                    _shader.DispatchIndirect(_rays.Outlines, _arguments, OutlineArguments);
                    _shader.DispatchIndirect(_rays.Centres, _arguments, CentreArguments);
                }
                _shader.Dispatch(_prepareBorders, 1, 1, 1);
                for (int step = 0; step < Math.Max(2, bisections - 2 * round); step += _raysAThread)
                {
                    _shader.SetInts(TubeIDs._BisectSteps, step, step + _raysAThread);
                    _shader.DispatchIndirect(_bisect, _arguments, BisectArguments);
                }
                if (_borderRays is int borderRays)
                    _shader.DispatchIndirect(borderRays, _arguments, BorderRayArguments);
                _shader.DispatchIndirect(_borders, _arguments, BorderArguments);
                if (_rays != null)
                    _shader.DispatchIndirect(_rays.Wholes, _arguments, WholeArguments);
                _shader.Dispatch(_prepareCells, 1, 1, 1);
            }
            if (FindsChanges)
                _shader.DispatchIndirect(_rays.Changes, _arguments, ChangeArguments);
            _shader.DispatchIndirect(_summing, _arguments, TubeArguments);
        }

        // Rounds read what the one before has written.
        void SetRound(int round)
        {
            _shader.SetInt(TubeIDs._Round, round);
            int now = round & 1;
            foreach (int kernel in Kernels)
            {
                _shader.SetBuffer(kernel, TubeIDs._TubeCells, _lists.Cells[now].Buffer);
                _shader.SetBuffer(kernel, TubeIDs._NextCells, _lists.Cells[1 - now].Buffer);
                if (_rays == null)
                    continue;
                _shader.SetBuffer(kernel, TubeIDs._Corners, _lists.Corners[now].Buffer);
                _shader.SetBuffer(kernel, TubeIDs._CornersBefore, _lists.Corners[1 - now].Buffer);
            }
        }

        void Dispatch(int kernel, int round, int count, uint arguments)
        {
            if (round == 0)
                _shader.DispatchThreads(kernel, count);
            else
                _shader.DispatchIndirect(kernel, _arguments, arguments);
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
