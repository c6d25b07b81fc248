using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Finds the plane through a node that makes its children cheapest by the surface area heuristic,
    /// trying the borders of 16 bins along each axis.
    /// </summary>
    sealed class SplitFinder
    {
        const int Bins = 16;

        readonly Bin[] _bins = new Bin[3 * Bins];
        readonly float[] _leftCosts = new float[Bins];
        float3 _low, _scale;

        /// <summary>The axis of the plane found.</summary>
        public int Axis { get; private set; }

        /// <summary>The first bin on the right side of the plane found.</summary>
        public int Plane { get; private set; }

        /// <summary>
        /// Whether there is a plane that leaves neither side empty nor puts more than
        /// <paramref name="mostOnASide"/> leaves on one.
        /// </summary>
        public bool Find(BoxLeaf[] leaves, int first, int count, in Box centres, int mostOnASide)
        {
            _low = centres.Low;
            _scale = new float3(Scale(centres.Low.x, centres.High.x), Scale(centres.Low.y, centres.High.y),
                Scale(centres.Low.z, centres.High.z));
            Fill(leaves, first, count);
            float best = float.PositiveInfinity;
            for (int axis = 0; axis < 3; axis++)
                if (_scale[axis] > 0)
                    TryAxis(axis, count, mostOnASide, ref best);
            return best < float.PositiveInfinity;
        }

        /// <summary>Whether a leaf is on the left side of the plane found.</summary>
        public bool IsLeft(in Box box)
        {
            switch (Axis)
            {
                case 0: return BinOf(box.Low.x + box.High.x, _low.x, _scale.x) < Plane;
                case 1: return BinOf(box.Low.y + box.High.y, _low.y, _scale.y) < Plane;
                default: return BinOf(box.Low.z + box.High.z, _low.z, _scale.z) < Plane;
            }
        }

        // Bins per length; 0 along an axis on which all centres are the same.
        float Scale(float low, float high)
        {
            float scale = Bins / (high - low);
            return scale <= float.MaxValue ? scale : 0;
        }

        int BinOf(float centre, float low, float scale)
        {
            int bin = (int)((centre - low) * scale);
            return bin < 0 ? 0 : bin >= Bins ? Bins - 1 : bin;
        }

        void Fill(BoxLeaf[] leaves, int first, int count)
        {
            for (int axis = 0; axis < 3; axis++)
                for (int bin = 0; bin < Bins; bin++)
                    _bins[axis * Bins + bin] = new Bin { Box = Box.Empty };
            float3 low = _low, scale = _scale;
            for (int i = first; i < first + count; i++)
            {
                ref readonly Box box = ref leaves[i].Box;
                _bins[BinOf(box.Low.x + box.High.x, low.x, scale.x)].Add(box);
                _bins[Bins + BinOf(box.Low.y + box.High.y, low.y, scale.y)].Add(box);
                _bins[2 * Bins + BinOf(box.Low.z + box.High.z, low.z, scale.z)].Add(box);
            }
        }

        // Cost of a plane: half area times leaves, of both sides.
        void TryAxis(int axis, int count, int mostOnASide, ref float best)
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
                if (right.Count == 0 || right.Count > mostOnASide || count - right.Count > mostOnASide)
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
