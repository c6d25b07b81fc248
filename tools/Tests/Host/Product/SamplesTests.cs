using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Glint.Samples;
using Newtonsoft.Json.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>
/// The package's samples, copied as by the Package Manager into a project without another package of Glint.
/// </summary>
public sealed class SamplesTests
{
    static readonly string s_package =
        Path.Combine(Project.FindRoot(AppContext.BaseDirectory), "Packages/com.glint.radar");

    static JObject Manifest => JObject.Parse(File.ReadAllText(Path.Combine(s_package, "package.json")));

    [Test]
    public void Manifest_NamesEverySampleAndNoOther()
    {
        var folders = Manifest["samples"].Select(sample => (string)sample["path"]).ToArray();
        Assert.That(folders, Is.EquivalentTo(Directory.GetDirectories(Path.Combine(s_package, "Samples~"))
            .Select(folder => "Samples~/" + Path.GetFileName(folder))));
        foreach (var sample in Manifest["samples"])
        {
            Assert.That((string)sample["displayName"], Is.Not.Empty);
            Assert.That((string)sample["description"], Is.Not.Empty);
            Assert.That(Path.Combine(s_package, (string)sample["path"], "README.md"), Does.Exist);
        }
    }

    // Unity makes a new .meta for a file without one, and a new guid breaks references to the file.
    [Test]
    public void Files_EachHaveAMetaWithAGuidOfTheirOwn()
    {
        string samples = Path.Combine(s_package, "Samples~"),
            root = Path.GetDirectoryName(Path.GetDirectoryName(s_package));
        var files = Directory.GetFileSystemEntries(samples, "*", SearchOption.AllDirectories)
            .Where(path => !path.EndsWith(".meta")).ToArray();
        Assert.That(files.Where(path => !File.Exists(path + ".meta")), Is.Empty);
        Assert.That(Directory.GetFiles(samples, "*.meta", SearchOption.AllDirectories).Length, Is.EqualTo(files.Length),
            "no .meta of a file that is gone");
        var guids = new[] { "Packages", "Scenes", "Meshes", "Tests", "Assets" }
            .SelectMany(folder => Directory.GetFiles(Path.Combine(root, folder), "*.meta", SearchOption.AllDirectories))
            .Select(path => Regex.Match(File.ReadAllText(path), "guid: ([0-9a-f]{32})").Groups[1].Value).ToArray();
        Assert.That(guids, Is.Unique);
    }

    // An imported sample must be self-contained. Its prefabs are copies of the stored ones; its scene differs from the
    // stored one only in their guids.
    [Test]
    public void CornerReflector_IsTheStoredExperiment()
    {
        string sample = Path.Combine(s_package, "Samples~/CornerReflector"),
            root = Project.FindRoot(AppContext.BaseDirectory);
        string scene = File.ReadAllText(Path.Combine(root, "Scenes/CornerReflector.unity"));
        foreach (string name in new[] { "Corner Reflector.prefab", "Corner Reflector Radar.prefab" })
        {
            string stored = Path.Combine(root, "Meshes/CornerReflector", name);
            Assert.That(File.ReadAllText(Path.Combine(sample, name)), Is.EqualTo(File.ReadAllText(stored)),
                $"{name}: glint reflector made the stored one anew: copy it");
            scene = scene.Replace(Guid(stored), Guid(Path.Combine(sample, name)));
        }
        Assert.That(File.ReadAllText(Path.Combine(sample, "CornerReflector.unity")), Is.EqualTo(scene));

        static string Guid(string file) =>
            Regex.Match(File.ReadAllText(file + ".meta"), "guid: ([0-9a-f]{32})").Groups[1].Value;
    }

    // 26 x 26 rays at 0 degrees, all with three bounces.
    [Test]
    public void CornerReflector_Imported_ReturnsRaysThatMeetThreePlates()
    {
        using var project = new TemporaryProject();
        string scene = Import(project, "Corner Reflector") + "/CornerReflector.unity";
        var roots = project.Load(scene);
        Assert.That(project.Warnings, Is.Empty);
        var radar = roots.Select(root => root.GetComponentInChildren<RadarController>()).Single(found => found != null);
        var sweep = roots.Select(root => root.GetComponent<Sweep>()).Single(found => found != null);
        Assert.That(sweep.Target, Is.SameAs(roots.Single(root => root.name == "Corner Reflector").transform));
        Assert.That(sweep.Radar, Is.SameAs(radar));

        var result = radar.Trace();
        Assert.That(result.RaysReceived, Is.EqualTo(676));
        Assert.That(result.Rays.Select(ray => ray.Bounces), Is.All.EqualTo(3));
        radar.Release();
    }

    [Test]
    public void ScriptApi_InAnEmptyScene_TracesReadsRaysAndSweeps()
    {
        string folder = Directory.CreateTempSubdirectory("glint-sample-").FullName;
        var holder = new GameObject("From code");
        holder.SetActive(false);
        var sample = holder.AddComponent<RadarFromCode>();
        sample.Kernel =
            UnityEditor.AssetDatabase.LoadAssetAtPath<ComputeShader>("Packages/com.glint.radar/Shaders/Trace.compute");
        holder.transform.position = new Vector3(0, 1000, 0);
        var plate = sample.MakePlate(1, 10);
        var radar = sample.MakeRadar();
        try
        {
            radar.Roots.Add(plate);
            var result = radar.Trace();
            // Head-on, a plate of 1 m returns every ray, at most 1 m from the axis at the receiver. 180 rays are 2 x
            // 10 m x tan 5 deg.
            Assert.That(result.RaysHit,
                Is.EqualTo(Math.Pow(180 / (20 * Math.Tan(5 * Math.PI / 180)), 2)).Within(3).Percent);
            Assert.That(result.RaysReceived, Is.EqualTo(result.RaysHit).And.EqualTo(result.Rays.Length));

            RadarFromCode.Sweep(radar, plate, folder);
            var rows = File.ReadAllLines(Path.Combine(folder, "results.csv")).Skip(1)
                .Select(line => line.Split(',')).ToArray();
            Assert.That(rows.Select(row => row[0]),
                Is.EqualTo(new[] { "-2", "-1.5", "-1", "-0.5", "0", "0.5", "1", "1.5", "2" }));
            Assert.That(double.Parse(rows[4][1]), Is.EqualTo(result.Amplitude).Within(1e-6),
                "at 0 degrees the pose traced before");
            Assert.That(double.Parse(rows[8][1]), Is.LessThan(result.Amplitude / 2), "turned by 2 degrees");
            Assert.That(plate.rotation, Is.EqualTo(Quaternion.identity));
        }
        finally
        {
            radar.Release();
            foreach (var made in new[] { holder, plate.gameObject, radar.gameObject })
                UnityEngine.Object.DestroyImmediate(made);
            Directory.Delete(folder, true);
        }
    }

    // Assets/Samples/<package>/<version>/<sample>, the Package Manager's destination.
    static string Import(TemporaryProject project, string name)
    {
        foreach (string folder in new[] { "Core", "Runtime", "Editor", "Shaders" })
            Copy(project, Path.Combine(s_package, folder), "Packages/com.glint.radar/" + folder);
        project.Write("Packages/com.glint.radar/package.json",
            File.ReadAllText(Path.Combine(s_package, "package.json")));
        var sample = Manifest["samples"].Single(known => (string)known["displayName"] == name);
        string from = Path.Combine(s_package, (string)sample["path"]),
            to = $"Assets/Samples/{Manifest["displayName"]}/{Manifest["version"]}/{name}";
        Copy(project, from, to);
        return to;
    }

    static void Copy(TemporaryProject project, string from, string to)
    {
        foreach (string file in Directory.GetFiles(from, "*", SearchOption.AllDirectories))
            project.Write(Path.Combine(to, Path.GetRelativePath(from, file)), File.ReadAllText(file));
    }
}
