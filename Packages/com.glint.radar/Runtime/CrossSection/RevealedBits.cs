using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Bits of what attempts have found of each pose, from which later attempts learn what to divide: those of the attempts
    /// before, which kernels read, and those by now, which they set. The order in which cells are traced does not matter then.
    /// </summary>
    sealed class RevealedBits : IDisposable
    {
        readonly ComputeShader _shader;
        readonly int _clear, _take;
        readonly DeviceBuffer<uint> _before = new DeviceBuffer<uint>("bits of attempts before");
        readonly DeviceBuffer<uint> _byNow = new DeviceBuffer<uint>("bits by now");
        readonly DeviceBuffer<uint> _beginning = new DeviceBuffer<uint>("poses that begin");
        int _wordsOfPose;

        /// <param name="shader">Shaders/Tubes.compute or Amplitude.compute.</param>
        public RevealedBits(ComputeShader shader)
        {
            _shader = shader;
            _clear = shader.FindKernel("ClearRevealed");
            _take = shader.FindKernel("TakeRevealed");
        }

        /// <summary>Makes room for the bits of poses, and hands them to the kernels that read and set them.</summary>
        public void Bind(int poses, int wordsOfPose, IEnumerable<int> reading, int setting)
        {
            _wordsOfPose = wordsOfPose;
            _before.Reserve((long)poses * wordsOfPose);
            _byNow.Reserve((long)poses * wordsOfPose);
            _shader.SetInt(TubeIDs._RevealedWords, wordsOfPose);
            foreach (int kernel in reading)
                _shader.SetBuffer(kernel, TubeIDs._Revealed, _before.Buffer);
            _shader.SetBuffer(_take, TubeIDs._WrittenRevealed, _before.Buffer);
            foreach (int kernel in new[] { setting, _clear, _take })
                _shader.SetBuffer(kernel, TubeIDs._RevealedByNow, _byNow.Buffer);
        }

        /// <summary>Clears those by now, which the first attempts take.</summary>
        public void Clear(int poses) => _shader.DispatchThreads(_clear, (long)_wordsOfPose * poses);

        /// <summary>
        /// Takes those by now for poses that begin an attempt. A slice that is traced again must not read what it has set itself.
        /// </summary>
        public void Take(IEnumerable<int> beginning)
        {
            var poses = beginning.Select(pose => (uint)pose).ToArray();
            if (poses.Length == 0)
                return;
            _beginning.Upload(poses);
            _shader.SetBuffer(_take, TubeIDs._Beginning, _beginning.Buffer);
            _shader.SetInt(TubeIDs._BeginningCount, poses.Length);
            _shader.DispatchThreads(_take, (long)_wordsOfPose * poses.Length);
        }

        public void Dispose()
        {
            _before.Dispose();
            _byNow.Dispose();
            _beginning.Dispose();
        }
    }
}
