using Glint.Core;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint
{
    /// <summary>
    /// Words on their way from the device. Where the device can, it works on meanwhile (AsyncGPUReadback); the words
    /// are those at the time of the request. Elsewhere they are read at once.
    /// </summary>
    sealed class Readback
    {
        readonly uint[] _words;
        AsyncGPUReadbackRequest _request;
        bool _hasWords;

        /// <summary>Requests a whole buffer.</summary>
        public Readback(DeviceBuffer<uint> buffer)
        {
            _words = new uint[buffer.Capacity];
            if (SystemInfo.supportsAsyncGPUReadback)
                // The data is there in the frame of the callback only.
                _request = AsyncGPUReadback.Request(buffer.Buffer, Take);
            else
            {
                buffer.ReadBack(_words, _words.Length);
                _hasWords = true;
            }
        }

        /// <summary>Waits until the device no longer needs the buffer.</summary>
        public void Complete()
        {
            if (_hasWords)
                return;
            _request.WaitForCompletion();
            if (!_hasWords)
                Take(_request);
        }

        /// <summary>Waits for the words.</summary>
        /// <exception cref="GlintException">The device could not deliver them.</exception>
        public uint[] Wait()
        {
            Complete();
            return _hasWords
                ? _words
                : throw new GlintException($"{SystemInfo.graphicsDeviceName} did not deliver the sums of a pose: "
                    + "trace it again, and check the graphics driver if it recurs");
        }

        void Take(AsyncGPUReadbackRequest request)
        {
            if (request.hasError)
                return;
            NativeArray<uint>.Copy(request.GetData<uint>(), _words);
            _hasWords = true;
        }
    }
}
