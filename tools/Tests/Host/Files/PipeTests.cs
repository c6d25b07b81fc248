using System;
using System.Diagnostics;
using System.IO;
using System.Threading.Tasks;
using Glint.Core;
using NUnit.Framework;
using UnityEditor;

namespace Glint.Host.Tests;

/// <summary>Named pipes and devices are refused without blocking.</summary>
[Platform("Linux")]
public sealed class PipeTests
{
    static readonly TimeSpan s_longEnough = TimeSpan.FromSeconds(10);

    [TestCase(".obj")]
    [TestCase(".stl")]
    public void Read_OfAPipe_IsRefusedAtOnce(string extension)
    {
        string folder = Directory.CreateTempSubdirectory("glint-tests-").FullName;
        try
        {
            string pipe = Path.Combine(folder, "mesh" + extension);
            using (var maker = Process.Start("mkfifo", [pipe]))
                maker.WaitForExit();
            AssertRefused(pipe);
            File.CreateSymbolicLink(Path.Combine(folder, "zero" + extension), "/dev/zero");
            AssertRefused(Path.Combine(folder, "zero" + extension));
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    [TestCase("Scene.unity")]
    [TestCase("Ship.prefab")]
    [TestCase("Hull.asset")]
    public void Asset_ThatIsAPipe_IsRefusedAtOnce(string name)
    {
        using TemporaryProject project = new();
        MakePipe(project, "Assets/" + name);
        AssertRefused(project, name.EndsWith(".unity") ? () => project.Load() : () =>
            AssetDatabase.LoadMainAssetAtPath("Assets/" + name),
            $"Assets/{name}: is empty, or a pipe or device instead of a file: restore the file");
    }

    [Test]
    public void PrefabOfAScene_ThatIsAPipe_IsRefusedAtOnce()
    {
        using TemporaryProject project = new();
        project.Write("Assets/Ship.prefab", "", 7);
        File.Delete(Path.Combine(project.Root, "Assets/Ship.prefab"));
        MakePipe(project, "Assets/Ship.prefab");
        project.Write("Assets/Scene.unity", UnityText.Scene(UnityText.Instance(50, 7), 50));
        AssertRefused(project, () => project.Load(),
            "Assets/Ship.prefab: is empty, or a pipe or device instead of a file: restore the file");
    }

    [Test]
    public void Meta_ThatIsAPipe_IsAsNone()
    {
        using TemporaryProject project = new();
        project.Write("Assets/Hull.asset", MeshText.Of([0, 0, 0, 0, 1, 0, 1, 0, 0], 0, 1, 2).ToString());
        MakePipe(project, "Assets/Hull.asset.meta");
        _ = project.Project;
        var load = Task.Run(() => (AssetDatabase.AssetPathToGUID("Assets/Hull.asset"),
            AssetDatabase.GUIDToAssetPath(TemporaryProject.Guid(1))));
        Assert.That(load.Wait(s_longEnough));
        Assert.That(load.Result, Is.EqualTo(("", "")));
    }

    [Test]
    public void Manifest_ThatIsAPipe_IsRefusedAtOnce()
    {
        using TemporaryProject project = new();
        File.Delete(Path.Combine(project.Root, "Packages/manifest.json"));
        MakePipe(project, "Packages/manifest.json");
        var open = Task.Run(() => Assert.Throws<GlintException>(() => Project.Open(project.Root)));
        Assert.That(open.Wait(s_longEnough));
        Assert.That(open.Result.Message, Is.EqualTo($"{project.Root}/Packages/manifest.json: is empty, or a pipe or "
            + "device instead of a file: restore the file"));
    }

    static void MakePipe(TemporaryProject project, string path)
    {
        using var maker = Process.Start("mkfifo", [Path.Combine(project.Root, path)]);
        maker.WaitForExit();
    }

    static void AssertRefused(TemporaryProject project, Action work, string message)
    {
        _ = project.Project;
        var load = Task.Run(() => Assert.Throws<GlintException>(() => work()));
        Assert.That(load.Wait(s_longEnough));
        Assert.That(load.Result.Message, Is.EqualTo(message));
    }

    static void AssertRefused(string path)
    {
        var read = Task.Run(
            () => Assert.Throws<GlintException>(() => MeshFileReader.Read(path, LengthUnit.Parse("m"), UpAxis.Y)));
        Assert.That(read.Wait(s_longEnough), path);
        Assert.That(read.Result.Message, Does.StartWith(path + ": ").And.Contain("pipe"));
    }
}
