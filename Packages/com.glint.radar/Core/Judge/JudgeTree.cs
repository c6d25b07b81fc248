using System;
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

        // A hit nearer than this fraction of the scene's size is the surface that the ray has just left.
        const double SelfHit = 1e-10;

        readonly double3[] _a, _b, _c;
        readonly Node _root;
        readonly double _nearestAllowed;

        public JudgeTree(TriangleMesh scene, double3 camera)
        {
            int count = scene.TriangleCount;
            _a = new double3[count];
            _b = new double3[count];
            _c = new double3[count];
            var triangles = new int[count];
            for (int i = 0; i < count; i++)
            {
                scene.GetTriangle(i, out var a, out var b, out var c);
                (_a[i], _b[i], _c[i]) = (a, b, c);
                triangles[i] = i;
            }
            if (count == 0)
                return;
            _root = Build(triangles);
            _nearestAllowed = SelfHit * math.length(math.max(_root.High, camera) - math.min(_root.Low, camera));
        }

        /// <summary>Unit normal of a triangle; its side is arbitrary.</summary>
        public double3 Normal(int triangle) => math.normalize(math.cross(_b[triangle] - _a[triangle], _c[triangle] - _a[triangle]));

        /// <summary>The nearest triangle along a ray that has just left triangle <paramref name="leaving"/> (-1: none); -1 and infinity if there is none.</summary>
        public int FindNearest(double3 origin, double3 direction, int leaving, out double distance)
        {
            int hit = -1;
            distance = double.PositiveInfinity;
            if (_root != null)
                Visit(_root, origin, direction, leaving, ref hit, ref distance);
            return hit;
        }

        Node Build(int[] triangles)
        {
            var node = new Node { Low = double.PositiveInfinity, High = double.NegativeInfinity };
            foreach (int t in triangles)
            {
                node.Low = math.min(node.Low, math.min(_a[t], math.min(_b[t], _c[t])));
                node.High = math.max(node.High, math.max(_a[t], math.max(_b[t], _c[t])));
            }
            if (triangles.Length <= LeafSize)
            {
                node.Triangles = triangles;
                return node;
            }

            double3 size = node.High - node.Low;
            int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            var centres = Array.ConvertAll(triangles, t => _a[t][axis] + _b[t][axis] + _c[t][axis]);
            Array.Sort(centres, triangles);
            int half = triangles.Length / 2;
            node.Left = Build(triangles.AsSpan(0, half).ToArray());
            node.Right = Build(triangles.AsSpan(half).ToArray());
            return node;
        }

        void Visit(Node node, double3 origin, double3 direction, int leaving, ref int hit, ref double distance)
        {
            if (!Reaches(node, origin, direction, distance))
                return;
            if (node.Triangles == null)
            {
                Visit(node.Left, origin, direction, leaving, ref hit, ref distance);
                Visit(node.Right, origin, direction, leaving, ref hit, ref distance);
                return;
            }
            foreach (int t in node.Triangles)
            {
                if (t == leaving)
                    continue;
                double there = Distance(t, origin, direction);
                if (there > _nearestAllowed && there < distance)
                    (hit, distance) = (t, there);
            }
        }

        // Slab by slab; a direction along a slab is inside it or not.
        static bool Reaches(Node node, double3 origin, double3 direction, double distance)
        {
            double enter = 0, leave = distance;
            for (int axis = 0; axis < 3; axis++)
            {
                double low = node.Low[axis] - origin[axis], high = node.High[axis] - origin[axis];
                // The boxes of triangles in a plane are flat: rounding must not lose a ray that meets them.
                double margin = 1e-12 * (Math.Abs(low) + Math.Abs(high));
                low -= margin;
                high += margin;
                if (direction[axis] == 0)
                {
                    if (low > 0 || high < 0)
                        return false;
                    continue;
                }
                double atLow = low / direction[axis], atHigh = high / direction[axis];
                enter = Math.Max(enter, Math.Min(atLow, atHigh));
                leave = Math.Min(leave, Math.Max(atLow, atHigh));
            }
            return enter <= leave;
        }

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
            public int[] Triangles;
        }
    }
}
