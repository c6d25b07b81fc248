using System;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Velocities of a gathered scene: of Rigidbody and RadarMotion.</summary>
    public sealed class SceneMotionTests : GathererFixture
    {
        [Test]
        public void Rigidbody_GivesItsVelocitiesToAllBelowIt()
        {
            var ship = _scene.Empty("Ship");
            ship.localPosition = new Vector3(5, 1, -2);
            var body = ship.gameObject.AddComponent<Rigidbody>();
            body.linearVelocity = new Vector3(1, 2, 3);
            body.angularVelocity = new Vector3(0.1f, 0.2f, -0.3f);
            body.centerOfMass = new Vector3(0, 1, 0);
            _scene.Add("Hull", SceneBuilder.Mesh(3, 1), ship);
            _scene.Add("Mast", SceneBuilder.Mesh(2, 2), ship);
            _scene.Add("Rock", SceneBuilder.Mesh(4, 3));
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances, Has.Length.EqualTo(2), "hull and mast are one mesh");
            var moving = Array.Find(scene.Instances, instance => instance.Mesh.TriangleCount == 5);
            Assert.That(scene.IsMoving);
            // As Rigidbody.GetPointVelocity.
            float3 point = new float3(7, -1, 4), expected = (float3)body.linearVelocity
                + math.cross(body.angularVelocity, point - (float3)body.worldCenterOfMass);
            Assert.That(math.distance(moving.Motion.VelocityAt(point - scene.Origin), expected), Is.LessThan(1e-5));
            Assert.That(Array.Find(scene.Instances, instance => instance.Mesh.TriangleCount == 4).Motion.IsNone);
            Assert.That(_scene.Gather(_gatherer), Is.SameAs(scene));
            body.linearVelocity = new Vector3(1, 2, 4);
            var later = _scene.Gather(_gatherer);
            Assert.That(later, Is.Not.SameAs(scene));
            Assert.That(Array.Exists(later.Instances, instance => instance.Mesh == moving.Mesh), "the BVH is kept");
        }

        /// <summary>The nearest one counts; a RadarMotion before a Rigidbody.</summary>
        [Test]
        public void RadarMotion_TurnsAboutItsPosition()
        {
            var ship = _scene.Empty("Ship");
            ship.gameObject.AddComponent<Rigidbody>().linearVelocity = new Vector3(9, 9, 9);
            var antenna = _scene.Empty("Antenna", ship);
            antenna.localPosition = new Vector3(3, 20, 1);
            var motion = antenna.gameObject.AddComponent<RadarMotion>();
            motion.TurnRates = new Vector3(0, 144, 0);
            motion.Velocity = new Vector3(0, 0, 5);
            _scene.Add("Reflector", SceneBuilder.Mesh(1, 1), antenna);
            var scene = _scene.Gather(_gatherer);
            var moving = scene.Instances[0].Motion;
            double3 pivot = new double3(3, 20, 1) - scene.Origin;
            Assert.That(math.distance(moving.VelocityAt(pivot), new double3(0, 0, 5)), Is.LessThan(1e-6));
            // +Z goes to +X, as Transform.Rotate does.
            double3 before = moving.VelocityAt(pivot + new double3(0, 0, 1)) - new double3(0, 0, 5);
            Assert.That(math.distance(before, new double3(144 * Math.PI / 180, 0, 0)), Is.LessThan(1e-5));
            Vector3 turned = Quaternion.Euler(0, 1.44f, 0) * new Vector3(0, 0, 1);
            Assert.That(turned.x, Is.EqualTo(before.x / 100).Within(1e-4));
        }

        // A twentieth of a second of 5 m/s and of 40 degrees a second about a tilted axis; then a pose that stays.
        [Test]
        public void RadarMotion_FromTwoPoses_HasTheirVelocities()
        {
            var ship = _scene.Empty("Ship");
            var motion = ship.gameObject.AddComponent<RadarMotion>();
            Vector3 axis = new Vector3(2, -6, 3) / 7, before = new Vector3(100, 2, -50);
            var rotation = Quaternion.Euler(10, 250, -5);
            ship.localPosition = before + new Vector3(0.15f, 0, -0.2f);
            ship.localRotation = Quaternion.AngleAxis(2, axis) * rotation;
            motion.SetFromPose(before, rotation, 0.05);
            Assert.That(math.distance(motion.Velocity, new float3(3, 0, -4)), Is.LessThan(1e-3));
            Assert.That(math.distance(motion.TurnRates, 40 * (float3)axis), Is.LessThan(1e-3));
            motion.SetFromPose(ship.localPosition, ship.localRotation, 0.05);
            Assert.That(math.length(motion.TurnRates) + math.length(motion.Velocity), Is.LessThan(1e-3));
            Assert.That(() => motion.SetFromPose(before, rotation, 0), Throws.InstanceOf<GlintException>()
                .With.Message.EqualTo("RadarMotion of 'Ship': poses 0 s apart have no velocity: give a time above 0"));
        }
    }
}
