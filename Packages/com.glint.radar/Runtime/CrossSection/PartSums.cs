using System.Collections.Generic;
using System.Linq;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// The sums of a receiver and frequency by parts of the scene, over all slices: TubeParts in Shaders/TubeSums.hlsl.
    /// </summary>
    sealed class PartSums
    {
        const int SumCount = TubeKernels.PartWords / 2;

        readonly SceneParts _parts;
        readonly int _firstWord, _receiver, _frequency;
        readonly TubeSums _units;
        readonly long[] _sums;

        /// <param name="firstWord">Of the parts, in the output.</param>
        /// <param name="units">Of the pose.</param>
        public PartSums(SceneParts parts, int firstWord, TubeSums units, int receiver, int frequency)
        {
            (_parts, _firstWord, _units, _receiver, _frequency) = (parts, firstWord, units, receiver, frequency);
            _sums = new long[parts.Count * SumCount];
        }

        /// <summary>Words of the output, those before the parts included.</summary>
        public int OutputSize => _firstWord + _parts.Count * TubeKernels.PartWords;

        /// <summary>Adds a slice.</summary>
        public void Add(uint[] output)
        {
            for (int i = 0; i < _sums.Length; i++)
                _sums[i] += TubeSums.At(output, _firstWord + 2 * i);
        }

        /// <summary>The contributions of the parts.</summary>
        public CrossSectionContributions ToContributions(IReadOnlyList<Polarisation> polarisations) =>
            CrossSectionContributions.Of(_parts, Objects(), part => MatrixOf(_sums, part * SumCount), polarisations);

        // An object has its edges and its triangles.
        ScatteringMatrix[] Objects()
        {
            var sums = new long[_parts.Objects.Count * SumCount];
            for (int part = 0; part < _parts.FirstBounce; part++)
            {
                int edges = part < _parts.TriangleCount ? _parts.EdgesOf(_parts.TriangleOf(part).Object) : part;
                for (int i = 0; i < SumCount; i++)
                    sums[(edges - _parts.TriangleCount) * SumCount + i] += _sums[part * SumCount + i];
            }
            return Enumerable.Range(0, _parts.Objects.Count).Select(i => MatrixOf(sums, i * SumCount)).ToArray();
        }

        ScatteringMatrix MatrixOf(long[] sums, int first) => _units.MatrixOf(sums, first, _receiver, _frequency);
    }
}
