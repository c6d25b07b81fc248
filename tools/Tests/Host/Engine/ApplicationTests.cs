using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class ApplicationTests : EngineFixture
{
    static readonly List<string> _calls = new();

    [Test]
    public void Application_NamesAndVersions_AreThoseOfTheProjectSettings()
    {
        DirectoryInfo root = Directory.CreateTempSubdirectory();
        try
        {
            string settings = root.CreateSubdirectory("ProjectSettings").FullName;
            File.WriteAllText(Path.Combine(settings, "ProjectVersion.txt"),
                "m_EditorVersion: 6000.0.99f9\nm_EditorVersionWithRevision: 6000.0.99f9 (0)\n");
            File.WriteAllText(Path.Combine(settings, "ProjectSettings.asset"),
                "PlayerSettings:\n  companyName: Waves\n  productName: Sea\n");
            Engine.Assets = new FakeProject { ProjectRoot = root.FullName };
            Assert.That(Application.unityVersion, Is.EqualTo("6000.0.99f9"));
            Assert.That(Application.dataPath, Is.EqualTo(Path.Combine(root.FullName, "Assets")));
            Assert.That(Application.persistentDataPath, Does.EndWith(Path.Combine("Waves", "Sea")));
        }
        finally
        {
            root.Delete(true);
        }
    }

    [Test]
    public void RuntimeInitializeOnLoad_Methods_RunInTheOrderOfTheirTypes()
    {
        _calls.Clear();
        new GameObject("a").AddComponent<AwakeNoter>();
        Play();
        Assert.That(string.Join(" ", _calls), Is.EqualTo("subsystems before Awake after"));
    }

    [Test]
    public void TagManager_Set_AddsTagsAndNamesLayers()
    {
        string[] tags = TagManager.Tags.ToArray();
        string[] layers = Enumerable.Range(0, 32).Select(LayerMask.LayerToName).ToArray();
        try
        {
            TagManager.Set(new[] { "Radar" }, new[] { "Default", "", "", "Sea", "Water" });
            Assert.That(LayerMask.NameToLayer("Sea"), Is.EqualTo(3));
            Assert.That(LayerMask.LayerToName(4), Is.EqualTo("Water"));
            Assert.That(LayerMask.LayerToName(1), Is.EqualTo("TransparentFX"), "built in");
            Assert.That(LayerMask.NameToLayer("None"), Is.EqualTo(-1));
            Assert.That(LayerMask.GetMask("Default", "Sea", "None"), Is.EqualTo(9));
            Assert.DoesNotThrow(() => new GameObject("a").tag = "Radar");
        }
        finally
        {
            TagManager.Set(tags, layers);
        }
    }

    [Test]
    public void TextAsset_GivesItsTextWithoutByteOrderMark()
    {
        var asset = new TextAsset(new byte[] { 0xEF, 0xBB, 0xBF, (byte)'a', 0xC3, 0xA4 });
        Assert.That(asset.text, Is.EqualTo("a\u00e4"));
        Assert.That(asset.bytes.Length, Is.EqualTo(6));
        Assert.That(new TextAsset("b").text, Is.EqualTo("b"));
    }

    [RuntimeInitializeOnLoadMethod]
    static void After() => _calls.Add("after");

    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
    static void Before() => _calls.Add("before");

    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
    static void Subsystems() => _calls.Add("subsystems");

    sealed class AwakeNoter : MonoBehaviour
    {
        void Awake() => _calls.Add("Awake");
    }
}
