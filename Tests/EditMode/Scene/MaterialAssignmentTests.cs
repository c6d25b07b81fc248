using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>The text of --material.</summary>
    public sealed class MaterialAssignmentTests
    {
        static readonly Medium s_coating = Medium.Constant(4, 0.4);

        [Test]
        public void Read_Metal_IsAConductor()
        {
            var read = MaterialAssignment.Read("hull=metal");
            Assert.That(read.Surface, Is.EqualTo("hull"));
            Assert.That(read.Material, Is.EqualTo(new SurfaceMaterial("hull")));
            Assert.That(read.Material.IsConductor);
        }

        [Test]
        public void Read_LayersOnMetal_AreInOrder()
        {
            var paint = new MaterialLayer(s_coating, 0.002);
            AssertRead("hull=metal,4,0.4,1,0,0.002", new SurfaceMaterial("hull", new[] { paint }));
            AssertRead("hull=metal, 4, 0.4, 1, 0, 2e-3", new SurfaceMaterial("hull", new[] { paint }));
            AssertRead("hull=metal,4,0.4,1,0,0.002,17,0.34,1.5,1.8,0", new SurfaceMaterial("hull",
                new[] { paint, new MaterialLayer(Medium.Constant(17, 0.34, 1.5, 1.8), 0) }));
            AssertRead("hull=metal,ptfe,0.01,4,0.4,1,0,0.002", new SurfaceMaterial("hull",
                new[] { new MaterialLayer(PublishedMaterial.Find("ptfe").Medium, 0.01), paint }));
        }

        [Test]
        public void Read_Open_EndsWithTheHalfSpace()
        {
            AssertRead("wall=open,4,0.4,1,0", new SurfaceMaterial("wall", null, s_coating));
            AssertRead("wall=open,4,0.4,1,0,0.002,itu_brick", new SurfaceMaterial("wall",
                new[] { new MaterialLayer(s_coating, 0.002) }, PublishedMaterial.Find("itu_brick").Medium));
        }

        [Test]
        public void Read_APublishedName_IsItsSurface()
        {
            AssertRead("wall=itu_concrete", PublishedMaterial.Find("itu_concrete").ToSurface("wall"));
            AssertRead("wall=arc_dd_13490", PublishedMaterial.Find("arc_dd_13490").ToSurface("wall"));
        }

        [Test]
        public void Read_ForAnySurface_IsCalledByItsText()
        {
            var read = MaterialAssignment.Read("*=metal,4,0.4,1,0,0.002");
            Assert.That(read.Surface, Is.EqualTo(MaterialAssignment.AnySurface));
            Assert.That(read.Material.Name, Is.EqualTo("metal,4,0.4,1,0,0.002"));
            Assert.That(read.Material.Layers.Single().ToString(),
                Is.EqualTo(new MaterialLayer(s_coating, 0.002).ToString()));
        }

        [Test]
        public void Apply_GivesANameItsMaterialAndTheOthersThatOfAny()
        {
            SurfaceMaterial hull = new SurfaceMaterial("hull"), mast = new SurfaceMaterial("mast");
            var scene = SceneOf(SurfaceMaterial.PerfectConductor, hull, mast);
            Assert.That(Materials(scene), Is.EqualTo(Materials(Apply(scene))), "none given");

            var applied = Apply(scene, "hull=open,4,0.4,1,0", "*=metal,4,0.4,1,0,0.002");
            Assert.That(Materials(applied), Is.EqualTo(new[]
                { "metal,4,0.4,1,0,0.002", "hull", "metal,4,0.4,1,0,0.002" }));
            Assert.That(applied.Surfaces[0], Is.EqualTo(SurfaceMaterial.PerfectConductor));
            Assert.That(Materials(Apply(scene, "mast=itu_wood")),
                Is.EqualTo(new[] { "perfect conductor", "hull", "mast" }));
        }

        [Test]
        public void Apply_OfAnUnknownNameOrTwice_IsRefused()
        {
            var scene = SceneOf(SurfaceMaterial.PerfectConductor, new SurfaceMaterial("hull"));
            Assert.That(() => Apply(scene, "hul=metal"), Throws.TypeOf<GlintException>().With.Message.EqualTo(
                "there is no surface hul to give a material to: the surfaces are hull, and * for all others"));
            Assert.That(() => Apply(SceneOf(SurfaceMaterial.PerfectConductor), "hull=metal"),
                Throws.TypeOf<GlintException>().With.Message.Contain("the triangles name none, give * for all"));
            Assert.That(() => Apply(scene, "hull=metal", "hull=itu_wood"),
                Throws.TypeOf<UsageException>().With.Message.Contain("the surface hull is given two materials"));
        }

        // A triangle of each surface.
        static RadarScene SceneOf(params SurfaceMaterial[] surfaces) => new RadarScene(new MeshInstance
        {
            Mesh = new TriangleMesh(new Unity.Mathematics.float3[3],
                Enumerable.Range(0, 3 * surfaces.Length).Select(i => i % 3).ToArray()),
            ToWorld = Affine.Identity,
            Ranges = surfaces.Select((_, i) => new MeshRange(i, 0, i)).ToArray()
        })
        { Surfaces = surfaces };

        static RadarScene Apply(RadarScene scene, params string[] texts) =>
            MaterialAssignment.Apply(scene, texts.Select(MaterialAssignment.Read).ToArray());

        static string[] Materials(RadarScene scene) =>
            scene.Instances[0].Ranges.Select(range => scene.Surfaces[range.Surface].Name).ToArray();

        [Test]
        public void Read_ANameWithAnEqualsSign_IsSplitAtTheLast() =>
            Assert.That(MaterialAssignment.Read("a=b=metal").Surface, Is.EqualTo("a=b"));

        [TestCase("hull", "must be NAME=metal; NAME=metal,MEDIUM,t; ")]
        [TestCase("=metal", "must be NAME=metal; ")]
        [TestCase("hull=", "must be NAME=metal; ")]
        [TestCase("hull=concrete", "no published material is called concrete: give one of itu_concrete, ")]
        [TestCase("hull=4,0.4,1,0", "begins with 4: must be NAME=metal; ")]
        [TestCase("hull=metal,4,0.4,1", "mu'' is missing: must be ")]
        [TestCase("hull=metal,4,0.4,1,0", "the thickness t in metres is missing: must be ")]
        [TestCase("hull=metal,4,x,1,0,0.002", "e'' is x, not a number: must be ")]
        [TestCase("hull=metal,4,0.4,1,0,2mm", "the thickness t in metres is 2mm, not a number: must be ")]
        [TestCase("hull=metal,", "no published material is called \"\": give one of ")]
        [TestCase("hull=metal,4,0.4,1,0,-1", "the thickness of a layer is -1 m: give 0 or more")]
        [TestCase("hull=metal,4,-0.4,1,0,1", "the relative permittivity e' = 4, e'' = -0.4 has gain: give e'' of 0")]
        [TestCase("hull=open", "the medium of the half-space is missing: must be ")]
        [TestCase("hull=open,4,0.4,1,0,0.1", "the medium of the half-space is missing: must be ")]
        [TestCase("hull=open,0,0,1,0", "the relative permittivity e' = 0, e'' = 0 is 0: ")]
        public void Read_OfAnotherText_SaysWhatItMustBe(string text, string message) =>
            Assert.That(Assert.Throws<FormatException>(() => MaterialAssignment.Read(text)).Message,
                Does.StartWith(message));

        static void AssertRead(string text, SurfaceMaterial expected) =>
            Assert.That(MaterialAssignment.Read(text).Material, Is.EqualTo(expected));
    }
}
