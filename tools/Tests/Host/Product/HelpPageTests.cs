using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>The question mark in the inspector of each component and asset of the package.</summary>
public sealed class HelpPageTests
{
    static IEnumerable<Type> Scripts => typeof(RadarController).Assembly.GetTypes().Where(type => !type.IsAbstract
        && (type.IsSubclassOf(typeof(MonoBehaviour)) || type.IsSubclassOf(typeof(ScriptableObject))));

    [Test]
    public void Scripts_OfThePackage_AreTheseAtLeast() => Assert.That(Scripts, Is.SupersetOf(new[]
    {
        typeof(RadarController), typeof(RadarCrossSection), typeof(RadarMaterial), typeof(RadarSurface),
        typeof(RayPaths), typeof(Sea), typeof(SeaSnapshot), typeof(Ship), typeof(Sweep)
    }));

    // Unity opens what begins with file:// as it stands, and takes other text for a page of its own manual.
    [TestCaseSource(nameof(Scripts))]
    public void Help_OfAScript_IsAPageOfThePackageThatNamesIt(Type script)
    {
        string url = script.GetCustomAttribute<HelpURLAttribute>()?.URL;

        Assert.That(url, Does.StartWith("file:///").And.Contain("/Packages/com.glint.radar/Documentation~/"));
        Assert.That(Uri.IsWellFormedUriString(url, UriKind.Absolute), url);
        string page = Path.Combine(Project.FindRoot(AppContext.BaseDirectory), "Packages/com.glint.radar/Documentation~",
            Path.GetFileName(new Uri(url).LocalPath));
        Assert.That(File.ReadAllText(page), Does.Match($@"\b({script.Name}|{Heading(script.Name)})\b"));
    }

    // As the inspector's heading has it: RayPaths is Ray Paths.
    static string Heading(string name) => string.Concat(name.Select((letter, index) =>
        index > 0 && char.IsUpper(letter) ? " " + letter : letter.ToString()));
}
