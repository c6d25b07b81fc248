using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Patches on the device, pose by pose.</summary>
    public sealed class PatchBuffersTests
    {
        // A mesh that changes, such as a moving sea, is another one in each pose.
        [Test]
        public void Set_OfOtherMeshes_KeepsThoseOfTheSceneAlone()
        {
            using var patches = new PatchBuffers();
            TriangleMesh ship = TestMeshes.Clump(2, 2), sea = TestMeshes.Sea(3, 3);
            Assert.That(patches.Set(new RadarScene(ship), 0), Is.True);
            Assert.That(patches.Set(new RadarScene(ship), 0), Is.False, "the same scene");
            for (int pose = 0; pose < 3; pose++)
                patches.Set(new RadarScene(TestMeshes.Sea(4, pose + 1)), 0);
            patches.Set(new RadarScene(sea), 0);
            Assert.That(patches.MeshCount, Is.EqualTo(1));
            Assert.That(patches.OfInstances[0].PatchOf.Length, Is.EqualTo(sea.TriangleCount));
        }

        // Objects have their own numbers: tiles of a sea by the thousand. Another material ends patches elsewhere.
        [Test]
        public void Set_OfAMeshThatRepeats_FindsItsPatchesOnceForEachMaterial()
        {
            using var patches = new PatchBuffers();
            var sea = TestMeshes.Sea(3, 3);
            MeshInstance Of(params MeshRange[] ranges) =>
                new MeshInstance { Mesh = sea, ToWorld = Affine.Identity, Ranges = ranges };
            patches.Set(new RadarScene(Of(new MeshRange(0, 0, 0)), Of(new MeshRange(0, 1, 0))), 20);
            Assert.That(patches.OfInstances[1], Is.SameAs(patches.OfInstances[0]));
            Assert.That(patches.NormalFields.Buffer.count, Is.LessThanOrEqualTo(3 * sea.TriangleCount));
            patches.Set(new RadarScene(Of(new MeshRange(0, 0, 0)), Of(new MeshRange(0, 1, 0), new MeshRange(8, 1, 1)))
            {
                Surfaces = new[] { SurfaceMaterial.PerfectConductor, new SurfaceMaterial("other") }
            }, 20);
            Assert.That(patches.OfInstances[1].PatchCount, Is.EqualTo(1 + patches.OfInstances[0].PatchCount));
        }
    }
}
