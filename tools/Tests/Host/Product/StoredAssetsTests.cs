using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Serialization;

namespace Glint.Host.Tests;

/// <summary>
/// Scenes and prefabs saved before the classes were renamed and moved (Version0/Saved) still load: their scripts by
/// guid, their fields by name.
/// </summary>
public sealed partial class StoredAssetsTests
{
    const BindingFlags Fields = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    TemporaryProject _project;

    static string Stored => StoredResultsTests.Version0("Saved");

    static string Repository => Project.FindRoot(Stored);

    static IEnumerable<string> Files => Directory.GetFiles(Stored).Where(file => !file.EndsWith(".meta"))
        .Select(Path.GetFileName).Order();

    [SetUp]
    public void MakeProject() => _project = new TemporaryProject();

    [TearDown]
    public void Remove() => _project.Dispose();

    [Test]
    public void CornerReflector_OfVersion0_HasItsValues()
    {
        GameObject[] roots = Load("CornerReflector.unity", withMeshes: false);
        RadarController radar = roots[0].GetComponentInChildren<RadarController>();
        CheckRadar(radar);
        Assert.That((radar.ReceiverSize.x, radar.ReceiverSize.y), Is.EqualTo((3f, 3f)));
        Assert.That((radar.FitAperture, radar.RaySpacing), Is.EqualTo((false, 0.01)));
        Assert.That(radar.Gather().Scene.TriangleCount, Is.EqualTo(36));
        Sweep sweep = Find<Sweep>(roots);
        Assert.That((sweep.Radar, sweep.Target.name, sweep.Angles),
            Is.EqualTo((radar, "Corner Reflector", "0:45:1")));
    }

    [Test]
    public void ShipSeaState6_OfVersion0_HasItsValues()
    {
        GameObject[] roots = Load("ShipSeaState6.unity", withMeshes: true);
        RadarController radar = Find<RadarController>(roots);
        CheckRadar(radar);
        RayPaths paths = Find<RayPaths>(roots);
        Assert.That((paths.ReceivedOnly, paths.Every, paths.MinBounces, paths.MaxBounces),
            Is.EqualTo((true, 1, 1, 16)));
        Sweep sweep = Find<Sweep>(roots);
        Assert.That((sweep.Radar, sweep.Target.name, sweep.Angles), Is.EqualTo((radar, "Ship", "0:360:15")));
        Assert.That(Find<Ship>(roots).Settings.Length, Is.EqualTo(62));
    }

    /// <summary>Unity drops the value of a name that no field has: it would be silently lost.</summary>
    [TestCaseSource(nameof(Files))]
    public void Names_OfVersion0_AreFieldsOfTheirScripts(string file)
    {
        int found = 0;
        foreach (string document in File.ReadAllText(Path.Combine(Stored, file)).Split("--- !u!"))
            if (Script().Match(document) is { Success: true } script)
            {
                found++;
                Type type = TypeOf(script.Groups[1].Value);
                foreach (Match name in FieldName().Matches(document[script.Index..]))
                    Assert.That(Names(type), Does.Contain(name.Groups[1].Value), $"{file}: {type.Name}");
            }
        Assert.That(found, file == "Corner Reflector.prefab" ? Is.Zero : Is.GreaterThan(0));
    }

    static void CheckRadar(RadarController radar)
    {
        Assert.That((radar.Settings.FrequencyHz, radar.Settings.RaysAcross, radar.Settings.RaysDown,
            radar.Settings.MaxBounces, radar.Layers.value), Is.EqualTo((10e9, 1920, 1080, 4, -1)));
        Assert.That(radar.Receiver.name, Is.EqualTo("Receiver"));
        Assert.That(radar.Kernel.name, Is.EqualTo("Trace"));
    }

    // The copies bring their prefabs; those of the seas and the ship are the project's.
    GameObject[] Load(string scene, bool withMeshes)
    {
        Directory.CreateSymbolicLink(Path.Combine(_project.Root, "Packages/com.glint.radar"),
            Path.Combine(Repository, "Packages/com.glint.radar"));
        if (withMeshes)
            _project.Write("Packages/manifest.json",
                $$"""{ "dependencies": { "com.glint.meshes": "file:{{Repository}}/Meshes" } }""");
        foreach (string file in Files.Where(file => file == scene || !withMeshes && file.StartsWith("Corner")))
            foreach (string name in new[] { file, file + ".meta" })
                _project.Write($"Assets/{name}", File.ReadAllText(Path.Combine(Stored, name)));
        GameObject[] roots = _project.Load($"Assets/{scene}");
        Assert.That(_project.Warnings, Is.Empty);
        return roots;
    }

    static T Find<T>(GameObject[] roots) where T : Component =>
        roots.Select(root => root.GetComponentInChildren<T>()).Single(component => component != null);

    static Type TypeOf(string guid)
    {
        string meta = Directory.GetFiles($"{Repository}/Packages/com.glint.radar/Runtime", "*.cs.meta",
            SearchOption.AllDirectories).Single(path => File.ReadAllText(path).Contains(guid));
        return typeof(RadarController).Assembly
            .GetType("Glint." + Path.GetFileName(meta)[..^".cs.meta".Length], throwOnError: true);
    }

    static IEnumerable<string> Names(Type type) => type.GetFields(Fields).SelectMany(field =>
        field.GetCustomAttributes<FormerlySerializedAsAttribute>().Select(former => former.oldName)
            .Append(field.Name));

    [GeneratedRegex("m_Script: .*guid: ([0-9a-f]{32})")]
    private static partial Regex Script();

    [GeneratedRegex("(?m)^  (_[A-Za-z]+):")]
    private static partial Regex FieldName();
}
