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
