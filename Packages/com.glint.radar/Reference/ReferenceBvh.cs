using System;
using System.Threading.Tasks;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Reference
{
    /// <summary>
    /// The reference tracer's BVH: double precision, median splits along the longest side, recursive traversal.
    /// It shares no code with the kernel or its builder, so that they cannot have the same error.
    /// Its coordinates are those of the scene less <see cref="Centre"/>.
    /// </summary>
    sealed class ReferenceBvh
    {
        const int LeafSize = 4;

        // Minimum number of triangles for sorting on another core.
        const int MinShared = 4096;

        // Fraction of the scene's size within which a ray starts on a triangle's plane and does not hit it: some
        // hundred roundings of a position.
        const double OnSurface = 1e-13;

        // Enlargement of boxes, as a fraction of the scene's size: rounding must not lose a ray that hits a box
        // edge-on.
        const double Margin = 1e-12;

        // Corners, unit normals and numbers in the order of the leaves.
        readonly double3[] _a, _b, _c, _normals;
        readonly int[] _numbers;
        readonly MeshInstance[] _instances;
        readonly Node _root;
        readonly double _margin, _onSurface;

        /// <param name="scene">Corners are the float32 vertices transformed in double.</param>
        public ReferenceBvh(RadarScene scene)
        {
            int count = checked((int)scene.TriangleCount);
            _instances = scene.Instances;
            _a = new double3[count];
            _b = new double3[count];
            _c = new double3[count];
            _normals = new double3[count];
            _numbers = new int[count];
            if (count == 0)
                return;
            LoadTriangles(scene);
            double3 boxMin = double.PositiveInfinity, boxMax = double.NegativeInfinity;
            for (int i = 0; i < count; i++)
                (boxMin, boxMax) = (math.min(boxMin, Min(i)), math.max(boxMax, Max(i)));
            Centre = boxMin + 0.5 * (boxMax - boxMin);
            Radius = 0.5 * math.length(boxMax - boxMin);
            _margin = 2 * Radius * Margin;
            _onSurface = 2 * Radius * OnSurface;

            // Loads again relative to the centre, so that coordinates of a distant scene have no large rounding.
            LoadTriangles(scene);
            _root = Build(0, count, new double[count]);
            Reorder(_a);
            Reorder(_b);
            Reorder(_c);
            Reorder(_normals);
        }

        /// <summary>Centre of the box around all triangles, in the scene's coordinates.</summary>
        public double3 Centre { get; }

        /// <summary>Half the diagonal of that box, metres.</summary>
        public double Radius { get; }

        /// <summary>
        /// Number of a triangle in the scene, counted over the instances and their triangles in order.
        /// </summary>
        public int Number(int triangle) => _numbers[triangle];

        /// <summary>Object and surface of the triangle.</summary>
        public MeshRange RangeOf(int triangle)
        {
            int inMesh = _numbers[triangle], instance = 0;
            while (inMesh >= _instances[instance].Mesh.TriangleCount)
                inMesh -= _instances[instance++].Mesh.TriangleCount;
            // Range by range, as simply as can be.
            return Array.FindLast(_instances[instance].Ranges, range => range.FirstTriangle <= inMesh);
        }

        /// <summary>Unit normal of a triangle, 0 for one without area; its side is arbitrary.</summary>
        public double3 Normal(int triangle) => _normals[triangle];

        /// <summary>First corner of a triangle, and its edges to the second and third.</summary>
        public void Corners(int triangle, out double3 a, out double3 ab, out double3 ac) =>
            (a, ab, ac) = (_a[triangle], _b[triangle] - _a[triangle], _c[triangle] - _a[triangle]);

        /// <summary>
        /// The closest hit of a ray, except triangles in whose plane it starts; -1 and infinity if there is none. Of
        /// several at the same distance the one with the lowest number. The result is the BVH's index of the triangle;
        /// <see cref="Number"/> gives the scene's.
        /// </summary>
        public int ClosestHit(double3 origin, double3 direction, out double distance)
        {
            var traversal = new Traversal
            {
                Origin = origin, Direction = direction,
                Inverse = new double3(Inverse(direction.x), Inverse(direction.y), Inverse(direction.z)),
                Hit = -1, Distance = double.PositiveInfinity,
            };
            if (_root != null && Enters(_root, traversal) < double.PositiveInfinity)
                Traverse(_root, ref traversal);
            distance = traversal.Distance;
            return traversal.Hit;
        }

        /// <summary>The shadow query: whether the ray meets anything nearer than reach, metres.</summary>
        public bool AnyHit(double3 origin, double3 direction, double reach) =>
            ClosestHit(origin, direction, out double distance) >= 0 && distance < reach;

        // Corners and normals of all triangles, in the scene's order.
        void LoadTriangles(RadarScene scene)
        {
            int number = 0;
            foreach (var instance in scene.Instances)
            {
                var transform = instance.ToWorld;
                transform.Origin -= Centre;
                // Normals transform like areas. Differences of float32 corners are exact in double, and their cross
                // product is accurate even for thin triangles.
                var areas = new Affine
                {
                    X = math.cross(transform.Y, transform.Z),
                    Y = math.cross(transform.Z, transform.X), Z = math.cross(transform.X, transform.Y)
                };
                for (int i = 0; i < instance.Mesh.TriangleCount; i++, number++)
                {
                    instance.Mesh.GetTriangle(i, out var a, out var b, out var c);
                    (_a[number], _b[number], _c[number]) = (transform.Point(a), transform.Point(b), transform.Point(c));
                    double3 normal = areas.Vector(math.cross((double3)b - a, (double3)c - a));
                    double length = math.length(normal);
                    _normals[number] = length > 0 ? normal / length : 0;
                    _numbers[number] = number;
                }
            }
        }

        Node Build(int first, int count, double[] centres)
        {
            var node = new Node { Min = double.PositiveInfinity, Max = double.NegativeInfinity, First = first };
            for (int i = first; i < first + count; i++)
            {
                node.Min = math.min(node.Min, Min(_numbers[i]));
                node.Max = math.max(node.Max, Max(_numbers[i]));
            }
            double3 size = node.Max - node.Min;
            node.Min -= _margin;
            node.Max += _margin;
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
            if (count < MinShared)
            {
                node.Left = Build(first, half, centres);
                node.Right = Build(first + half, count - half, centres);
            }
            else
                Parallel.Invoke(() => node.Left = Build(first, half, centres),
                    () => node.Right = Build(first + half, count - half, centres));
            return node;
        }

        void Reorder(double3[] values)
        {
            var before = (double3[])values.Clone();
            for (int i = 0; i < values.Length; i++)
                values[i] = before[_numbers[i]];
        }

        double3 Min(int triangle) => math.min(_a[triangle], math.min(_b[triangle], _c[triangle]));

        double3 Max(int triangle) => math.max(_a[triangle], math.max(_b[triangle], _c[triangle]));

        void Traverse(Node node, ref Traversal traversal)
        {
            if (node.Left == null)
            {
                for (int i = node.First; i < node.First + node.Count; i++)
                    Test(i, ref traversal);
                return;
            }
            double left = Enters(node.Left, traversal), right = Enters(node.Right, traversal);
            bool leftFirst = left <= right;
            if ((leftFirst ? left : right) < double.PositiveInfinity)
                Traverse(leftFirst ? node.Left : node.Right, ref traversal);
            double far = leftFirst ? right : left;
            if (far < double.PositiveInfinity && far <= traversal.Distance)
                Traverse(leftFirst ? node.Right : node.Left, ref traversal);
        }

        void Test(int triangle, ref Traversal traversal)
        {
            double there = Distance(triangle, traversal.Origin, traversal.Direction);
            if (there < traversal.Distance || there == traversal.Distance && there < double.PositiveInfinity
                && _numbers[triangle] < _numbers[traversal.Hit])
                (traversal.Hit, traversal.Distance) = (triangle, there);
        }

        // Distance at which the ray enters the box, by the slab test; infinity if it misses the box or has a nearer
        // hit.
        static double Enters(Node node, in Traversal traversal)
        {
            double ax = (node.Min.x - traversal.Origin.x) * traversal.Inverse.x,
                bx = (node.Max.x - traversal.Origin.x) * traversal.Inverse.x;
            double ay = (node.Min.y - traversal.Origin.y) * traversal.Inverse.y,
                by = (node.Max.y - traversal.Origin.y) * traversal.Inverse.y;
            double az = (node.Min.z - traversal.Origin.z) * traversal.Inverse.z,
                bz = (node.Max.z - traversal.Origin.z) * traversal.Inverse.z;
            double enter = Math.Max(Math.Max(Math.Min(ax, bx), Math.Min(ay, by)), Math.Max(Math.Min(az, bz), 0));
            double leave =
                Math.Min(Math.Min(Math.Max(ax, bx), Math.Max(ay, by)), Math.Min(Math.Max(az, bz), traversal.Distance));
            return enter <= leave ? enter : double.PositiveInfinity;
        }

        // A ray parallel to a slab is inside it or never enters it: a large number gives that, while infinity would
        // give 0 times infinity on the slab's plane.
        static double Inverse(double component) => Math.Abs(component) > 1e-200 ? 1 / component : 1e200;

        // Distance to the triangle's plane if the ray passes the three edges on the same side; else infinity.
        double Distance(int triangle, double3 origin, double3 direction)
        {
            double3 a = _a[triangle] - origin, b = _b[triangle] - origin, c = _c[triangle] - origin;
            double height = math.dot(a, _normals[triangle]), facing = math.dot(direction, _normals[triangle]);
            // Both are true for triangles without area.
            if (Math.Abs(height) <= _onSurface || facing == 0)
                return double.PositiveInfinity;

            double ab = Passes(direction, a, b, _b[triangle] - _a[triangle]);
            double bc = Passes(direction, b, c, _c[triangle] - _b[triangle]);
            double ca = Passes(direction, c, a, _a[triangle] - _c[triangle]);
            if (!(ab >= 0 && bc >= 0 && ca >= 0 || ab <= 0 && bc <= 0 && ca <= 0))
                return double.PositiveInfinity;

            // Edge-on the distance to the plane is undetermined; the corners bound the hit.
            double da = math.dot(a, direction), db = math.dot(b, direction), dc = math.dot(c, direction);
            double distance =
                math.clamp(height / facing, math.min(da, math.min(db, dc)), math.max(da, math.max(db, dc)));
            return distance > 0 ? distance : double.PositiveInfinity;
        }

        // Side on which a ray from the origin passes the edge between two points, times the edge's length and twice the
        // distance. The two triangles of an edge get exactly opposite numbers, so that no ray passes between them;
        // short distant edges lose no digits.
        static double Passes(double3 direction, double3 from, double3 to, double3 edge) =>
            math.dot(direction, math.cross(from + to, edge));

        sealed class Node
        {
            public double3 Min, Max;
            public Node Left, Right;
            public int First, Count; // the triangles of a leaf
        }

        struct Traversal
        {
            public double3 Origin, Direction, Inverse;
            public int Hit;
            public double Distance;
        }
    }
}
