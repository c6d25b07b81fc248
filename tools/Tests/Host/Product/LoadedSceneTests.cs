using System.IO;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Refusals of the commands. The message names the scene, the object and the way out.</summary>
public sealed class LoadedSceneTests
{
    [Test]
    public void Gather_StaticBatch_IsRefusedByNameWithTheRemedy()
    {
        var wall = GameObject.CreatePrimitive(PrimitiveType.Cube);
        wall.name = "Wall";
        wall.GetComponent<MeshRenderer>().StaticBatched = true;
        try
        {
            var problem =
                Assert.Throws<GlintException>(() => new SceneGatherer().Gather(~0, new[] { wall.transform }, null));
            Assert.That(problem.Message,
                Does.Contain("'Wall'").And.Contain("static batch").And.Contain("Batching Static"));
        }
        finally
        {
            Object.DestroyImmediate(wall);
        }
    }

    [TestCase("RadarController of 'Radar Camera' has no receiver", "_receiver: {fileID: 111}",
        "_receiver: {fileID: 0}")]
    [TestCase("RadarController of 'Radar Camera' is disabled or inactive; enable it", "m_IsActive: 1", "m_IsActive: 0")]
    [TestCase("field of view 0 deg", "field of view: 60", "field of view: 0")]
    [TestCase("field of view 180 deg", "field of view: 60", "field of view: 180")]
    [TestCase("Size is 0", "orthographic: 0", "orthographic: 1", "orthographic size: 5", "orthographic size: 0")]
    [TestCase("frequency 0 Hz", "_frequencyHz: 10000000000", "_frequencyHz: 0")]
    [TestCase("rays across -5", "_raysAcross: 1920", "_raysAcross: -5")]
    [TestCase("maximum bounces 17", "_maxBounces: 4", "_maxBounces: 17")]
    [TestCase("receiver size -3 x 3 m", "_receiverSize: {x: 3, y: 3}", "_receiverSize: {x: -3, y: 3}")]
    [TestCase("RadarController of 'Radar Camera': the radar has no valid position: the rotation of 'Radar Camera' is "
        + "not "
        + "finite: set it again", "m_LocalRotation: {x: 0.087155744", "m_LocalRotation: {x: .nan")]
    [TestCase("RadarController of 'Radar Camera': its receiver 'Receiver' has no valid position: "
        + "the position of 'Receiver' is not finite: set it again", "y: 0, z: -0.2}", "y: 0, z: -.inf}")]
    [TestCase("RadarController of 'Radar Camera' has no kernel", "_kernel: {fileID: 7200000",
        "_kernel: {fileID: 0} # {fileID: 7200000")]
    public void Run_OfASceneWithABadRadar_IsRefusedByName(string message, params string[] replacements)
    {
        string scene = File.ReadAllText(Path.Combine(Engine.Assets.ProjectRoot, "Scenes/ShipFreeSpace.unity"));
        for (int i = 0; i < replacements.Length; i += 2)
        {
            Assert.That(scene, Does.Contain(replacements[i]));
            scene = scene.Replace(replacements[i], replacements[i + 1]);
        }
        string root = Engine.Assets.ProjectRoot;
        using var project = new TemporaryProject();
        Directory.CreateSymbolicLink(Path.Combine(project.Root, "Packages/com.glint.radar"),
            Path.Combine(root, "Packages/com.glint.radar"));
        Directory.CreateSymbolicLink(Path.Combine(project.Root, "Assets/Meshes"), Path.Combine(root, "Meshes"));
        project.Write("Assets/Bad.unity", scene);
        _ = project.Project;

        var problem = Assert.Throws<GlintException>(() =>
            Batch.Execute(CommandLine.Parse(Commands.Run, new[] { Path.Combine(project.Root, "Assets/Bad.unity") }),
                new LogProgress()));
        Assert.That(problem.Message, Does.Contain(message));
    }

    [Test]
    public void Sweep_OfATargetBelowARotationThatIsNone_IsRefusedByBothNames()
    {
        Transform mast = new GameObject("Mast").transform, target = new GameObject("Antenna").transform;
        target.SetParent(mast, false);
        mast.Load(Vector3.zero, new Quaternion(0f, float.NaN, 0f, 1f), Vector3.one);
        var radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        try
        {
            Assert.That(Assert.Throws<GlintException>(() => new AxisDrivers(
                new SweepSetup(radar, new SweepPlan(new[] { 0.0, 1.0 })) { Target = target })).Message, Is.EqualTo(
                    "the target 'Antenna' of the sweep has no valid position: the rotation of 'Mast', above it, "
                    + "is not finite: set it again"));
        }
        finally
        {
            Object.DestroyImmediate(mast.gameObject);
            Object.DestroyImmediate(radar.gameObject);
        }
    }

    [Test]
    public void Gather_ReceiverBelowARotationThatIsNone_IsRefusedByBothNames()
    {
        Transform mast = new GameObject("Mast").transform, receiver = new GameObject("Antenna").transform;
        receiver.SetParent(mast, false);
        mast.Load(Vector3.zero, new Quaternion(0f, float.PositiveInfinity, 0f, 1f), Vector3.one);
        var radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        radar.Receiver = receiver;
        radar.Roots.Add(receiver);
        try
        {
            Assert.That(Assert.Throws<GlintException>(() => radar.Gather()).Message, Is.EqualTo(
                "RadarController of 'Radar': its receiver 'Antenna' has no valid position: the rotation of 'Mast', "
                    + "above it, "
                + "is not finite: set it again"));
        }
        finally
        {
            Object.DestroyImmediate(radar.gameObject);
            Object.DestroyImmediate(mast.gameObject);
        }
    }

    // An invalid rotation would otherwise count as no rotation, and the target would be traced in the wrong pose.
    [Test]
    public void Gather_ObjectWithARotationThatIsNone_IsRefusedByName()
    {
        var wall = GameObject.CreatePrimitive(PrimitiveType.Cube);
        wall.name = "Wall";
        wall.transform.Load(Vector3.zero, new Quaternion(float.NaN, 0f, 0f, 1f), Vector3.one);
        try
        {
            var problem =
                Assert.Throws<GlintException>(() => new SceneGatherer().Gather(~0, new[] { wall.transform }, null));
            Assert.That(problem.Message, Does.Contain("'Wall'")
                .And.Contain("correct the mesh, or the position, rotation or scale of the object or of one above it"));
        }
        finally
        {
            Object.DestroyImmediate(wall);
        }
    }

    [Test]
    public void Version_InResults_IsThatOfThePackage()
    {
        string package =
            File.ReadAllText(Path.Combine(Engine.Assets.ProjectRoot, "Packages/com.glint.radar/package.json"));
        Assert.That(package, Does.Contain($"\"version\": \"{GlintVersion.Text}\""));
    }
}
