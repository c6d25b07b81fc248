using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using Random = System.Random;

namespace Glint.Tests
{
    /// <summary>
    /// Polygons of OBJ files: their triangles cover exactly the polygon. Areas by the shoelace formula.
    /// </summary>
    public sealed class PolygonTests
    {
        const string Dart = "v 0 0 0\nv 2 0 0\nv .5 .5 0\nv 0 2 0\n";

        [TestCase("f 1 2 3 4")]
        [TestCase("f 2 3 4 1")]
        [TestCase("f 3 4 1 2")]
        [TestCase("f 4 1 2 3")]
        [TestCase("f 4 3 2 1")]
        [TestCase("f 1 4 3 2")]
        public void Face_Concave_HasItsAreaFromAnyCornerInEitherSense(string face)
        {
            // Two triangles of base 2 and height 0.5.
            Assert.That(SumOfAreas(ReadText.Obj(Dart + face)), Is.EqualTo(1).Within(1e-12));
        }

        [Test]
        public void Face_RandomStar_HasItsAreaAndSense([Values(5, 8, 13, 60, 300)] int corners,
            [Values] bool isReversed)
        {
            var random = new Random(7 + corners);
            for (int repeat = 0; repeat < 40; repeat++)
            {
                var star = Enumerable.Range(0, corners).Select(i => (0.1 + 1.9 * random.NextDouble())
                    * Direction(2 * Math.PI * (i + 0.9 * random.NextDouble()) / corners)).ToArray();
                int first = random.Next(corners);
                var order = Enumerable.Range(0, corners).Select(i => (i + first) % corners);
                AssertCovered(star, (isReversed ? order.Reverse() : order).ToArray(), isReversed ? -1 : 1,
                    Point(random, 1), Point(random, 5));
            }
        }

        [Test]
        public void Face_Comb_HasItsArea([Range(0, 18)] int first)
        {
            // Four teeth of 1 x 1 on a back of 7 x 1: several corners are on one line, and many are hidden from the
            // first.
            var comb = new List<double2> { new double2(0, -1), new double2(7, -1), new double2(7, 0) };
            for (int tooth = 3; tooth >= 0; tooth--)
                comb.AddRange(new[] { new double2(2 * tooth + 1, 0), new double2(2 * tooth + 1, 1),
                    new double2(2 * tooth, 1), new double2(2 * tooth, 0) });
            var order = Enumerable.Range(0, comb.Count).Select(i => (i + first) % comb.Count).ToArray();
            AssertCovered(comb.ToArray(), order, 1, new double3(0.3, -0.8, 0.5), new double3(1, 2, 3));
        }

        // A frame is one outline with a cut from the outer to the inner edge, so both ends of the cut appear twice.
        [TestCase("f 1 2 3 4 1 5 8 7 6 5")]
        [TestCase("f 3 4 1 5 8 7 6 5 1 2")]
        [TestCase("f 5 8 7 6 5 1 2 3 4 1")]
        [TestCase("f 7 6 5 1 2 3 4 1 5 8")]
        [TestCase("f 1 4 3 2 1 5 6 7 8 5")]
        public void Face_WithAHole_LeavesItOpen(string face)
        {
            var mesh = ReadText.Obj("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 3 1 0\nv 3 3 0\nv 1 3 0\n" + face);
            Assert.That(SumOfAreas(mesh), Is.EqualTo(12).Within(1e-12));
        }

        [TestCase("f 1 2 3 4 5", new[] { 0, 1, 2, 0, 2, 3, 0, 3, 4 }, TestName = "Face_Convex_IsAFan")]
        [TestCase("f 1 1 2 3 4", new[] { 0, 0, 1, 0, 1, 2, 0, 2, 3 }, TestName = "Face_CornerTwice_IsAFan")]
        [TestCase("f 1 2 1 2", new[] { 0, 1, 0, 0, 0, 1 }, TestName = "Face_WithoutArea_IsAFan")]
        public void Face_ThatAFanFits_KeepsIt(string face, int[] indices) =>
            Assert.That(ReadText.Obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0.5 0\n" + face).Indices,
                Is.EqualTo(indices));

        [Test]
        public void Face_OfASlightlyBentQuad_IsAFan() =>
            Assert.That(ReadText.Obj("v 0 0 0\nv 1 0 0\nv 1 1 0.3\nv 0 1 0\nf 1 2 3 4").Indices,
                Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3 }));

        [TestCase("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4", "model.obj:5:", TestName = "Face_BowTie_IsRefused")]
        [TestCase("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 1 0\n# it crosses\nf 1 2 3 4", "model.obj:6:",
            TestName = "Face_UnevenBowTie_IsRefused")]
        public void Face_ThatCrossesItself_IsRefused(string text, string location) =>
            ReadText.AssertRefused(() => ReadText.Obj(text), location, "the face of 4 corners", "crosses itself");

        [Test]
        public void Face_ConcaveOfTooManyCorners_IsRefusedByTheirNumber()
        {
            var text = new StringBuilder();
            const int corners = 5000;
            for (int i = 0; i < corners; i++)
                AppendVertex(text, new double3((i % 2 + 1) * Direction(2 * Math.PI * i / corners), 0));
            ReadText.AssertRefused(() => ReadText.Obj(text + "f " + string.Join(" ", Enumerable.Range(1, corners))),
                $"model.obj:{corners + 1}:", "5000 corners", "4096");
        }

        static void AssertCovered(double2[] outline, int[] order, int sense, double3 axis, double3 offset)
        {
            var x = math.normalize(math.cross(axis, new double3(0.6, 0.8, 0)));
            var y = math.normalize(math.cross(axis, x));
            var text = new StringBuilder();
            foreach (var corner in outline)
                AppendVertex(text, offset + corner.x * x + corner.y * y);
            var mesh = ReadText.Obj(text + "f " + string.Join(" ", order.Select(corner => corner + 1)));

            double area = 0;
            for (int i = 0; i < outline.Length; i++)
            {
                var (a, b) = (outline[i], outline[(i + 1) % outline.Length]);
                area += (a.x * b.y - a.y * b.x) / 2;
            }
            Assert.That(mesh.TriangleCount, Is.EqualTo(outline.Length - 2));
            // Coordinates are rounded to float.
            Assert.That(SumOfAreas(mesh), Is.EqualTo(area).Within(1e-5));
            var normal = sense * math.cross(x, y);
            for (int i = 0; i < mesh.Indices.Length; i += 3)
                Assert.That(math.dot(AreaOf(mesh, i), normal), Is.GreaterThan(-1e-5), "sense");
        }

        static void AppendVertex(StringBuilder text, double3 point) =>
            text.AppendFormat(CultureInfo.InvariantCulture, "v {0:R} {1:R} {2:R}\n", point.x, point.y, point.z);

        static double3 Point(Random random, double reach) =>
            reach * new double3(2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1, 2 * random.NextDouble() - 1);

        static double2 Direction(double angle) => new double2(Math.Cos(angle), Math.Sin(angle));

        static double SumOfAreas(MeshFile mesh) =>
            Enumerable.Range(0, mesh.TriangleCount).Sum(triangle => math.length(AreaOf(mesh, 3 * triangle)));

        static double3 AreaOf(MeshFile mesh, int first)
        {
            double3 a = mesh.Vertices[mesh.Indices[first]], b = mesh.Vertices[mesh.Indices[first + 1]],
                c = mesh.Vertices[mesh.Indices[first + 2]];
            return math.cross(b - a, c - a) / 2;
        }
    }
}
