using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Poses of radar and receiver before a mesh file, at any distance.</summary>
    public sealed class MeshFileSceneTests
    {
        SweepSetup _made;

        [TearDown]
        public void RemoveScene()
        {
            Object.DestroyImmediate(_made.Radar.transform.parent.gameObject);
            Object.DestroyImmediate(_made.Target.gameObject);
        }

        [TestCase(50, 10, 0)]
        [TestCase(100000, 10, 0)]
        [TestCase(100000, 33.3, 71.7)]
        [TestCase(1000000, -90, 200)]
        public void Create_Radar_LooksAtTheAimFromItsDistance(double range, double grazing, double azimuth)
        {
            var placement = Placement(range, grazing, azimuth);
            var view = Make(placement).View;
            double3 toAim = placement.Aim - view.Position;
            Assert.That(length(toAim), Is.EqualTo(range).Within(2e-15 * range + 1e-12));
            Assert.That(length(cross(toAim, view.Forward)), Is.LessThan(1e-9), "the aim is on the axis to a nanometre");
            // The rotation is made of single-precision angles.
            double3 forward = new double3(sin(radians(azimuth)) * cos(radians(grazing)), -sin(radians(grazing)),
                cos(radians(azimuth)) * cos(radians(grazing)));
            Assert.That(distance(view.Forward, forward), Is.LessThan(5e-7));
            Assert.That(abs(view.Right.y), Is.LessThan(5e-7), "level");
            Assert.That(view.VerticalFovDegrees, Is.EqualTo(0.5));
            Assert.That(view.IsParallel, Is.False);

            double3 behind = view.ReceiverCentre - view.Position;
            Assert.That(distance(behind, -0.2f * view.Forward), Is.LessThan(1e-9));
            Assert.That(view.ReceiverSize, Is.EqualTo(new double2(4, 2)));
        }

        [Test]
        public void Create_ParallelRaysOverAnAperture_StartAtTheDistanceAndReturnToIt()
        {
            var placement = Placement(100000, 0, 0);
            (placement.RaySpacing, placement.ApertureSize, placement.ReceiverSize) = (0.25, new double2(4, 2.1), 0);
            var pose = Make(placement);
            Assert.That((pose.Settings.RaysAcross, pose.Settings.RaysDown), Is.EqualTo((16, 9)));
            Assert.That(pose.View.ApertureHeight, Is.EqualTo(2.25));
            Assert.That(distance(pose.View.Position, placement.Aim - new double3(0, 0, 100000)), Is.LessThan(1e-9));
            Assert.That(distance(pose.View.ReceiverCentre, pose.View.Position), Is.LessThan(1e-9),
                "on the axis, at the same distance");
            Assert.That(pose.View.ReceiverSize, Is.EqualTo(new double2(4, 2.25)));
        }

        [Test]
        public void Create_ParallelRaysWithoutAnAperture_AreFittedToTheMesh()
        {
            var placement = Placement(100, 0, 0);
            (placement.RaySpacing, placement.ReceiverSize) = (0.25, 0);
            var pose = Make(placement);
            // A plate 2 m wide and 1 m high; the radar aims beside its centre.
            Assert.That((pose.Settings.RaysAcross, pose.Settings.RaysDown), Is.EqualTo((8, 4)));
            Assert.That(distance(pose.View.Position, new double3(0, 0, placement.Aim.z - 100)), Is.LessThan(1e-9));
            Assert.That(distance(pose.View.ReceiverCentre, pose.View.Position), Is.LessThan(1e-9));
            Assert.That(pose.View.ReceiverSize, Is.EqualTo(new double2(2, 1)));

            _made.Radar.ReceiverSize = new Vector2(3, 4);
            pose = _made.Radar.Gather();
            Assert.That(distance(pose.View.ReceiverCentre, placement.Aim - new double3(0, 0, 100)), Is.LessThan(1e-9),
                "where it stands, when it has a size");
            Assert.That(pose.View.ReceiverSize, Is.EqualTo(new double2(3, 4)));
        }

        [Test]
        public void Create_MaterialsOfTheFile_AreSurfacesOfTheScene()
        {
            var file = new MeshFile("Two", new[]
            {
                new float3(-1, 0, 0), new float3(-1, 1, 0), new float3(1, 1, 0), new float3(1, 0, 0)
            }, new[] { 0, 1, 2, 0, 2, 3 }, new[] { new MeshFileSurface(0, null), new MeshFileSurface(1, "steel") });
            _made = MeshFileScene.Create(file, Placement(100, 0, 0), RadarSettings.Default, null);
            _made.Radar.Roots.Add(_made.Target);
            var scene = _made.Radar.Gather().Scene;
            Assert.That(scene.Surfaces.Select(surface => surface.Name),
                Is.EqualTo(new[] { SurfaceMaterial.PerfectConductor.Name, "steel" }));
            Assert.That(scene.Instances.Single().Ranges,
                Is.EqualTo(new[] { new MeshRange(0, 0, 0), new MeshRange(1, 0, 1) }));
        }

        static RadarPlacement Placement(double range, double grazing, double azimuth) => new RadarPlacement
        {
            Aim = new double3(0.5, -0.25, 3), Distance = range, GrazingDegrees = grazing, AzimuthDegrees = azimuth,
            VerticalFovDegrees = 0.5, ReceiverSize = new double2(4, 2),
        };

        RadarPose Make(in RadarPlacement placement)
        {
            var plate = new MeshFile("Plate", new[]
            {
                new float3(-1, -0.5f, 0), new float3(-1, 0.5f, 0), new float3(1, 0.5f, 0), new float3(1, -0.5f, 0)
            }, new[] { 0, 1, 2, 0, 2, 3 });
            _made = MeshFileScene.Create(plate, placement, RadarSettings.Default, null);
            _made.Radar.Roots.Add(_made.Target); // another scene may be left by an earlier test
            return _made.Radar.Gather();
        }
    }
}
