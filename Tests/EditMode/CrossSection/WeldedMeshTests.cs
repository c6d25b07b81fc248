using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class WeldedMeshTests
    {
        [Test]
        public void Box_WithoutSharedVertices_HasEighteenEdgesOfTwoTriangles()
        {
            var welded = new WeldedMesh(
                TestMeshes.Soup(new TriangleMesh(Solid.BoxVertices(1, 2, 3), Solid.BoxIndices)));

            // 12 of the box and 6 diagonals.
            Assert.That(welded.EdgeCount, Is.EqualTo(18));
            Assert.That(welded.OpenEdgeCount + EdgesOfMoreThanTwo(welded), Is.Zero);
            Assert.That(welded.Corners.Distinct().Count(), Is.EqualTo(8));
            for (int side = 0; side < 36; side++)
            {
                int across = welded.Across(side);
                Assert.That(across / 3, Is.Not.EqualTo(side / 3));
                Assert.That(welded.Across(across), Is.EqualTo(side));
                Assert.That(welded.AreOpposed(side, across));
                Assert.That(welded.Corners[across], Is.EqualTo(welded.Corners[WeldedMesh.EndOf(side)]));
            }
        }

        // Three pages of a book on one spine, the middle one between -0 and 0; a triangle whose corners are one point
        // twice; a triangle of its own.
        [Test]
        public void Edges_OfABook_AreTheSpineAndOpenOnes()
        {
            float3 foot = 0, top = new float3(0, 1, 0);
            var vertices = new[]
            {
                foot, top, new float3(1, 0, 0), new float3(-0f, -0f, 0), new float3(-1, 0, 0), new float3(0, 0, 1),
                new float3(5, 0, 0), new float3(6, 0, 0), new float3(5, 1, 0),
            };
            var welded = new WeldedMesh(
                new TriangleMesh(vertices, new[] { 0, 1, 2, 3, 1, 4, 1, 3, 5, 0, 3, 5, 6, 7, 8 }));

            Assert.That(EdgesOfMoreThanTwo(welded), Is.EqualTo(1));
            Assert.That(welded.OpenEdgeCount, Is.EqualTo(9));
            Assert.That(welded.EdgeCount, Is.EqualTo(10));
            int spine = welded.EdgeOf[0];
            Assert.That(Enumerable.Range(0, welded.SideCount(spine)).Select(i => welded.SideOf(spine, i)),
                Is.EqualTo(new[] { 0, 3, 6 }));
            Assert.That(welded.IsDegenerate(3));
            Assert.That(welded.EdgeOf.Skip(9).Take(3), Is.All.EqualTo(WeldedMesh.None));
            Assert.That(Enumerable.Range(0, 15).Select(welded.Across), Is.All.EqualTo(WeldedMesh.None));
        }

        // As of an object that is twice in one place: rays hit the first of equal triangles.
        [Test]
        public void Box_TwiceInOnePlace_HasTheEdgesOfOne()
        {
            var box = new TriangleMesh(Solid.BoxVertices(1, 2, 3), Solid.BoxIndices);
            var twice = TestMeshes.Soup(new TriangleMesh(box.Vertices,
                Solid.BoxIndices.Concat(Solid.BoxIndices).ToArray()));
            WeldedMesh one = new WeldedMesh(TestMeshes.Soup(box)), welded = new WeldedMesh(twice);

            Assert.That((welded.EdgeCount, welded.OpenEdgeCount), Is.EqualTo((one.EdgeCount, 0)));
            Assert.That(Enumerable.Range(0, 36).Select(welded.Across),
                Is.EqualTo(Enumerable.Range(0, 36).Select(one.Across)));
            Assert.That(Enumerable.Range(0, 24).Select(welded.IsDegenerate),
                Is.EqualTo(Enumerable.Range(0, 24).Select(triangle => triangle >= 12)));
            Assert.That(SurfacePatches.Find(twice).PatchCount, Is.EqualTo(6));
        }

        // The limit is twice what is asked of one thread, whose caches tests share.
        [Test]
        public void HalfAMillionTriangles_WithoutSharedVertices_AreWeldedInASecond()
        {
            var soup = TestMeshes.Soup(TestMeshes.Sea(500, 500));
            var welded = ProcessorTime.Within(1, () => new WeldedMesh(soup));
            Assert.That(welded.OpenEdgeCount, Is.EqualTo(2000));
            Assert.That(welded.EdgeCount, Is.EqualTo(500 * 501 * 2 + 500 * 500));
        }

        static int EdgesOfMoreThanTwo(WeldedMesh welded) =>
            Enumerable.Range(0, welded.EdgeCount).Count(edge => welded.SideCount(edge) > 2);
    }
}
