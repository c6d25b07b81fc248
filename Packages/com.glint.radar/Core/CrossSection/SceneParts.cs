using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Numbers of the parts of a scene by which a cross section is divided: the triangles of all instances in their
    /// order, the edges of each object, and the numbers of bounces, of which 0 is all edges.
    /// </summary>
    public sealed class SceneParts
    {
        // Triangles of one object in a row.
        readonly struct Range
        {
            public Range(int instance, int first, int objectNumber, int firstInObject) =>
                (Instance, First, Object, FirstInObject) = (instance, first, objectNumber, firstInObject);

            public readonly int Instance, First, Object, FirstInObject;
        }

        readonly RadarScene _scene;
        readonly int[] _firsts;
        readonly Range[] _ranges;

        /// <summary>The parts of a scene.</summary>
        public SceneParts(RadarScene scene)
        {
            _scene = scene;
            _firsts = new int[scene.Instances.Length];
            var ranges = new List<Range>();
            var counts = new Dictionary<int, int>();
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var instance = scene.Instances[i];
                _firsts[i] = TriangleCount;
                for (int range = 0; range < instance.Ranges.Length; range++)
                {
                    var (first, number) = (instance.Ranges[range].FirstTriangle, instance.Ranges[range].Object);
                    int end = range + 1 < instance.Ranges.Length
                        ? instance.Ranges[range + 1].FirstTriangle
                        : instance.Mesh.TriangleCount;
                    counts.TryGetValue(number, out int before);
                    ranges.Add(new Range(i, TriangleCount + first, number, before));
                    counts[number] = before + end - first;
                }
                TriangleCount += instance.Mesh.TriangleCount;
            }
            _ranges = ranges.ToArray();
            Objects = counts.Keys.OrderBy(number => number).ToArray();
        }

        /// <summary>Triangles, whose parts come first.</summary>
        public int TriangleCount { get; }

        /// <summary>
        /// Objects of the triangles, in ascending order; <see cref="MeshRange.NoObject"/> where it is not known.
        /// </summary>
        public IReadOnlyList<int> Objects { get; }

        /// <summary>The part of no bounce, followed by those of one bounce and more.</summary>
        public int FirstBounce => TriangleCount + Objects.Count;

        /// <summary>Number of parts.</summary>
        public int Count => FirstBounce + RadarSettings.BounceLimit + 1;

        /// <summary>The part of an instance's first triangle.</summary>
        public int FirstOf(int instance) => _firsts[instance];

        /// <summary>The part of the edges of a triangle's object.</summary>
        public int EdgesOf(int instance, int triangle) => EdgesOf(RangeOf(_firsts[instance] + triangle).Object);

        /// <summary>The part of the edges of an object.</summary>
        public int EdgesOf(int objectNumber) =>
            TriangleCount + Array.BinarySearch((int[])Objects, objectNumber);

        /// <summary>The object of a triangle's part, and the triangle's number in the object, from 0.</summary>
        public (int Object, int Triangle) TriangleOf(int part)
        {
            var range = RangeOf(part);
            return (range.Object, range.FirstInObject + part - range.First);
        }

        /// <summary>
        /// The corners of a triangle of an object, metres, in the scene's frame; null if there is none.
        /// </summary>
        public double3[] CornersOf(int objectNumber, int triangle)
        {
            for (int i = 0; i < _ranges.Length; i++)
            {
                var range = _ranges[i];
                int end = i + 1 < _ranges.Length ? _ranges[i + 1].First : TriangleCount;
                int part = range.First + triangle - range.FirstInObject;
                if (range.Object != objectNumber || part < range.First || part >= end)
                    continue;
                var instance = _scene.Instances[range.Instance];
                instance.Mesh.GetTriangle(part - _firsts[range.Instance], out var a, out var b, out var c);
                return new[] { instance.ToWorld.Point(a), instance.ToWorld.Point(b), instance.ToWorld.Point(c) };
            }
            return null;
        }

        Range RangeOf(int part)
        {
            int first = 0, end = _ranges.Length;
            while (end - first > 1)
            {
                int middle = (first + end) / 2;
                if (_ranges[middle].First <= part)
                    first = middle;
                else
                    end = middle;
            }
            return _ranges[first];
        }
    }
}
