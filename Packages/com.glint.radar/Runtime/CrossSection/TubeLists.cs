using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>The lists that the kernels of ray tubes leave to each other: Shaders/TubeBindings.hlsl.</summary>
    sealed class TubeLists : IDisposable
    {
        /// <summary>Counts and sums.</summary>
        public DeviceBuffer<uint> Output { get; } = new DeviceBuffer<uint>("sums of tubes");

        public DeviceBuffer<Tube> Tubes { get; } = new DeviceBuffer<Tube>("tubes");

        /// <summary>Of even rounds and of odd ones.</summary>
        public DeviceBuffer<TubeCell>[] Cells { get; } = TwoOf<TubeCell>("cells of tubes");

        /// <summary>In the first half those that are cut.</summary>
        public DeviceBuffer<TubeCell> Borders { get; } = new DeviceBuffer<TubeCell>("border cells");

        /// <summary>Of even rounds and of odd ones; none for an amplitude.</summary>
        public DeviceBuffer<TubeCorner>[] Corners { get; } = TwoOf<TubeCorner>("corners of cells");

        /// <summary>Words of an element of <see cref="Centres"/>: CENTRE_WORDS in Shaders/TubeBindings.hlsl.</summary>
        public const int CentreWords = 5;

        /// <summary>None for an amplitude.</summary>
        public DeviceBuffer<uint> Centres { get; } = new DeviceBuffer<uint>("centres of cells");

        /// <inheritdoc cref="Centres"/>
        public DeviceBuffer<uint2> Outlines { get; } = new DeviceBuffer<uint2>("rays beside outlines");

        public DeviceBuffer<float4> WaveNumbers { get; } = new DeviceBuffer<float4>("frequencies");

        static DeviceBuffer<T>[] TwoOf<T>(string content) where T : struct =>
            new[] { new DeviceBuffer<T>(content), new DeviceBuffer<T>(content) };

        /// <summary>Cells of a round at most.</summary>
        public int CellCapacity { get; private set; }

        /// <summary>An element of _WaveNumbers in Shaders/TubeBindings.hlsl.</summary>
        /// <param name="time">Of the sample, seconds.</param>
        public static float4 WaveNumber(double frequency, double time = 0)
        {
            double turns = 1 / Core.Signal.Wavelength(frequency);
            return new float4((float)(2 * Math.PI * turns), (float)turns, DoubleFloat.Lo(turns), (float)time);
        }

        /// <summary>Ensures what all tracers need.</summary>
        /// <param name="capacity">Tubes, and border cells of each kind.</param>
        public void Reserve(int outputSize, int capacity, int cellCapacity, IEnumerable<float4> waveNumbers)
        {
            CellCapacity = cellCapacity;
            Output.Reserve(outputSize);
            Tubes.Reserve(capacity);
            Borders.Reserve(2L * capacity);
            foreach (var cells in Cells)
                cells.Reserve(cellCapacity);
            WaveNumbers.Upload(waveNumbers.ToArray());
        }

        /// <summary>Ensures what the rays of cross sections need.</summary>
        /// <param name="corners">Of a round, times their bounces.</param>
        /// <param name="centres">Base cells of a slice, or cells of a round, whichever are more.</param>
        public void ReserveRays(int corners, int centres)
        {
            foreach (var list in Corners)
                list.Reserve(corners);
            Centres.Reserve((long)CentreWords * centres);
            Outlines.Reserve(Tubes.Capacity);
        }

        public void Dispose()
        {
            Output.Dispose();
            Tubes.Dispose();
            Borders.Dispose();
            foreach (var cells in Cells)
                cells.Dispose();
            foreach (var corners in Corners)
                corners.Dispose();
            Centres.Dispose();
            Outlines.Dispose();
            WaveNumbers.Dispose();
        }
    }
}
