using System.IO;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ProjectPathsTests
    {
        string _root;

        [SetUp]
        public void MakeProject()
        {
            _root = Path.Combine(Path.GetTempPath(), "glint-paths-" + System.Guid.NewGuid().ToString("N"))
                .Replace('\\', '/');
            Write("project/Packages/manifest.json",
                "{ \"dependencies\": { \"com.a.scenes\": \"file:../Scenes\", \"com.a.shared\": \"file:../../shared\", "
                    + "\"com.unity.mathematics\": \"1.3.2\", \"com.a.packed\": \"file:../x.tgz\" } }");
            Write("project/Packages/Inner/package.json", "{ \"name\": \"com.a.embedded\" }");
            Write("project/Packages/Inner/Runtime/Thing.cs", "");
            Write("project/Scenes/package.json", "{ \"name\": \"com.a.scenes\" }");
            Write("project/Scenes/Corner.unity", "");
            Write("project/Assets/Sub/Home.unity", "");
            Write("project/ProjectSettings/TagManager.asset", "");
            Write("shared/package.json", "{ \"name\": \"com.a.shared\" }");
            Write("shared/Sea.unity", "");
            Write("elsewhere/Lost.unity", "");
        }

        [TearDown]
        public void RemoveProject() => Directory.Delete(_root, true);

        [TestCase("Packages/com.a.scenes/Corner.unity", "Scenes/Corner.unity")]
        [TestCase("Packages/com.a.embedded/Runtime/Thing.cs", "Packages/Inner/Runtime/Thing.cs")]
        [TestCase("Assets/Sub/Home.unity", "Assets/Sub/Home.unity")]
        [TestCase("Packages/com.a.shared/Sea.unity", "../shared/Sea.unity")]
        [TestCase("Packages/com.a.scenes/New.unity", "Scenes/New.unity")]
        public void Paths_OfAssets_MapBothWays(string asset, string disk)
        {
            var paths = Open();
            string physical = Path.GetFullPath(Project + "/" + disk).Replace('\\', '/');

            Assert.That(paths.ToPhysicalPath(asset), Is.EqualTo(physical));
            Assert.That(paths.ToAssetPath(physical, _root), Is.EqualTo(asset), "absolute");
            Assert.That(paths.ToAssetPath(asset, _root), Is.EqualTo(asset), "asset path");
            Assert.That(paths.ToAssetPath(disk, Project), Is.EqualTo(asset), "relative to the current directory");
            Assert.That(paths.ToAssetPath(disk, _root + "/elsewhere"), Is.EqualTo(asset), "relative to the project");
        }

        [TestCase("Corner.unity")]
        [TestCase("./Corner.unity")]
        [TestCase("../Scenes/Corner.unity")]
        public void Path_FromASubfolder_IsRelativeToIt(string path) => Assert.That(
            Open().ToAssetPath(path, Project + "/Scenes"), Is.EqualTo("Packages/com.a.scenes/Corner.unity"));

        [Test]
        public void Path_OfSettings_IsInTheProject() =>
            Assert.That(Open().ToPhysicalPath("ProjectSettings/TagManager.asset"),
                Is.EqualTo(Project + "/ProjectSettings/TagManager.asset"));

        [TestCase("../elsewhere/Lost.unity")]
        [TestCase("Assets/../../elsewhere/Lost.unity")]
        [TestCase("ProjectSettings/TagManager.asset")]
        [TestCase("ScenesToo/X.unity")]
        public void Path_OutsideOfTheProject_IsRefused(string path) =>
            Assert.That(Assert.Throws<GlintException>(() => Open().ToAssetPath(path, Project)).Message,
                Does.StartWith(path + ": outside of the Unity project " + Project));

        [TestCase("Scenes/Corner.unity", "elsewhere/Scenes/Corner.unity", "project/Scenes/Corner.unity")]
        [TestCase("Packages/com.a.scenes/X.unity", "project/Scenes/X.unity", "elsewhere/Packages/com.a.scenes/X.unity",
            "project/Packages/com.a.scenes/X.unity")]
        [TestCase("../project/X.unity", "project/X.unity")]
        public void Readings_OfAPath_AreWhereItIsLookedFor(string path, params string[] positions)
        {
            Assert.That(Open().Readings(path, _root + "/elsewhere"), Is.EqualTo(
                System.Array.ConvertAll(positions,
                    location => Path.GetFullPath(_root + "/" + location).Replace('\\', '/'))));
        }

        [TestCase("")]
        [TestCase(null)]
        public void Path_Empty_IsRefused(string path) =>
            Assert.Throws<GlintException>(() => Open().ToAssetPath(path, Project));

        [Test]
        public void Root_FromAFolderInside_IsFound()
        {
            Assert.That(ProjectPaths.FindRoot(Project + "/Assets/Sub"), Is.EqualTo(Project));
            Assert.That(ProjectPaths.FindRoot(_root + "/elsewhere"), Is.Null);
        }

        [TestCase("{\n nonsense", "malformed JSON in line 2: correct the line")]
        [TestCase("[]", "malformed JSON in line 1: correct the line")]
        [TestCase("", "is empty")]
        [TestCase("{ \"dependencies\": [] }", "\"dependencies\" must be an object")]
        [TestCase("{ \"dependencies\": { \"com.a.x\": 1 } }", "the version of com.a.x must be a string")]
        [TestCase("{ \"dependencies\": { \"com.a.x\": \"file:../None\" } }",
            "com.a.x is at file:../None, but there is no ")]
        [TestCase("{ \"dependencies\": { \"com.a.x\": \"file:../Scenes\" } }", "is of com.a.scenes")]
        public void Manifest_Malformed_IsRefusedByName(string text, string reason)
        {
            Write("project/Packages/manifest.json", text);

            var message = Assert.Throws<GlintException>(() => Open()).Message;
            Assert.That(message, Does.StartWith(Project + "/Packages/manifest.json: "));
            Assert.That(message, Does.Contain(reason));
        }

        [Test]
        public void Manifest_WithoutDependencies_IsTaken()
        {
            Write("project/Packages/manifest.json", "{}");

            Assert.That(Open().Packages.Keys, Is.EqualTo(new[] { "com.a.embedded" }));
        }

        [Test]
        public void Folder_WithoutAManifest_IsNoProject() =>
            Assert.That(Assert.Throws<GlintException>(() => new ProjectPaths(_root + "/elsewhere")).Message,
                Does.Contain("not a Unity project"));

        string Project => _root + "/project";

        ProjectPaths Open() => new ProjectPaths(Project);

        void Write(string path, string text)
        {
            string file = _root + "/" + path;
            Directory.CreateDirectory(Path.GetDirectoryName(file));
            File.WriteAllText(file, text);
        }
    }
}
