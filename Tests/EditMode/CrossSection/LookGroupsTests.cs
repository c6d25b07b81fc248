using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Looks of an image that share a trace, beside closed forms and traces of each.</summary>
    [Category("Slow")]
    public sealed class LookGroupsTests : CrossSectionFixture
    {
        // Metres, hertz; degrees between looks.
        const double C = 299792458, Frequency = 10e9, Step = 0.006;

        // Half of the angle of a group at most, rad: 60 dB below what a facet returns at most.
        const double MaxPart = 1e-3;

        // So far from the phase centre a target moves by 4 cm in a group, 1.4 wavelengths.
        static readonly double3 s_position = new double3(20, 4, -5);

        /// <summary>
        /// Physical optics of a plate: S = -j k / sqrt(pi) n.r times the integral of exp(2 j k r.x) over it. Its
        /// strength n.r changes by the angle at most.
        /// </summary>
        [Test, Timeout(60000)]
        public void Plate_FarFromThePhaseCentre_HasItsClosedFormAtEachLook([Values(0, 3, 30)] double elevation,
            [Values(270, 269, 245)] double azimuth)
        {
            const double width = 0.8, height = 0.3, k = 2 * Math.PI * Frequency / C, s = width * height * k;
            var plan = PlanOf(azimuth, elevation);
            var looks = Trace(plan, At(CrossSectionTargets.Plate(width, height)));
            Assert.That(looks, Has.Length.GreaterThan(10));
            for (int i = 0; i < looks.Length; i++)
            {
                double3 r = plan[i].Radar.ToRadar;
                var expected = -Complex.ImaginaryOne * s / Math.Sqrt(Math.PI) * Math.Abs(r.x)
                    * TubeField.Sinc(k * width * r.z) * TubeField.Sinc(k * height * r.y)
                    * Complex.FromPolarCoordinates(1, 2 * k * math.dot(r, s_position));
                Assert.That((looks[i].VV - expected).Magnitude, Is.LessThan(MaxPart * s / Math.Sqrt(Math.PI)), $"{i}");
                Assert.That((looks[i].HH - expected).Magnitude, Is.LessThan(MaxPart * s / Math.Sqrt(Math.PI)), $"{i}");
            }
        }

        /// <summary>
        /// Several bounces and all polarisations. The apertures of plane mirrors change by 1 to 2 times the angle where
        /// these directions look into them; errors of the integration add 2/1000 at most.
        /// </summary>
        [Test, Timeout(60000)]
        public void Mirrors_FarFromThePhaseCentre_AreThoseOfATraceOfEachLook([Values(0, 30)] double elevation,
            [Values("dihedral", "turned dihedral", "trihedral", "sphere")] string name)
        {
            var (mesh, azimuth) = name switch
            {
                "dihedral" => (CrossSectionTargets.Dihedral(1, 0.5), 213.0),
                "turned dihedral" => (CrossSectionTargets.DihedralAboutSight(0.6, 0.3, 22.5), 270),
                "trihedral" => (CrossSectionTargets.Trihedral(0.6, CrossSectionTargets.TrihedralFace.Triangular), 213),
                _ => (CrossSectionTargets.Sphere(0.15, 32), 213)
            };
            var plan = PlanOf(azimuth, elevation);
            var looks = Trace(plan, At(mesh));
            foreach (int i in new[] { 0, looks.Length - 1 })
            {
                var s = Tracer.Trace(PoseOf(plan[i].Radar, new RadarScene(At(mesh)))).S[0, 0];
                double largest = Polarisation.All.Max(each => each.Of(s).Magnitude);
                foreach (var each in Polarisation.All)
                    Assert.That((each.Of(looks[i]) - each.Of(s)).Magnitude,
                        Is.LessThan((2 * MaxPart + 2e-3) * largest), $"{each}, look {i}");
            }
        }

        /// <summary>
        /// A run has as many traces as groups, and the same rows where a part of it begins within one. Other runs have
        /// no groups.
        /// </summary>
        [Test, Timeout(60000)]
        public void Run_OfAnImage_HasTheRowsOfItsGroupsInEveryPart()
        {
            var plan = new CrossSectionPlan(Enumerable.Range(0, 9).Select(look => 213 + look * Step).ToArray(),
                new[] { 3.0 }, new[] { Frequency, 1.01 * Frequency });
            var setup = new CrossSectionSetup(new RadarScene(At(CrossSectionTargets.Dihedral(0.3, 0.2))), plan)
            { ToleranceDb = 0.3 };
            Assert.That(setup.Looks.Looks, Is.EqualTo(1));
            setup.Echo = new EchoSettings { Bandwidth = 2e8, Image = new IsarSettings { Side = 1, Pixels = 1 } };
            var (whole, traces) = Rows(setup, null);
            Assert.That(setup.Looks.Looks, Is.EqualTo(3));
            Assert.That(traces, Is.EqualTo(3));
            var parts = Enumerable.Range(1, 2).SelectMany(part => Rows(setup, new SweepShard(part, 2)).rows);
            Assert.That(parts, Is.EqualTo(whole));
            var looks = setup.Looks;
            for (int look = 0; look < 9; look++)
                Assert.That(looks.MiddleOf(look), Is.EqualTo(213 + (look / 3 * 3 + 1) * Step).Within(1e-9));
        }

        static (ScatteringMatrix[] rows, int traces) Rows(CrossSectionSetup setup, SweepShard? part)
        {
            using (var run = new CrossSectionRun(setup, TestKernels.Tubes, shard: part))
                return (Enumerable.Range(0, run.Count).Select(_ => run.Step().S).ToArray(), run.Traces);
        }

        /// <summary>
        /// The image made from groups differs from that of a trace of each look by less than -60 dB of its peak.
        /// </summary>
        [Test, Timeout(60000)]
        public void Image_OfPlates_IsThatOfATraceOfEachLook()
        {
            var plan = PlanOf(269.9, 3);
            var plate = At(CrossSectionTargets.Plate(0.4, 0.3));
            var groups = Trace(plan, plate);
            var each = groups.Select((_, i) =>
                Tracer.Trace(PoseOf(plan[i].Radar, new RadarScene(plate))).S[0, 0]).ToArray();
            var band = new FrequencyBand(Frequency, 1e6, 1);
            var range = new RangeTransform(band, Window.None, 16, -75);
            Complex[] ImageOf(ScatteringMatrix[] looks) => new IsarTransform(range, band,
                looks.Select((_, i) => plan[i].Radar).ToArray(), plan[0].AzimuthDegrees, Window.None, 60, 60)
                .Image(looks.Select(s => range.Profile(new[] { s.VV })).ToArray());
            var expected = ImageOf(each);
            double peak = expected.Max(pixel => pixel.Magnitude);
            Assert.That(ImageOf(groups).Zip(expected, (a, b) => (a - b).Magnitude).Max(), Is.LessThan(1e-3 * peak));
        }

        // The looks of the first group.
        ScatteringMatrix[] Trace(CrossSectionPlan plan, MeshInstance instance)
        {
            var scene = new RadarScene(instance);
            var (min, max) = scene.Bound();
            var looks = new LookGroups(plan, min, max, 1, MaxPart);
            var middle = plan[0];
            middle.AzimuthDegrees = looks.MiddleOf(0);
            var pose = PoseOf(middle.Radar, scene.MovingBy(LookGroups.TurnAbout(0)));
            (pose.Times, pose.WaveFactors) = (looks.Times, looks.Factors);
            var s = Tracer.Trace(pose).S;
            return Enumerable.Range(0, looks.Looks).Select(look => s[0, look]).ToArray();
        }

        static CrossSectionPlan PlanOf(double azimuth, double elevation) => new CrossSectionPlan(
            Enumerable.Range(0, 60).Select(look => azimuth + look * Step).ToArray(), new[] { elevation },
            new[] { Frequency });

        static CrossSectionPose PoseOf(RadarAspect radar, RadarScene scene) => new CrossSectionPose
        {
            Scene = scene, Radar = radar, Receivers = new[] { radar }, HasEdges = false, ToleranceDb = 0.01,
            Frequencies = new[] { Frequency }
        };

        static MeshInstance At(TriangleMesh mesh)
        {
            var toWorld = Affine.Identity;
            toWorld.Origin = s_position;
            return new MeshInstance { Mesh = mesh, ToWorld = toWorld };
        }
    }
}
