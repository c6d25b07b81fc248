using System;
using System.Diagnostics;
using System.IO;
using System.Threading.Tasks;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>What has a name among files and is none must not be waited for.</summary>
[Platform("Linux")]
public sealed class PipeTests
{
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

    [Test]
    public void Scene_ThatIsAPipe_IsRefusedAtOnce()
    {
        using TemporaryProject project = new();
        using (var maker = Process.Start("mkfifo", [Path.Combine(project.Root, "Assets/Scene.unity")]))
            maker.WaitForExit();
        var load = Task.Run(() => Assert.Throws<GlintException>(() => project.Load()));
        Assert.That(load.Wait(TimeSpan.FromSeconds(10)));
        Assert.That(load.Result.Message, Is.EqualTo("Assets/Scene.unity: is empty: restore the file"));
    }

    static void AssertRefused(string path)
    {
        var read = Task.Run(() => Assert.Throws<GlintException>(() => MeshFileReader.Read(path, LengthUnit.Parse("m"), UpAxis.Y)));
        Assert.That(read.Wait(TimeSpan.FromSeconds(10)), path);
        Assert.That(read.Result.Message, Does.StartWith(path + ": ").And.Contain("pipe"));
    }
}
