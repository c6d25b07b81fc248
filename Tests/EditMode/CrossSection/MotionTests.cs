using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// Pulses of one trace of moving instances, beside closed forms and traces of the scene at another time.
    /// </summary>
    [Category("Slow")]
    public sealed class MotionTests : CrossSectionFixture
    {
        // Metres, hertz, radians a metre.
        const double C = 299792458, Frequency = 10e9, WaveNumber = 2 * Math.PI * Frequency / C;

        /// <summary>A plate that approaches at 5 m/s has the Doppler shift 2 v f / c = +333.6 Hz.</summary>
        [Test, Timeout(60000)]
        public void Plate_ThatApproachesAt5MetresASecond_HasItsDopplerShift()
        {
            var pulses = new PulseTrain(2000, 64);
            var pose = PoseOf(pulses, 90, 0, Moving(CrossSectionTargets.Plate(0.3, 0.3), new double3(5, 0, 0), 0));
            var s = Responses(pose);
            var band = new FrequencyBand(Frequency, 1, 1);
            var range = new RangeTransform(band, Window.None, 1);
            var map = new RangeDopplerTransform(range, band, pulses, Window.Named("taylor"), 16);
            var spectrum = map.Map(s.Select(each => new[] { each }).ToArray());
            var level = Enumerable.Range(0, map.Rows).Select(row => spectrum[row * map.Columns].Magnitude).ToArray();
            int peak = Array.IndexOf(level, level.Max());
            Assert.That(map.DopplerOf(peak), Is.EqualTo(333.6).Within(0.5 * 2000 / map.Rows + 0.1));
            for (int pulse = 0; pulse < pulses.Count; pulse++)
                AssertNear(s[pulse], s[0] * Turn(2 * WaveNumber * 5 * pulses.TimeOf(pulse)), 1e-4 * s[0].Magnitude);
        }

        /// <summary>
        /// A plate 100 km away moves, 30 m from the scene's centre, where lengths in float32 are off by 2 um: its phase
        /// is linear in time. What holds the box around the scene returns -92 dB of it.
        /// </summary>
        [Test, Timeout(60000)]
        public void Phase_At100Kilometres_IsLinearInTime()
        {
            var pulses = new PulseTrain(1000, 128);
            double3 velocity = new double3(23.7, 1.3, -4.1);
            var moving = Moving(CrossSectionTargets.Plate(0.2, 0.2), velocity, 0);
            moving.ToWorld.Origin = new double3(30, 0, 3);
            var pose = PoseOf(pulses, 90, 0, moving,
                At(CrossSectionTargets.Plate(1e-3, 1e-3), new double3(-30, 0, -3)));
            pose.Range = 100e3;
            var s = Responses(pose);
            double3 toRadar = math.normalize(new double3(100e3, 0, 0) - moving.ToWorld.Origin);
            double rate = 2 * WaveNumber * math.dot(velocity, toRadar);
            for (int pulse = 0; pulse < pulses.Count; pulse++)
                Assert.That((s[pulse] / s[0] * Turn(-rate * pulses.TimeOf(pulse))).Phase, Is.EqualTo(0).Within(1e-3),
                    $"pulse {pulse}");
        }

        /// <summary>
        /// The double bounce of a dihedral that turns about its own edge has the same length at any time: twice the
        /// edge's. The echoes of each face have not.
        /// </summary>
        [Test, Timeout(60000)]
        public void Dihedral_ThatTurnsAboutItsEdge_HasADoubleBounceWithoutDopplerShift()
        {
            var pose = PoseOf(new PulseTrain(1000, 5), 90, 35,
                Moving(CrossSectionTargets.Dihedral(1, 0.4), 0, new double3(0, 1, 0)));
            pose.OnlyBounce = 2;
            var twice = Responses(pose);
            pose.OnlyBounce = 1;
            var once = Responses(pose);
            for (int pulse = 1; pulse < 5; pulse++)
            {
                AssertNear(twice[pulse], twice[0], 1e-4 * twice[0].Magnitude);
                Assert.That(Math.Abs((once[pulse] / once[0]).Phase), Is.GreaterThan(0.05));
            }
        }

        /// <summary>
        /// Two mirrors, each with a velocity and a turn of its own: the pulses of one trace are the traces of the scene
        /// moved to their times, up to the square of the motion. One bounce is that of the mirror across the view.
        /// </summary>
        [Test, Timeout(60000)]
        public void TwoBounces_BetweenMovingMirrors_AreThoseOfTheSceneAtTheTime(
            [Values(1, 2)] int bounce, [Values(double.PositiveInfinity, 40)] double range)
        {
            var mirrors = Mirrors();
            const double time = 2e-3;
            CrossSectionPose Pose(params MeshInstance[] instances)
            {
                var pose = PoseOf(new PulseTrain(1 / time, 2), 90, bounce == 1 ? 0 : 40, instances);
                (pose.OnlyBounce, pose.Range) = (bounce, range);
                return pose;
            }
            var s = Responses(Pose(mirrors));
            var before = Responses(Pose(Array.ConvertAll(mirrors, mirror => MovedBy(mirror, -time))))[0];
            var after = Responses(Pose(Array.ConvertAll(mirrors, mirror => MovedBy(mirror, time))))[0];
            // Central differences: what is left of the phase is of third order.
            double turn = 0.5 * (after / before).Phase, expected = (s[1] / s[0]).Phase;
            Assert.That(Math.Abs(expected), Is.GreaterThan(0.05));
            Assert.That(expected, Is.EqualTo(turn).Within(2e-3));
        }

        /// <summary>Edges move with their bodies: fringe fields alone.</summary>
        [Test, Timeout(60000)]
        public void Edges_OfAMovingPlate_AreThoseOfTheSceneAtTheTime()
        {
            var plate = Moving(CrossSectionTargets.Plate(0.3, 0.2), new double3(2, 0, 0), new double3(0, 3, 0));
            const double time = 2e-3;
            Complex[] Fringes(MeshInstance instance)
            {
                var pose = PoseOf(new PulseTrain(1 / time, 2), 90, 70, instance);
                var without = Responses(pose);
                pose.HasEdges = true;
                return Responses(pose).Zip(without, (with, each) => with - each).ToArray();
            }
            var s = Fringes(plate);
            Complex before = Fringes(MovedBy(plate, -time))[0], after = Fringes(MovedBy(plate, time))[0];
            double turn = 0.5 * (after / before).Phase, expected = (s[1] / s[0]).Phase;
            Assert.That(Math.Abs(expected), Is.GreaterThan(0.1));
            Assert.That(expected, Is.EqualTo(turn).Within(1e-2));
        }

        /// <summary>
        /// A plate that turns about its middle: to first order in the turn its phase is linear along it, and S is
        /// sin(x) / x, x = k a w t. At large turns the phase runs along each tube too.
        /// </summary>
        [Test, Timeout(60000)]
        public void Plate_ThatTurns_HasThePatternOfItsRate()
        {
            const double side = 1, turn = 0.25;
            var pose = PoseOf(new PulseTrain(1000, 256), 90, 0,
                Moving(CrossSectionTargets.Plate(side, 0.2), 0, new double3(0, 1000 * turn / 255, 0)));
            var s = Responses(pose);
            for (int pulse = 1; pulse < s.Length; pulse++)
            {
                double x = WaveNumber * side * turn * pulse / 255;
                AssertNear(s[pulse] / s[0], Math.Sin(x) / x, 2e-4);
            }
        }

        /// <summary>Where nothing moves, every pulse has the bits of a trace without pulses.</summary>
        [Test, Timeout(60000)]
        public void Pulses_OfAStillScene_AreTheBitsOfOne()
        {
            var instance = At(CrossSectionTargets.Dihedral(0.5, 0.3), 0);
            var pose = PoseOf(new PulseTrain(1000, 3), 90, 30, instance);
            var s = Tracer.Trace(pose).S;
            pose.Times = new double[] { 0 };
            var alone = Tracer.Trace(pose).S[0, 0];
            for (int pulse = 0; pulse < 3; pulse++)
                Assert.That(s[0, pulse], Is.EqualTo(alone));
            // The first pulse of one that moves, too.
            instance.Motion = new RigidMotion { Velocity = new double3(3, 2, 1) };
            var moving = Tracer.Trace(PoseOf(new PulseTrain(1000, 3), 90, 30, instance)).S;
            Assert.That(moving[0, 0], Is.EqualTo(alone));
            Assert.That(moving[0, 1], Is.Not.EqualTo(alone));
        }

        // Faces of a dihedral of 90 degrees whose corner is open.
        static MeshInstance[] Mirrors()
        {
            MeshInstance Mirror(double degrees, double3 position, RigidMotion motion)
            {
                double half = math.radians(degrees) / 2;
                motion.Pivot = position + new double3(0.1, -0.2, 0.3);
                return new MeshInstance
                {
                    Mesh = CrossSectionTargets.Plate(1, 0.4), Motion = motion,
                    ToWorld = Affine.FromTransform(position, new double4(0, Math.Sin(half), 0, Math.Cos(half)), 1)
                };
            }
            return new[]
            {
                Mirror(0, new double3(0, 0, 0.8), new RigidMotion
                    { Velocity = new double3(0.7, 0.3, -0.4), AngularVelocity = new double3(0.05, 0.02, -0.3) }),
                Mirror(90, new double3(0.8, 0, 0), new RigidMotion
                    { Velocity = new double3(-0.2, 0.1, -0.5), AngularVelocity = new double3(0.1, -0.02, 0.2) })
            };
        }

        // The instance after a time: turned about its pivot, then shifted.
        static MeshInstance MovedBy(MeshInstance instance, double time)
        {
            var motion = instance.Motion;
            double3 turn = time * motion.AngularVelocity;
            double angle = math.length(turn);
            double3 axis = angle > 0 ? Math.Sin(angle / 2) / angle * turn : 0;
            var rotation = Affine.FromTransform(motion.Pivot + time * motion.Velocity,
                new double4(axis, Math.Cos(angle / 2)), 1);
            var fromPivot = Affine.Identity;
            fromPivot.Origin = -motion.Pivot;
            instance.ToWorld = rotation * fromPivot * instance.ToWorld;
            instance.Motion = default;
            return instance;
        }

        static MeshInstance At(TriangleMesh mesh, double3 position)
        {
            var toWorld = Affine.Identity;
            toWorld.Origin = position;
            return new MeshInstance { Mesh = mesh, ToWorld = toWorld };
        }

        static MeshInstance Moving(TriangleMesh mesh, double3 velocity, double3 angularVelocity)
        {
            var instance = At(mesh, 0);
            instance.Motion = new RigidMotion { Velocity = velocity, AngularVelocity = angularVelocity };
            return instance;
        }

        static CrossSectionPose PoseOf(PulseTrain pulses, double theta, double phi, params MeshInstance[] instances)
        {
            var radar = PublishedRow.Aspect(theta, phi);
            return new CrossSectionPose
            {
                Scene = new RadarScene(instances), Radar = radar, Receivers = new[] { radar }, HasEdges = false,
                ToleranceDb = 0.02, Frequencies = new[] { Frequency },
                Times = Enumerable.Range(0, pulses.Count).Select(pulses.TimeOf).ToArray()
            };
        }

        Complex[] Responses(CrossSectionPose pose)
        {
            var s = Tracer.Trace(pose).S;
            return Enumerable.Range(0, pose.Samples).Select(sample => s[0, sample].VV).ToArray();
        }

        static Complex Turn(double angle) => new Complex(Math.Cos(angle), Math.Sin(angle));

        static void AssertNear(Complex value, Complex expected, double tolerance) =>
            Assert.That((value - expected).Magnitude, Is.LessThan(tolerance), $"{value}, {expected}");
    }
}
