using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEditor;

namespace Glint.Host.Tests;

/// <summary>Each component's script names its icon. .ci/run checks the pictures with tools/icons/make.py.</summary>
public sealed class IconTests
{
    const string Package = "Packages/com.glint.radar";

    [TestCase("Runtime/Components/RadarController.cs")]
    [TestCase("Runtime/Components/RadarCrossSection.cs")]
    [TestCase("Runtime/Components/Sweep.cs")]
    [TestCase("Runtime/Components/Sea.cs")]
    [TestCase("Runtime/Components/Ship.cs")]
    [TestCase("Runtime/Components/RayPaths.cs")]
    public void Script_HasItsIcon(string script)
    {
        string meta = File.ReadAllText(Path.Combine(Engine.Assets.ProjectRoot, Package, script + ".meta"));
        string guid = Regex.Match(meta, @"icon: \{fileID: 2800000, guid: (\w+), type: 3\}").Groups[1].Value;
        string icon = $"{Package}/Editor/Icons/{Path.GetFileNameWithoutExtension(script)}.png";
        Assert.That(AssetDatabase.GUIDToAssetPath(guid), Is.EqualTo(icon));
        byte[] png = File.ReadAllBytes(Path.Combine(Engine.Assets.ProjectRoot, icon));
        // Width, height and colour type in its header: red, green, blue and opacity.
        Assert.That((png[19], png[23], png[25]), Is.EqualTo(((byte)128, (byte)128, (byte)6)));
    }
}
