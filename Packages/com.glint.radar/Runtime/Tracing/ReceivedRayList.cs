using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>The received rays of a pose, unordered.</summary>
    sealed class ReceivedRayList
    {
        // Of the largest array of 8 bytes an element in Unity's runtime.
        const int MaxCount = 0x7fffffc7 / 8;

        ReceivedRay[] _rays = Array.Empty<ReceivedRay>();

        /// <summary>The rays, from the array's start.</summary>
        public ReceivedRay[] Rays => _rays;

        public int Count { get; private set; }

        /// <summary>Adds the rays of a slice's output.</summary>
        public void Add(uint[] words, int count)
        {
            Reserve(count);
            for (int i = 0, word = WorkCounts.ReceivedRays; i < count; i++, word += 2)
                _rays[Count++] = new ReceivedRay { Pixel = words[word], Length = math.asfloat(words[word + 1]) };
        }

        public void Add(IReadOnlyList<ReceivedRay> rays)
        {
            Reserve(rays.Count);
            foreach (var ray in rays)
                _rays[Count++] = ray;
        }

        /// <summary>The pixels in ascending order.</summary>
        public uint[] Pixels()
        {
            var pixels = new uint[Count];
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = _rays[i].Pixel;
            Array.Sort(pixels);
            return pixels;
        }

        void Reserve(int count)
        {
            long needed = Count + (long)count;
            if (needed > MaxCount)
                throw new GlintException(FormattableString.Invariant($"{needed:N0} rays were received, and a pose holds ")
                    + FormattableString.Invariant($"{MaxCount:N0}: trace fewer rays, or a part of the picture"));
            if (needed > _rays.Length)
                Array.Resize(ref _rays, (int)Math.Min(MaxCount, Math.Max(needed, 2L * _rays.Length)));
        }
    }
}
