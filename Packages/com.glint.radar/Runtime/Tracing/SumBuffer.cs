using System;
using Glint.Core;

namespace Glint
{
    /// <summary>The channels' sums on the device: cleared before a dispatch, read back after it.</summary>
    sealed class SumBuffer : IDisposable
    {
        readonly string _owner;
        readonly DeviceBuffer<uint> _buffer = new DeviceBuffer<uint>("sums");
        readonly uint[] _zeros = new uint[Channel.Slots * Channel.WordsPerSlot];
        readonly uint[] _words = new uint[Channel.Slots * Channel.WordsPerSlot];

        /// <param name="owner">Name of the owner, for messages.</param>
        public SumBuffer(string owner)
        {
            _owner = owner;
            _buffer.Reserve(_zeros.Length);
        }

        public DeviceBuffer<uint> Buffer => _buffer;

        public void Clear(TraceStatistics statistics)
        {
            _buffer.Upload(_zeros);
            statistics.BytesUploaded += _buffer.Bytes;
        }

        /// <summary>Reads back the words of a dispatch; valid until the next call.</summary>
        /// <exception cref="GlintException">A ray's part exceeds its channel's maximum.</exception>
        public uint[] ReadBack(TraceStatistics statistics)
        {
            _buffer.ReadBack(_words, _words.Length);
            statistics.Dispatches++;
            statistics.BytesReadBack += _buffer.Bytes;
            Channel.CheckOverflow(_words, _owner);
            return _words;
        }

        public void Dispose() => _buffer.Dispose();
    }
}
