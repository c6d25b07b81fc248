using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>
/// Prefabs saved from code: every kind of field and reference reads back, and objects keep their ids.
/// </summary>
public sealed class PrefabWritingTests : WritingFixture
{
    const string PrefabPath = "Assets/Ship.prefab";
    static readonly Vector3 _position = new(0.1f, -2.5f, 1e-7f), _scale = new(1f, 2f, -0.3f);

    [Test]
    public void Prefab_OfAMeshAsset_IsReadBackWithItsMeshAndMaterial()
    {
        Mesh mesh = Triangle("Hull");
        AssetDatabase.CreateAsset(mesh, "Assets/Hull.asset");
        GameObject root = Ship(mesh);
        GameObject prefab = PrefabUtility.SaveAsPrefabAsset(root, PrefabPath, out bool success);
        Assert.That(success, string.Join("\n", Errors));
        AssertIsShip(prefab, mesh);
        AssertIsShip(Reopened<GameObject>(PrefabPath), AssetDatabase.LoadAssetAtPath<Mesh>("Assets/Hull.asset"));
        Assert.That(Text(PrefabPath),
            Does.Contain("  m_Materials:\n  - {fileID: 10303, guid: 0000000000000000f000000000000000, type: 0}\n"));
        Assert.That(Text(PrefabPath), Does.Contain("  m_Mesh: {fileID: 4300000, guid: "
            + $"{AssetDatabase.AssetPathToGUID("Assets/Hull.asset")}, type: 2}}\n"));
        Assert.That(Text(PrefabPath + ".meta"),
            Does.Contain("\nPrefabImporter:\n  externalObjects: {}\n  userData: \n"));
    }

    [Test]
    public void Scene_OpenedAfterwards_FindsPrefabAndMesh()
    {
        Mesh mesh = Triangle("Hull");
        AssetDatabase.CreateAsset(mesh, "Assets/Hull.asset");
        PrefabUtility.SaveAsPrefabAsset(Ship(mesh), PrefabPath);
        string guid = AssetDatabase.AssetPathToGUID(PrefabPath);
        string instance = UnityText.Instance(50, 1).Replace(TemporaryProject.Guid(1), guid);
        GameObject ship = Project.LoadScene(UnityText.Scene(instance, 50)).Single();
        Assert.That(ship.GetComponentInChildren<MeshFilter>().sharedMesh, Is.SameAs(mesh));

        // Saved again with another mesh; the next load must have it.
        Mesh other = Triangle("Other");
        AssetDatabase.CreateAsset(other, "Assets/Other.asset");
        PrefabUtility.SaveAsPrefabAsset(Ship(other), PrefabPath);
        Assert.That(Project.Load().Single().GetComponentInChildren<MeshFilter>().sharedMesh, Is.SameAs(other));
    }

    [Test]
    public void Prefab_WithAMaterialOfTheProject_RefersToIt()
    {
        Project.Write("Assets/Steel.mat", UnityText.Header + "--- !u!21 &2100000\nMaterial:\n  m_Name: Steel\n", 9);
        var item = new GameObject("Plate", typeof(MeshRenderer));
        item.GetComponent<MeshRenderer>().sharedMaterial = AssetDatabase.LoadAssetAtPath<Material>("Assets/Steel.mat");
        PrefabUtility.SaveAsPrefabAsset(item, PrefabPath);
        Assert.That(Text(PrefabPath), Does.Contain($"  m_Materials:\n  - {UnityText.Asset(2100000, 9, 2)}\n"));
        Assert.That(Reopened<GameObject>(PrefabPath).GetComponent<MeshRenderer>().sharedMaterial.name,
            Is.EqualTo("Steel"));
    }

    [Test]
    public void Script_WithFieldsOfAllKinds_IsReadBack()
    {
        Project.WriteScript(typeof(Marker), 3);
        Project.WriteScript(typeof(MarkerOptions), 4);
        Project.Write("Assets/Notes.txt", "notes", 5);
        Project.Write("Assets/Other.prefab", UnityText.Prefab(UnityText.Object(10, "Other",
            components: UnityText.Component(12)) + UnityText.Script(12, 10, 3, "  Text: other\n")), 6);
        var options = ScriptableObject.CreateInstance<MarkerOptions>();
        AssetDatabase.CreateAsset(options, "Assets/Options.asset");
        Mesh mesh = Triangle();
        AssetDatabase.CreateAsset(mesh, "Assets/Shape.asset");

        GameObject root = new("Ship"), child = new("Mast");
        child.transform.SetParent(root.transform, false);
        Marker marker = root.AddComponent<Marker>();
        marker.Target = child.transform;
        marker.Model = child;
        marker.Other = AssetDatabase.LoadAssetAtPath<Marker>("Assets/Other.prefab");
        marker.Shape = mesh;
        marker.Settings = options;
        marker.Notes = AssetDatabase.LoadAssetAtPath<TextAsset>("Assets/Notes.txt");
        marker.Numbers = [0.1f, -0f, float.NaN, float.PositiveInfinity, 1e-40f, 16777216f];
        marker.Packed = [1, -2, int.MaxValue];
        marker.Switches = [true, false, true];
        marker.Words = ["plain", "", "a: b", "it's", " edge ", "- x", "two\nlines", "Sjö \u20ac", "#1", "tab\t\"\\"];
        marker.Targets = [child.transform, null, root.transform];
        marker.Parts = [new() { Length = 1f, Label = "a" }, new() { Length = 2f, Offset = Vector3.up }];
        marker.Main = new() { Length = 4f, Label = "main" };
        marker.Kind = MarkerKind.Fourth;
        marker.Layers = ~5;
        marker.Vector = _position;
        marker.Cell = new Vector2Int(-3, 4);
        marker.Turn = new Quaternion(0.5f, 0.5f, 0.5f, 0.5f);
        marker.Colour = new Color(0.1f, 0.2f, 0.3f, 0.4f);
        marker.Bytes = new Color32(1, 2, 3, 254);
        marker.Box = new Bounds(_position, Vector3.one);
        marker.Area = new Rect(1f, 2f, 3f, 4f);
        marker.Precise = 0.1 + 0.2;
        marker.Large = long.MinValue;
        marker.Unsigned = ulong.MaxValue;
        marker.Text = "yes: [no]";
        marker.Kept = -7;

        Marker read = PrefabUtility.SaveAsPrefabAsset(root, PrefabPath, out bool success)?.GetComponent<Marker>();
        Assert.That(success, string.Join("\n", Errors));
        Assert.That(read.Target, Is.SameAs(read.transform.GetChild(0)));
        Assert.That(read.Model, Is.SameAs(read.Target.gameObject));
        Assert.That(read.Other.Text, Is.EqualTo("other"));
        Assert.That((read.Shape, read.Settings), Is.EqualTo((mesh, options)));
        Assert.That(read.Notes, Is.SameAs(marker.Notes));
        Assert.That(read.Numbers, Is.EqualTo(marker.Numbers));
        Assert.That(1f / read.Numbers[1], Is.EqualTo(float.NegativeInfinity));
        Assert.That(read.Packed, Is.EqualTo(marker.Packed));
        Assert.That(read.Switches, Is.EqualTo(marker.Switches));
        Assert.That(read.Words, Is.EqualTo(marker.Words));
        Assert.That(read.Targets, Is.EqualTo(new[] { read.Target, null, read.transform }));
        Assert.That(read.Parts.Select(part => (part.Length, part.Label, part.Offset)),
            Is.EqualTo(new[] { (1f, "a", Vector3.zero), (2f, "", Vector3.up) }));
        Assert.That((read.Main.Length, read.Main.Label), Is.EqualTo((4f, "main")));
        Assert.That((read.Kind, read.Layers.value, read.Vector, read.Cell),
            Is.EqualTo((marker.Kind, ~5, _position, marker.Cell)));
        Assert.That((read.Turn, read.Colour, read.Bytes, read.Box, read.Area),
            Is.EqualTo((marker.Turn, marker.Colour, marker.Bytes, marker.Box, marker.Area)));
        Assert.That((read.Precise, read.Large, read.Unsigned),
            Is.EqualTo((marker.Precise, marker.Large, marker.Unsigned)));
        Assert.That((read.Text, read.Kept, read.Base, read.Hidden, read.Private),
            Is.EqualTo(("yes: [no]", -7, 1, 1f, 1f)));
        Assert.That(Project.Warnings, Is.Empty);

        // A loaded prefab that is saved again has the same text.
        string text = Text(PrefabPath);
        GameObject copy = Object.Instantiate(AssetDatabase.LoadAssetAtPath<GameObject>(PrefabPath));
        PrefabUtility.SaveAsPrefabAsset(copy, PrefabPath);
        Assert.That(Text(PrefabPath), Is.EqualTo(text));
    }

    [Test]
    public void Text_OfAnyCharacters_IsReadBack()
    {
        Project.WriteScript(typeof(Marker), 3);
        Prop.ForAll(ArbMap.Default.ArbFor<NonNull<string>>(), words =>
        {
            // Half of a surrogate pair cannot be in a file.
            string expected = string.Concat(words.Get.EnumerateRunes());
            Marker marker = new GameObject("A").AddComponent<Marker>();
            marker.Text = words.Get;
            marker.Words = ["first", words.Get];
            marker.Main.Label = words.Get;
            Marker read = PrefabUtility.SaveAsPrefabAsset(marker.gameObject, PrefabPath).GetComponent<Marker>();
            Object.DestroyImmediate(marker.gameObject);
            return read.Text == expected && read.Words[1] == expected && read.Main.Label == expected;
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(300));
    }

    [TestCase("null"), TestCase("~"), TestCase("true"), TestCase("1e5"), TestCase("=")]
    [TestCase("a #b"), TestCase("a:"), TestCase("---"), TestCase("..."), TestCase("<<"), TestCase("'"), TestCase("{}")]
    public void Text_ThatYamlKnows_IsReadBack(string text)
    {
        Project.WriteScript(typeof(Marker), 3);
        Marker marker = new GameObject("A").AddComponent<Marker>();
        (marker.Text, marker.Words) = (text, [text]);
        Marker read = PrefabUtility.SaveAsPrefabAsset(marker.gameObject, PrefabPath).GetComponent<Marker>();
        Assert.That((read.Text, read.Words.Single()), Is.EqualTo((text, text)));
    }

    [Test]
    public void Ids_AfterAnObjectIsAdded_AreThoseOfBefore()
    {
        GameObject root = new("Any"), hull = new("Hull", typeof(MeshFilter)), second = new("Hull");
        hull.transform.SetParent(root.transform);
        second.transform.SetParent(root.transform);
        PrefabUtility.SaveAsPrefabAsset(root, PrefabPath);
        List<string> before = Headers();
        Assert.That(before, Is.Unique.And.Count.EqualTo(7));

        var mast = new GameObject("Mast", typeof(MeshFilter));
        mast.transform.SetParent(root.transform);
        mast.transform.SetAsFirstSibling();
        PrefabUtility.SaveAsPrefabAsset(root, PrefabPath);
        Assert.That(Headers(), Is.SupersetOf(before).And.Count.EqualTo(10));
        // The root always has the file's name, and its ids do not depend on its name.
        Assert.That(AssetDatabase.LoadAssetAtPath<GameObject>(PrefabPath).name, Is.EqualTo("Ship"));
    }

    [Test]
    public void Reference_ToWhatNoFileHolds_IsRefusedByName_AndNothingIsWritten()
    {
        GameObject root = Ship(Triangle("Hull"));
        Assert.That(PrefabUtility.SaveAsPrefabAsset(root, PrefabPath, out bool success), Is.Null);
        Assert.That(success, Is.False);
        Assert.That(Errors.Single(), Is.EqualTo("MeshFilter of 'Hull': m_Mesh refers to the Mesh 'Hull', "
            + "which is neither an asset nor below the same root: "
            + "make it an asset first (AssetDatabase.CreateAsset), or clear the field"));
        Assert.That(AssetDatabase.AssetPathExists(PrefabPath), Is.False);
    }

    [Test]
    public void Prefab_WithACamera_IsReadBack()
    {
        var camera = new GameObject("Radar", typeof(Camera)).GetComponent<Camera>();
        (camera.fieldOfView, camera.nearClipPlane, camera.farClipPlane, camera.orthographicSize) =
            (12.5f, 0.01f, 5000f, 7f);
        (camera.orthographic, camera.enabled, camera.depth, camera.cullingMask, camera.rect) =
            (true, false, -3f, ~5, new Rect(0.25f, 0, 0.5f, 0.75f));
        PrefabUtility.SaveAsPrefabAsset(camera.gameObject, PrefabPath);
        var read = Reopened<GameObject>(PrefabPath).GetComponent<Camera>();
        Assert.That((read.fieldOfView, read.nearClipPlane, read.farClipPlane, read.orthographicSize),
            Is.EqualTo((12.5f, 0.01f, 5000f, 7f)));
        Assert.That((read.orthographic, read.enabled, read.depth, read.cullingMask, read.rect),
            Is.EqualTo((true, false, -3f, ~5, new Rect(0.25f, 0, 0.5f, 0.75f))));
    }

    [Test]
    public void Prefab_WithAComponentThatIsNotWritten_IsRefusedByName()
    {
        PrefabUtility.SaveAsPrefabAsset(new GameObject("Radar", typeof(LODGroup)), PrefabPath, out bool success);
        Assert.That(success, Is.False);
        Assert.That(Errors.Single(), Is.EqualTo("LODGroup of 'Radar' is not written outside of Unity: leave it out, "
            + "or save the prefab in Unity"));
    }

    [Test]
    public void SaveAsPrefabAsset_WithWrongArguments_Throws()
    {
        Assert.That(() => PrefabUtility.SaveAsPrefabAsset(null, PrefabPath), Throws.ArgumentNullException);
        Assert.That(() => PrefabUtility.SaveAsPrefabAsset(new GameObject(), "Assets/Ship.asset"),
            Throws.ArgumentException);
        GameObject prefab = PrefabUtility.SaveAsPrefabAsset(new GameObject(), PrefabPath);
        Assert.That(() => PrefabUtility.SaveAsPrefabAsset(prefab, "Assets/B.prefab"), Throws.ArgumentException);
    }

    List<string> Headers() =>
        Regex.Matches(Text(PrefabPath), "^--- .*$", RegexOptions.Multiline).Select(match => match.Value).ToList();

    static GameObject Ship(Mesh mesh)
    {
        GameObject root = new("Made by code"), hull = new("Hull", typeof(MeshFilter), typeof(MeshRenderer));
        hull.transform.SetParent(root.transform, false);
        hull.transform.localPosition = _position;
        hull.transform.localRotation = Quaternion.Euler(10f, 20f, 30f);
        hull.transform.localScale = _scale;
        hull.GetComponent<MeshFilter>().sharedMesh = mesh;
        hull.GetComponent<MeshRenderer>().sharedMaterial =
            AssetDatabase.GetBuiltinExtraResource<Material>("Default-Material.mat");
        var hidden = new GameObject("Bow: [1]") { layer = 3, tag = "Player" };
        hidden.transform.SetParent(hull.transform, false);
        hidden.SetActive(false);
        return root;
    }

    static void AssertIsShip(GameObject ship, Mesh mesh)
    {
        Transform hull = ship.transform.GetChild(0);
        Assert.That((ship.name, hull.name, ship.transform.childCount), Is.EqualTo(("Ship", "Hull", 1)));
        Assert.That((hull.localPosition, hull.localScale), Is.EqualTo((_position, _scale)));
        Assert.That(hull.localPosition.z, Is.EqualTo(1e-7f));
        Assert.That(Quaternion.Angle(hull.localRotation, Quaternion.Euler(10f, 20f, 30f)), Is.LessThan(0.1f));
        Assert.That(hull.GetComponent<MeshFilter>().sharedMesh, Is.SameAs(mesh));
        Assert.That(hull.GetComponent<MeshRenderer>().sharedMaterial.name, Is.EqualTo("Default-Material"));
        GameObject hidden = hull.GetChild(0).gameObject;
        Assert.That((hidden.name, hidden.layer, hidden.tag, hidden.activeSelf),
            Is.EqualTo(("Bow: [1]", 3, "Player", false)));
    }
}
