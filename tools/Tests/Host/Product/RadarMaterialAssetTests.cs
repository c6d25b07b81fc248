using Glint.Core;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

/// <summary>Radar Materials in asset files.</summary>
public sealed class RadarMaterialAssetTests : WritingFixture
{
    const int Script = 3;

    [SetUp]
    public void AddScript() => Project.WriteScript(typeof(RadarMaterial), Script);

    // Files of versions before materials had values.
    [Test]
    public void Asset_WithANameOnly_IsAConductor()
    {
        Project.Write("Assets/Steel.asset", Header + "--- !u!114 &11400000\nMonoBehaviour:\n  m_ObjectHideFlags: 0\n"
            + $"  m_Enabled: 1\n  m_Script: {Asset(11500000, Script)}\n  m_Name: Steel\n", 4);
        var read = Reopened<RadarMaterial>("Assets/Steel.asset");
        Assert.That(read.ToSurface(), Is.EqualTo(new SurfaceMaterial("Steel")));
        Assert.That((read.Layers.Count, read.HalfSpace.Values.Count), Is.EqualTo((0, 1)));
    }

    [Test]
    public void Asset_WithLayers_IsReadBack()
    {
        var material = ScriptableObject.CreateInstance<RadarMaterial>();
        material.Kind = RadarMaterialKind.HalfSpace;
        material.Layers.Add(new RadarLayer { Medium = new RadarMedium { Published = "ptfe" }, Thickness = 0.0015 });
        material.HalfSpace.Values = new()
        {
            new MediumSample(8e9, 4, 0.4, 1.5, 1.8), new MediumSample(12e9, 4.1, 0.3, 1.4, 1.7)
        };
        AssetDatabase.CreateAsset(material, "Assets/Paint.asset");
        SurfaceMaterial before = material.ToSurface();
        Assert.That(before.Name, Is.EqualTo("Paint"), "an asset is called as its file");
        Assert.That(Reopened<RadarMaterial>("Assets/Paint.asset").ToSurface(), Is.EqualTo(before));
    }
}
