using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Sums up a mesh's content, in order, in 64 bits: Unity does not say when a mesh changes. A change of one number always shows,
    /// others but for a chance of 1 in 10^19. Good within one run only.
    /// </summary>
    struct ContentHash
    {
        const ulong Factor = 0x9E3779B97F4A7C15; // odd, bits without a pattern: 2^64 over the golden ratio

        // Independent, so that the processor need not wait for one product before it starts the next.
        ulong _a, _b, _c, _d;

        public ulong Value => Mix(Mix(Mix(_a, _b), _c), _d);

        public void Add(int number) => _a = Mix(_a, (ulong)(uint)number + 1);

        public void Add(List<Vector3> points)
        {
            int count = points.Count, i = 0;
            Add(count);
            ulong a = _a, b = _b, c = _c, d = _d;
            for (; i + 1 < count; i += 2)
            {
                Vector3 p = points[i], q = points[i + 1];
                a = Mix(a, Pair(math.asuint(p.x), math.asuint(p.y)));
                b = Mix(b, math.asuint(p.z));
                c = Mix(c, Pair(math.asuint(q.x), math.asuint(q.y)));
                d = Mix(d, math.asuint(q.z));
            }
            (_a, _b, _c, _d) = (a, b, c, d);
            if (i < count)
                Add(points[i]);
        }

        public void Add(List<int> numbers)
        {
            int count = numbers.Count, i = 0;
            Add(count);
            ulong a = _a, b = _b, c = _c, d = _d;
            for (; i + 7 < count; i += 8)
            {
                a = Mix(a, Pair((uint)numbers[i], (uint)numbers[i + 1]));
                b = Mix(b, Pair((uint)numbers[i + 2], (uint)numbers[i + 3]));
                c = Mix(c, Pair((uint)numbers[i + 4], (uint)numbers[i + 5]));
                d = Mix(d, Pair((uint)numbers[i + 6], (uint)numbers[i + 7]));
            }
            (_a, _b, _c, _d) = (a, b, c, d);
            for (; i < count; i++)
                Add(numbers[i]);
        }

        void Add(Vector3 point)
        {
            _a = Mix(_a, Pair(math.asuint(point.x), math.asuint(point.y)));
            _b = Mix(_b, math.asuint(point.z));
        }

        static ulong Pair(uint low, uint high) => low | (ulong)high << 32;

        // One to one in each argument when the other is held: what differs once stays different.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong Mix(ulong state, ulong word)
        {
            ulong product = (state ^ word) * Factor;
            return product ^ (product >> 32);
        }
    }
}
