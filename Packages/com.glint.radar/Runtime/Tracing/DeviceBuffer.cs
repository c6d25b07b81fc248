using System;
using System.Runtime.InteropServices;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>A structured buffer that grows on demand, and refuses more elements than the device can hold.</summary>
    sealed class DeviceBuffer<T> : IDisposable where T : struct
    {
        static readonly int s_stride = Marshal.SizeOf<T>();

        readonly string _content;
        GraphicsBuffer _buffer;

        /// <param name="content">Plural noun of the elements, for messages: "triangles".</param>
        public DeviceBuffer(string content) => _content = content;

        /// <summary>The buffer; null before the first <see cref="Reserve"/>.</summary>
        public GraphicsBuffer Buffer => _buffer;

        /// <summary>Bytes per element.</summary>
        public int Stride => s_stride;

        /// <summary>Bytes on the device.</summary>
        public long Bytes => (long)Capacity * s_stride;

        public int Capacity => _buffer == null ? 0 : _buffer.count;

        /// <summary>Maximum number of elements of one buffer on the device.</summary>
        public static long MaxCount => Math.Min(int.MaxValue, SystemInfo.maxGraphicsBufferSize / s_stride);

        /// <summary>Ensures a capacity; the content is lost if the buffer grows.</summary>
        /// <exception cref="GlintException">The device cannot hold as many in one buffer.</exception>
        public void Reserve(long count)
        {
            if (count > MaxCount)
                throw new GlintException($"{count} {_content} take {count * s_stride} bytes, "
                    + $"and {SystemInfo.graphicsDeviceName} holds at most {SystemInfo.maxGraphicsBufferSize} bytes in "
                    + $"one buffer: use at most {MaxCount} {_content}");
            if (count <= Capacity)
                return;
            Dispose();
            _buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, (int)count, s_stride);
        }

        /// <summary>Ensures the capacity and writes the elements.</summary>
        public void Upload(T[] elements)
        {
            // A binding must not be empty, even if the kernel does not read it.
            Reserve(Math.Max(1, elements.Length));
            if (elements.Length > 0)
                _buffer.SetData(elements);
        }

        /// <summary>Writes some elements; the rest stays.</summary>
        public void Write(T[] elements, int first, int firstOnDevice, int count) =>
            _buffer.SetData(elements, first, firstOnDevice, count);

        /// <summary>Reads the first elements into an array, after all earlier work has completed.</summary>
        public void ReadBack(T[] elements, int count)
        {
            if (count > 0)
                _buffer.GetData(elements, 0, 0, count);
        }

        public void Dispose()
        {
            _buffer?.Dispose();
            _buffer = null;
        }
    }
}
