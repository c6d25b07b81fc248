using System;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// What a slice leaves for the processor in one buffer: the channels' sums, the counts of its work lists, and its
    /// received rays.
    /// </summary>
    sealed class SliceOutput : IDisposable
    {
        // Received rays that the list holds at first; it grows with those of earlier slices.
        const int FirstCapacity = 1 << 12;

        // Maximum of the list. Those of more received rays are read from the list of candidates.
        const int MaxCapacity = 1 << 20;

        /// <summary>Bytes at first.</summary>
        public const double MinBytes = (WorkCounts.ReceivedRays + 2.0 * FirstCapacity) * sizeof(uint);

        readonly string _owner;
        readonly DeviceBuffer<uint> _buffer = new DeviceBuffer<uint>("sums and received rays");

        /// <param name="owner">Name of the owner, for messages.</param>
        public SliceOutput(string owner) => _owner = owner;

        public DeviceBuffer<uint> Buffer => _buffer;

        /// <summary>Received rays that the list holds.</summary>
        public int Capacity { get; private set; }

        /// <summary>Whether the list is to grow for as many received rays.</summary>
        public bool IsTooSmall(int received) => Capacity == 0 || received > Capacity && Capacity < MaxCapacity;

        /// <summary>Makes the list larger than for some received rays; no read-back may be in flight.</summary>
        public void Grow(int received)
        {
            Capacity = (int)Math.Min(MaxCapacity, Math.Max(FirstCapacity, 2L * received));
            _buffer.Reserve(WorkCounts.ReceivedRays + 2L * Capacity);
        }

        /// <summary>Sets the number of pixels with sub-rays.</summary>
        public void SetChosen(int count) => _buffer.Write(new[] { (uint)count }, 0, WorkCounts.ChosenWord, 1);

        /// <summary>The counts after all work dispatched so far.</summary>
        public WorkCounts ReadCounts(TraceStatistics statistics)
        {
            const int words = WorkCounts.ReceivedRays;
            var all = new uint[words];
            _buffer.ReadBack(all, words);
            statistics.RoundTrips++;
            statistics.BytesReadBack += words * sizeof(uint);
            return new WorkCounts(all, int.MaxValue);
        }

        /// <summary>Requests the words, as they are after all work dispatched so far.</summary>
        public Readback Request(TraceStatistics statistics)
        {
            statistics.RoundTrips++;
            statistics.BytesReadBack += _buffer.Bytes;
            return new Readback(_buffer);
        }

        /// <summary>The words of a read-back.</summary>
        /// <exception cref="GlintException">A ray's part exceeds its channel's maximum.</exception>
        public uint[] WordsOf(Readback readback)
        {
            var words = readback.Wait();
            Channel.CheckOverflow(words, _owner);
            return words;
        }

        public void Dispose()
        {
            _buffer.Dispose();
            Capacity = 0;
        }
    }
}
