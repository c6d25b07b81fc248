using System.Linq;
using System.Threading;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class OptionsTests
    {
        [Test]
        public void Defaults_OfTheRadar_AreThoseOfTheExperiment()
        {
            var settings = RadarSettings.Default;

            Assert.That(Options.Frequency.Default, Is.EqualTo(settings.FrequencyHz));
            Assert.That(Options.Size.Default, Is.EqualTo(new int2(settings.RaysAcross, settings.RaysDown)));
            Assert.That(Options.Bounces.Default, Is.EqualTo(settings.MaxBounces));
            Assert.That(Options.Receiver.Default, Is.EqualTo(new double2(3, 3)));
            Assert.That(Options.Fov.Default, Is.EqualTo(60));
            Assert.That(Options.Grazing.Default, Is.EqualTo(10));
            Assert.That(Options.Distance.Default, Is.EqualTo(50));
            Assert.That(Options.Azimuth.Default, Is.EqualTo(0));
            Assert.That(Options.Aim.Default, Is.EqualTo(new double3(0, 0, 0)));
            Assert.That(Options.Unit.Default.Meters, Is.EqualTo(1));
            Assert.That(Options.Up.Default, Is.EqualTo(UpAxis.Y));
            Assert.That(Options.Spacing.Default, Is.Zero, "rays from one point");
            Assert.That(Options.Out.Default, Is.Null);
        }

        [Test]
        public void EveryOption_HasWordsForTheUser()
        {
            foreach (var option in Commands.All.SelectMany(command => command.Options).Distinct())
            {
                Assert.That(option.Help, Does.EndWith(".").Or.EndWith(")."), option.Flag);
                Assert.That(option.Group, Is.Not.Null.And.Not.Empty, option.Flag);
                Assert.That(option.Refusal != null, Is.EqualTo(option.Inputs != InputKind.Any), option.Flag);
                if (option.DefaultText != null)
                    Assert.That(option.ParseValue(option.DefaultText), Is.EqualTo(option.DefaultValue), option.Flag);
            }
        }

        [TestCase("frequency", "9.4e9")]
        [TestCase("frequency", "1")]
        [TestCase("frequency", "1e12")]
        [TestCase("bounces", "1")]
        [TestCase("bounces", "16")]
        [TestCase("grazing", "-90")]
        [TestCase("grazing", "90")]
        [TestCase("fov", "0.3")]
        [TestCase("fov", "179")]
        [TestCase("fov", "1e-5")]
        [TestCase("distance", "1e-6")]
        [TestCase("receiver", "1e-6")]
        [TestCase("spacing", "0.003")]
        [TestCase("aperture", "20")]
        [TestCase("aperture", "20x0.5")]
        [TestCase("size", "1x1")]
        [TestCase("size", "524280X524280")]
        [TestCase("receiver", "0.5")]
        [TestCase("region", "0,0,1,1")]
        [TestCase("reference", "1000000")]
        [TestCase("seed", "0")]
        [TestCase("unit", "ft")]
        [TestCase("up", "z")]
        public void Value_InItsRange_IsTaken(string name, string text) =>
            Assert.That(Find(name).ParseValue(text), Is.Not.Null);

        [TestCase("bounces", "17", "--bounces 17: must be from 1 to 16")]
        [TestCase("bounces", "0", "--bounces 0: must be from 1 to 16")]
        [TestCase("bounces", "4.5", "--bounces 4.5: must be a whole number from 1 to 16")]
        [TestCase("bounces", "99999999999999999999", "--bounces 99999999999999999999: must be from 1 to 16")]
        [TestCase("bounces", "1e1", "--bounces 1e1: must be a whole number from 1 to 16")]
        [TestCase("frequency", "0", "--frequency 0: must be from 1 to 1e12")]
        [TestCase("frequency", "-10e9", "--frequency -10e9: must be from 1 to 1e12")]
        [TestCase("frequency", "NaN", "--frequency NaN: must be a number, such as 0.5 or 10e9")]
        [TestCase("frequency", "1e999", "--frequency 1e999: must be a number, such as 0.5 or 10e9")]
        [TestCase("frequency", "10 GHz", "--frequency \"10 GHz\": must be a number, such as 0.5 or 10e9")]
        [TestCase("frequency", "9,4e9", "--frequency 9,4e9: must be a number, such as 0.5 or 10e9")]
        [TestCase("fov", "0", "--fov 0: must be from 1e-5 to 179")]
        [TestCase("fov", "179.0000001", "--fov 179.0000001: must be from 1e-5 to 179")]
        [TestCase("fov", "1e-50", "--fov 1e-50: must be from 1e-5 to 179")]
        [TestCase("fov", "180", "--fov 180: must be from 1e-5 to 179")]
        [TestCase("grazing", "90.5", "--grazing 90.5: must be from -90 to 90")]
        [TestCase("distance", "0", "--distance 0: must be from 1e-6 to 1e6")]
        [TestCase("distance", "1e-320", "--distance 1e-320: must be from 1e-6 to 1e6")]
        [TestCase("distance", "", "--distance \"\": must be a number, such as 0.5 or 10e9")]
        [TestCase("spacing", "0", "--spacing 0: must be from 1e-6 to 1e6")]
        [TestCase("aperture", "1x0", "--aperture 1x0: each number must be from 1e-6 to 1e6")]
        [TestCase("size", "1920", "--size 1920: must be ACROSSxDOWN, two whole numbers, such as 1920x1080")]
        [TestCase("size", "1920x", "--size 1920x: must be ACROSSxDOWN, two whole numbers, such as 1920x1080")]
        [TestCase("tiles", "1", "--tiles 1: must be ACROSSxDOWN, two whole numbers, each from 1 to 100")]
        [TestCase("size", "0x1080", "--size 0x1080: each number must be from 1 to 524280")]
        [TestCase("size", "1920x-1", "--size 1920x-1: each number must be from 1 to 524280")]
        [TestCase("receiver", "-3", "--receiver -3: each number must be from 1e-6 to 1e6")]
        [TestCase("receiver", "3x1e-320", "--receiver 3x1e-320: each number must be from 1e-6 to 1e6")]
        [TestCase("receiver", "3x", "--receiver 3x: must be SIDE or WIDTHxHEIGHT in metres, such as 3 or 4x2.5")]
        [TestCase("region", "0,0,1",
            "--region 0,0,1: must be LEFT,BOTTOM,WIDTH,HEIGHT, four whole numbers, such as 480,0,960,540")]
        [TestCase("region", "0,0,1,",
            "--region 0,0,1,: must be LEFT,BOTTOM,WIDTH,HEIGHT, four whole numbers, such as 480,0,960,540")]
        [TestCase("region", "0,0,1,0", "--region 0,0,1,0: must have a width and a height above 0")]
        [TestCase("region", "-1,0,1,1", "--region -1,0,1,1: each number must be from 0 to 524280")]
        [TestCase("reference", "some",
            "--reference some: must be all, none or a whole number, such as 100 for every 100th ray")]
        [TestCase("reference", "0", "--reference 0: must be all, none or a number from 1 to 1e6")]
        [TestCase("rounds", "0", "--rounds 0: must be from 1 to 1000")]
        [TestCase("peer", "./embree", "--peer ./embree: must be NAME=COMMAND, such as \"Embree=./embree {scene}\"")]
        [TestCase("peer", "=./embree", "--peer =./embree: must be NAME=COMMAND, such as \"Embree=./embree {scene}\"")]
        [TestCase("peer", "Embree= ", "--peer \"Embree= \": must be NAME=COMMAND, such as \"Embree=./embree {scene}\"")]
        [TestCase("aim", "1,2", "--aim 1,2: must be X,Y,Z, three numbers, such as 0,1.5,-2")]
        [TestCase("aim", "1,2,1e7", "--aim 1,2,1e7: each number must be from -1e6 to 1e6")]
        [TestCase("unit", "MM", "--unit MM: must be one of m, dm, cm, mm, um, km, in, ft")]
        [TestCase("up", "x", "--up x: must be y or z")]
        [TestCase("target", " ", "--target \" \": must not be empty")]
        [TestCase("out", "", "--out \"\": must not be empty")]
        [TestCase("angles", "0:45",
            "--angles 0:45: a range has three parts: give FROM:TO:STEP, such as 0:45:1, or a list, such as 0,10,45")]
        public void Value_OutOfItsRange_IsRefusedByName(string name, string text, string message)
        {
            var error = Assert.Throws<UsageException>(() => Find(name).ParseValue(text));

            Assert.That(error.Message, Is.EqualTo(message));
            Assert.That(error.ExitCode, Is.EqualTo(2));
        }

        [Test]
        public void Region_IsLeftBottomWidthHeight()
        {
            var region = Options.Region.Parse("10, 20,30,40");
            Assert.That(new[] { region.Left, region.Bottom, region.Width, region.Height },
                Is.EqualTo(new[] { 10, 20, 30, 40 }));
            Assert.That(Options.Region.Default.IsWhole);
        }

        [TestCase("all", 1)]
        [TestCase("none", 0)]
        [TestCase("7", 7)]
        public void Reference_IsAllNoneOrEveryNth(string text, int every) =>
            Assert.That(Options.Reference.Parse(text), Is.EqualTo(every));

        [Test]
        public void Peer_HasANameAndACommandThatMayHoldEqualsSigns()
        {
            var peer = Options.Peers.Parse("BVH 2=FAST=1 ./naive {scene} 2=3").Single();
            Assert.That((peer.Name, peer.Command), Is.EqualTo(("BVH 2", "FAST=1 ./naive {scene} 2=3")));
        }

        [Test]
        public void Receiver_OfOneNumber_IsSquare()
        {
            Assert.That(Options.Receiver.Parse("2.5"), Is.EqualTo(new double2(2.5, 2.5)));
            Assert.That(Options.Receiver.Parse("4x2"), Is.EqualTo(new double2(4, 2)));
        }

        [TestCase("mm", 0.001)]
        [TestCase("in", 0.0254)]
        [TestCase("ft", 0.3048)]
        [TestCase("km", 1000)]
        public void Unit_OfTheFile_IsKnownInMetres(string name, double meters) =>
            Assert.That(Options.Unit.Parse(name).Meters, Is.EqualTo(meters));

        [Test]
        public void Numbers_InACultureWithDecimalCommas_AreReadWithPoints()
        {
            var before = Thread.CurrentThread.CurrentCulture;
            try
            {
                var commas = (System.Globalization.CultureInfo)before.Clone();
                commas.NumberFormat.NumberDecimalSeparator = ",";
                commas.NumberFormat.NumberGroupSeparator = ".";
                Thread.CurrentThread.CurrentCulture = commas;

                Assert.That(Options.Distance.Parse("1.5"), Is.EqualTo(1.5));
                Assert.That(Options.Angles.Parse("0:0.2:0.1"), Is.EqualTo(new[] { 0, 0.1, 0.2 }));
                Assert.That(Assert.Throws<UsageException>(() => Options.Aim.Parse("0,0,-0.5e9")).Message,
                    Does.Contain("from -1e6 to 1e6"));
            }
            finally
            {
                Thread.CurrentThread.CurrentCulture = before;
            }
        }

        [TestCase("grazing", "1,91", "--grazing 1,91: each angle must be from -90 to 90 degrees")]
        [TestCase("distance", "0:10:1", "--distance 0:10:1: each distance must be from 1e-6 to 1e6 metres")]
        [TestCase("frequency", "", "--frequency \"\": no frequencies: give FROM:TO:STEP, such as 9e9:11e9:0.1e9, "
            + "or a list, such as 9.4e9,10e9")]
        [TestCase("frequency", "9e9:1e10:0", "--frequency 9e9:1e10:0: STEP must be above 0")]
        public void List_OfASweepOutOfItsRange_IsRefusedByName(string name, string text, string message) =>
            Assert.That(Assert.Throws<UsageException>(() => Commands.Sweep.Options.Single(option => option.Name == name)
                .ParseValue(text)).Message, Is.EqualTo(message));

        // A sweep, cross sections, range profiles and images have options of the same names with other values.
        static Option Find(string name) => Commands.All
            .OrderBy(new[] { Commands.Sweep, Commands.Rcs, Commands.Echo, Commands.Isar }.Contains)
            .SelectMany(command => command.Options).First(option => option.Name == name);
    }
}
