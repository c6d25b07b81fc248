using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Threading.Tasks;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A 64-bit hash of a mesh's content, because Unity does not say when a mesh changes (<see cref="MeshWatch"/>). A
    /// change of one number always changes the hash, other changes with a probability of 1 - 10^-19. Valid within one
    /// run only.
    /// </summary>
    struct ContentHash
    {
        const ulong Factor = 0x9E3779B97F4A7C15; // odd, without pattern: 2^64 over the golden ratio

        // Numbers or points of a chunk for one core. It must not depend on the number of cores.
        public const int ChunkSize = 1 << 16;

        // Independent accumulators, so that products overlap in the pipeline.
        ulong _a, _b, _c, _d;

        public ulong Value => Mix(Mix(Mix(_a, _b), _c), _d);

        public void Add(int number) => _a = Mix(_a, (ulong)(uint)number + 1);

        public void Add(ulong bits) => _a = Mix(_a, bits);

        public void Add(float3 v)
        {
            Add(math.asint(v.x));
            Add(math.asint(v.y));
            Add(math.asint(v.z));
        }

        public void Add(in Affine transform)
        {
            Add(transform.X);
            Add(transform.Y);
            Add(transform.Z);
            Add(transform.Origin);
        }

        public void Add(List<Vector3> points)
        {
            Add(points.Count);
            if (points.Count > ChunkSize)
                AddChunks(points.Count, (from, to) => Of(points, from, to));
            else
                _a = Mix(_a, Of(points, 0, points.Count));
        }

        public void Add(List<int> numbers)
        {
            Add(numbers.Count);
            if (numbers.Count > ChunkSize)
                AddChunks(numbers.Count, (from, to) => Of(numbers, from, to));
            else
                _a = Mix(_a, Of(numbers, 0, numbers.Count));
        }

        void Add(double3 v)
        {
            Add(math.asulong(v.x));
            Add(math.asulong(v.y));
            Add(math.asulong(v.z));
        }

        // Hashes chunks on all cores, and combines them in order.
        void AddChunks(int count, Func<int, int, ulong> sumOf)
        {
            var sums = new ulong[(count + ChunkSize - 1) / ChunkSize];
            Parallel.For(0, sums.Length,
                chunk => sums[chunk] = sumOf(chunk * ChunkSize, Math.Min(count, (chunk + 1) * ChunkSize)));
            foreach (ulong sum in sums)
                _a = Mix(_a, sum);
        }

        static ulong Of(List<Vector3> points, int from, int to)
        {
            ulong a = 0, b = 0, c = 0, d = 0;
            int i = from;
            for (; i + 1 < to; i += 2)
            {
                Vector3 p = points[i], q = points[i + 1];
                a = Mix(a, Pair(math.asuint(p.x), math.asuint(p.y)));
                b = Mix(b, math.asuint(p.z));
                c = Mix(c, Pair(math.asuint(q.x), math.asuint(q.y)));
                d = Mix(d, math.asuint(q.z));
            }
            if (i < to)
            {
                a = Mix(a, Pair(math.asuint(points[i].x), math.asuint(points[i].y)));
                b = Mix(b, math.asuint(points[i].z));
            }
            return new ContentHash { _a = a, _b = b, _c = c, _d = d }.Value;
        }

        static ulong Of(List<int> numbers, int from, int to)
        {
            ulong a = 0, b = 0, c = 0, d = 0;
            int i = from;
            for (; i + 7 < to; i += 8)
            {
                a = Mix(a, Pair((uint)numbers[i], (uint)numbers[i + 1]));
                b = Mix(b, Pair((uint)numbers[i + 2], (uint)numbers[i + 3]));
                c = Mix(c, Pair((uint)numbers[i + 4], (uint)numbers[i + 5]));
                d = Mix(d, Pair((uint)numbers[i + 6], (uint)numbers[i + 7]));
            }
            for (; i < to; i++)
                a = Mix(a, (uint)numbers[i]);
            return new ContentHash { _a = a, _b = b, _c = c, _d = d }.Value;
        }

        static ulong Pair(uint lower, uint upper) => lower | (ulong)upper << 32;

        // Bijective in each argument, so that a difference persists.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong Mix(ulong state, ulong word)
        {
            ulong product = (state ^ word) * Factor;
            return product ^ (product >> 32);
        }
    }
}
