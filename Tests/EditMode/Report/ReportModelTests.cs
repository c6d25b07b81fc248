using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class ReportModelTests
    {
        [Test]
        public void Model_OfTooManyTiles_HasEveryMesh()
        {
            var tile = Triangle(1);
            var instances = Enumerable.Range(0, ReportModel.MaxInstances + 5)
                .Select(i => Instance(tile, new double3(i, 0, 0)))
                .Append(Instance(Triangle(2), 0)).Append(Instance(Triangle(3), 0)).ToArray();

            var json = new ReportModel(new RadarScene(instances), 0).ToJson();

            Assert.That(json["instances"].Count(), Is.EqualTo(ReportModel.MaxInstances));
            Assert.That(json["meshes"].Count(), Is.EqualTo(3));
        }

        static MeshInstance Instance(TriangleMesh mesh, double3 position)
        {
            var toWorld = Affine.Identity;
            toWorld.Origin = position;
            return new MeshInstance { Mesh = mesh, ToWorld = toWorld };
        }

        static TriangleMesh Triangle(float side) => new TriangleMesh(
            new[] { new float3(0, 0, 0), new float3(side, 0, 0), new float3(0, side, 0) }, new[] { 0, 1, 2 });
    }
}
