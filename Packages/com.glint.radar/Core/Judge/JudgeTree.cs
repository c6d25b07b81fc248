using System;
using System.Threading.Tasks;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The judge's own search for the nearest triangle: double precision, triangles halved along the longest side, plain recursion.
    /// It shares no code with the kernel or its builder, so that an error in one does not hide in the other.
    /// </summary>
    sealed class JudgeTree
    {
        const int LeafSize = 4;

        // Fewer triangles than this are sorted sooner than another processor takes them over.
        const int LeastShared = 4096;

        // A hit nearer than this fraction of the scene's size is the surface that the ray has just left.
        const double SelfHit = 1e-10;

        // Boxes are larger than their triangles by this fraction of all distances that occur: rounding must not lose a ray that meets one edge-on.
        const double Margin = 1e-12;

        // Corners and numbers in the order of the leaves.
        readonly double3[] _a, _b, _c;
        readonly int[] _numbers;
        readonly Node _root;
        readonly double _margin, _nearestAllowed;

        /// <param name="scene">Corners are where the double transforms put the float32 vertices.</param>
        /// <param name="camera">Where rays come from besides the triangles.</param>
        public JudgeTree(RadarScene scene, double3 camera)
        {
            int count = checked((int)scene.TriangleCount);
            _a = new double3[count];
            _b = new double3[count];
            _c = new double3[count];
            _numbers = new int[count];
            double3 low = camera, high = camera;
            int number = 0;
            foreach (var instance in scene.Instances)
                for (int i = 0; i < instance.Mesh.TriangleCount; i++, number++)
                {
                    instance.Mesh.GetTriangle(i, out var a, out var b, out var c);
                    (_a[number], _b[number], _c[number]) = (instance.ToWorld.Point(a), instance.ToWorld.Point(b), instance.ToWorld.Point(c));
                    _numbers[number] = number;
                    low = math.min(low, Low(number));
                    high = math.max(high, High(number));
                }
            if (count == 0)
                return;
            double size = math.length(high - low);
            _margin = Margin * (size + math.cmax(math.max(math.abs(low), math.abs(high))));
            _nearestAllowed = SelfHit * size;
            _root = Build(0, count, new double[count]);
            Reorder(_a);
            Reorder(_b);
            Reorder(_c);
        }

        /// <summary>The triangle's number in the scene: over the instances in order, over their triangles in order.</summary>
        public int Number(int triangle) => _numbers[triangle];

        /// <summary>Unit normal of a triangle; its side is arbitrary.</summary>
        public double3 Normal(int triangle) => math.normalize(math.cross(_b[triangle] - _a[triangle], _c[triangle] - _a[triangle]));

        /// <summary>
        /// The nearest triangle along a ray that has just left triangle <paramref name="leaving"/> (-1: none); -1 and infinity if there is none.
        /// Of several at the same distance the one of the lowest number. Triangles are counted as the tree has them; <see cref="Number"/> tells the scene's.
        /// </summary>
        public int FindNearest(double3 origin, double3 direction, int leaving, out double distance)
        {
            var search = new Search
            {
                Origin = origin, Direction = direction, Inverse = new double3(Inverse(direction.x), Inverse(direction.y), Inverse(direction.z)),
                Leaving = leaving, Hit = -1, Distance = double.PositiveInfinity,
            };
            if (_root != null && Enters(_root, search) < double.PositiveInfinity)
                Visit(_root, ref search);
            distance = search.Distance;
            return search.Hit;
        }

        Node Build(int first, int count, double[] centres)
        {
            var node = new Node { Low = double.PositiveInfinity, High = double.NegativeInfinity, First = first };
            for (int i = first; i < first + count; i++)
            {
                node.Low = math.min(node.Low, Low(_numbers[i]));
                node.High = math.max(node.High, High(_numbers[i]));
            }
            double3 size = node.High - node.Low;
            node.Low -= _margin;
            node.High += _margin;
            if (count <= LeafSize)
            {
                node.Count = count;
                return node;
            }

            int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            for (int i = first; i < first + count; i++)
                centres[i] = _a[_numbers[i]][axis] + _b[_numbers[i]][axis] + _c[_numbers[i]][axis];
            Array.Sort(centres, _numbers, first, count);
            int half = count / 2;
            if (count < LeastShared)
            {
                node.Left = Build(first, half, centres);
                node.Right = Build(first + half, count - half, centres);
            }
            else
                Parallel.Invoke(() => node.Left = Build(first, half, centres), () => node.Right = Build(first + half, count - half, centres));
            return node;
        }

        void Reorder(double3[] corners)
        {
            var before = (double3[])corners.Clone();
            for (int i = 0; i < corners.Length; i++)
                corners[i] = before[_numbers[i]];
        }

        double3 Low(int triangle) => math.min(_a[triangle], math.min(_b[triangle], _c[triangle]));

        double3 High(int triangle) => math.max(_a[triangle], math.max(_b[triangle], _c[triangle]));

        void Visit(Node node, ref Search search)
        {
            if (node.Left == null)
            {
                for (int i = node.First; i < node.First + node.Count; i++)
                    Test(i, ref search);
                return;
            }
            double left = Enters(node.Left, search), right = Enters(node.Right, search);
            bool leftFirst = left <= right;
            if ((leftFirst ? left : right) < double.PositiveInfinity)
                Visit(leftFirst ? node.Left : node.Right, ref search);
            double far = leftFirst ? right : left;
            if (far < double.PositiveInfinity && far <= search.Distance)
                Visit(leftFirst ? node.Right : node.Left, ref search);
        }

        void Test(int triangle, ref Search search)
        {
            if (triangle == search.Leaving)
                return;
            double there = Distance(triangle, search.Origin, search.Direction);
            if (there > _nearestAllowed && (there < search.Distance || there == search.Distance && there < double.PositiveInfinity && _numbers[triangle] < _numbers[search.Hit]))
                (search.Hit, search.Distance) = (triangle, there);
        }

        // Where the ray enters the box; infinity if it misses it or has a hit before it. Slab by slab.
        static double Enters(Node node, in Search search)
        {
            double ax = (node.Low.x - search.Origin.x) * search.Inverse.x, bx = (node.High.x - search.Origin.x) * search.Inverse.x;
            double ay = (node.Low.y - search.Origin.y) * search.Inverse.y, by = (node.High.y - search.Origin.y) * search.Inverse.y;
            double az = (node.Low.z - search.Origin.z) * search.Inverse.z, bz = (node.High.z - search.Origin.z) * search.Inverse.z;
            double enter = Math.Max(Math.Max(Math.Min(ax, bx), Math.Min(ay, by)), Math.Max(Math.Min(az, bz), 0));
            double leave = Math.Min(Math.Min(Math.Max(ax, bx), Math.Max(ay, by)), Math.Min(Math.Max(az, bz), search.Distance));
            return enter <= leave ? enter : double.PositiveInfinity;
        }

        // A ray along a slab is inside it or enters it nowhere: a large number says so, infinity would give 0 times infinity on the slab's side.
        static double Inverse(double component) => Math.Abs(component) > 1e-200 ? 1 / component : 1e200;

        // The ray meets the triangle's plane at the distance where it lies on the inner side of all three edges; infinity if nowhere.
        double Distance(int triangle, double3 origin, double3 direction)
        {
            double3 a = _a[triangle] - origin, b = _b[triangle] - origin, c = _c[triangle] - origin;
            double volumeA = math.dot(direction, math.cross(b, c));
            double volumeB = math.dot(direction, math.cross(c, a));
            double volumeC = math.dot(direction, math.cross(a, b));
            bool inside = volumeA >= 0 && volumeB >= 0 && volumeC >= 0 || volumeA <= 0 && volumeB <= 0 && volumeC <= 0;
            double sum = volumeA + volumeB + volumeC;
            if (!inside || sum == 0)
                return double.PositiveInfinity;
            double3 point = (volumeA * a + volumeB * b + volumeC * c) / sum;
            double distance = math.dot(point, direction);
            return distance > 0 ? distance : double.PositiveInfinity;
        }

        sealed class Node
        {
            public double3 Low, High;
            public Node Left, Right;
            public int First, Count; // of a leaf's triangles
        }

        struct Search
        {
            public double3 Origin, Direction, Inverse;
            public int Leaving, Hit;
            public double Distance;
        }
    }
}
