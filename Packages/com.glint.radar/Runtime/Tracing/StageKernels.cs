using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>The small kernels between those that trace: Shaders/Stages.hlsl.</summary>
    sealed class StageKernels
    {
        readonly ComputeShader _shader;
        readonly int _clear, _count, _choose, _forget;

        /// <param name="shader">Shaders/Trace.compute.</param>
        public StageKernels(ComputeShader shader)
        {
            _shader = shader;
            _clear = shader.FindKernel("ClearSums");
            _count = shader.FindKernel("CountGroups");
            _choose = shader.FindKernel("ChooseSubRays");
            _forget = shader.FindKernel("ForgetLengths");
        }

        /// <summary>Sets the picture and the groups of the kernels that trace.</summary>
        public void Set(in RadarSettings settings, int traceGroup, int refineGroup)
        {
            _shader.SetInt(ShaderIDs._RaysAcross, settings.RaysAcross);
            _shader.SetInts(ShaderIDs._Region, TraceKernel.RegionOf(settings));
            _shader.SetInt(ShaderIDs._TraceGroup, traceGroup);
            _shader.SetInt(ShaderIDs._RefineGroup, refineGroup);
            _shader.SetNumber(ShaderIDs._MaxSlope, PixelPhase.MaxSlope(settings.Wavelength));
            _shader.SetNumber(ShaderIDs._MaxBend, PixelPhase.MaxSecondDifference(settings.Wavelength));
            _shader.SetNumber(ShaderIDs._MaxTwist, PixelPhase.MaxSlopeDifference(settings.Wavelength));
        }

        /// <summary>Sets how candidates are listed.</summary>
        public void SetLists(CandidateList ofRays, CandidateList ofSubRays)
        {
            _shader.SetInts(ShaderIDs._KnownCapacity, ofRays.KnownCapacity, ofSubRays.KnownCapacity, 0, 0);
            _shader.SetInt(ShaderIDs._MaxSpread, ofRays.MaxSpread);
        }

        /// <summary>Clears sums and counts.</summary>
        public void ClearSums(DeviceBuffer<uint> sums)
        {
            _shader.SetBuffer(_clear, ShaderIDs._Sums, sums.Buffer);
            _shader.DispatchThreads(_clear, WorkCounts.ReceivedRays);
        }

        /// <summary>Writes the groups of the indirect dispatches.</summary>
        public void CountGroups(DeviceBuffer<uint> sums, GraphicsBuffer arguments)
        {
            _shader.SetBuffer(_count, ShaderIDs._Sums, sums.Buffer);
            _shader.SetBuffer(_count, ShaderIDs._Arguments, arguments);
            _shader.Dispatch(_count, 1, 1, 1);
        }

        /// <summary>Chooses the pixels that get sub-rays.</summary>
        public void ChooseSubRays(DeviceBuffer<uint> sums, CandidateList candidates, DeviceBuffer<uint> lengths,
            DeviceBuffer<uint> chosen, GraphicsBuffer arguments)
        {
            _shader.SetBuffer(_choose, ShaderIDs._ChosenPixels, chosen.Buffer);
            DispatchCandidates(_choose, sums, candidates, lengths, arguments);
        }

        /// <summary>Removes the lengths of the received rays.</summary>
        public void ForgetLengths(DeviceBuffer<uint> sums, CandidateList candidates, DeviceBuffer<uint> lengths,
            GraphicsBuffer arguments) => DispatchCandidates(_forget, sums, candidates, lengths, arguments);

        void DispatchCandidates(int kernel, DeviceBuffer<uint> sums, CandidateList candidates,
            DeviceBuffer<uint> lengths, GraphicsBuffer arguments)
        {
            _shader.SetInt(ShaderIDs._HasSubRays, 0);
            _shader.SetInt(ShaderIDs._FirstSearched, 0);
            _shader.SetBuffer(kernel, ShaderIDs._Sums, sums.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Candidates, candidates.Rays.Buffer);
            _shader.SetBuffer(kernel, ShaderIDs._Lengths, lengths.Buffer);
            _shader.DispatchIndirect(kernel, arguments, SliceArguments.Refine);
        }
    }
}
