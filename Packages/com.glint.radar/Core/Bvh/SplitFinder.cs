using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Finds the split plane of a node with the lowest cost by the surface area heuristic, among the borders of 16 bins
    /// along each axis.
    /// </summary>
    sealed class SplitFinder
    {
        const int Bins = 16;

        readonly Bin[] _bins = new Bin[3 * Bins];
        readonly float[] _leftCosts = new float[Bins];
        float3 _min, _scale;

        /// <summary>The axis of the plane found.</summary>
        public int Axis { get; private set; }

        /// <summary>The first bin on the right side of the plane found.</summary>
        public int Plane { get; private set; }

        /// <summary>
        /// Whether there is a plane that leaves neither side empty nor puts more than
        /// <paramref name="maxPerSide"/> leaves on one.
        /// </summary>
        public bool Find(BvhLeaf[] leaves, int first, int count, in Box centres, int maxPerSide)
        {
            _min = centres.Min;
            _scale = new float3(Scale(centres.Min.x, centres.Max.x), Scale(centres.Min.y, centres.Max.y),
                Scale(centres.Min.z, centres.Max.z));
            Fill(leaves, first, count);
            float best = float.PositiveInfinity;
            for (int axis = 0; axis < 3; axis++)
                if (_scale[axis] > 0)
                    TryAxis(axis, count, maxPerSide, ref best);
            return best < float.PositiveInfinity;
        }

        /// <summary>Whether a leaf is on the left side of the plane found.</summary>
        public bool IsLeft(in Box box)
        {
            switch (Axis)
            {
                case 0: return BinOf(box.Min.x + box.Max.x, _min.x, _scale.x) < Plane;
                case 1: return BinOf(box.Min.y + box.Max.y, _min.y, _scale.y) < Plane;
                default: return BinOf(box.Min.z + box.Max.z, _min.z, _scale.z) < Plane;
            }
        }

        // Bins per metre; 0 along an axis on which all centres are equal.
        float Scale(float min, float max)
        {
            float scale = Bins / (max - min);
            return scale <= float.MaxValue ? scale : 0;
        }

        int BinOf(float centre, float min, float scale)
        {
            int bin = (int)((centre - min) * scale);
            return bin < 0 ? 0 : bin >= Bins ? Bins - 1 : bin;
        }

        void Fill(BvhLeaf[] leaves, int first, int count)
        {
            for (int axis = 0; axis < 3; axis++)
                for (int bin = 0; bin < Bins; bin++)
                    _bins[axis * Bins + bin] = new Bin { Box = Box.Empty };
            float3 boxMin = _min, scale = _scale;
            for (int i = first; i < first + count; i++)
            {
                ref readonly Box box = ref leaves[i].Box;
                _bins[BinOf(box.Min.x + box.Max.x, boxMin.x, scale.x)].Add(box);
                _bins[Bins + BinOf(box.Min.y + box.Max.y, boxMin.y, scale.y)].Add(box);
                _bins[2 * Bins + BinOf(box.Min.z + box.Max.z, boxMin.z, scale.z)].Add(box);
            }
        }

        // Cost of a plane: half area times leaves, of both sides.
        void TryAxis(int axis, int count, int maxPerSide, ref float best)
        {
            int start = axis * Bins;
            var left = new Bin { Box = Box.Empty };
            for (int bin = 0; bin < Bins - 1; bin++)
            {
                left.Add(_bins[start + bin]);
                _leftCosts[bin] = left.Count > 0 ? left.Box.HalfArea * left.Count : float.PositiveInfinity;
            }
            var right = new Bin { Box = Box.Empty };
            for (int bin = Bins - 1; bin > 0; bin--)
            {
                right.Add(_bins[start + bin]);
                if (right.Count == 0 || right.Count > maxPerSide || count - right.Count > maxPerSide)
                    continue;
                float cost = _leftCosts[bin - 1] + right.Box.HalfArea * right.Count;
                if (cost < best)
                {
                    best = cost;
                    Axis = axis;
                    Plane = bin;
                }
            }
        }

        struct Bin
        {
            public Box Box;
            public int Count;

            public void Add(in Box box)
            {
                Box.Add(box);
                Count++;
            }

            public void Add(in Bin other)
            {
                Box.Add(other.Box);
                Count += other.Count;
            }
        }
    }
}
