using System;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host.Tests;

/// <summary>Mesh assets: saved meshes read back bit for bit, and the same content gives the same bytes.</summary>
public sealed class MeshWritingTests : WritingFixture
{
    const string AssetPath = "Packages/com.glint.meshes/Sea State 5/Snapshot 01.asset",
        File = "Meshes/Sea State 5/Snapshot 01.asset";

    [Test]
    public void CreateAsset_InALocalPackage_WritesItsFileAndAllMetas()
    {
        Assert.That(AssetDatabase.CreateFolder("Packages/com.glint.meshes", "Sea State 5"), Has.Length.EqualTo(32));
        Mesh mesh = Triangle("Snapshot 01");
        AssetDatabase.CreateAsset(mesh, AssetPath);
        Assert.That(AssetDatabase.GetAssetPath(mesh), Is.EqualTo(AssetPath));
        Assert.That(AssetDatabase.LoadAssetAtPath<Mesh>(AssetPath), Is.SameAs(mesh));
        Assert.That(Text("Meshes/Sea State 5.meta"), Does.Contain("folderAsset: yes\nDefaultImporter:\n"));
        Assert.That(Text(File + ".meta"),
            Does.Contain("NativeFormatImporter:\n  externalObjects: {}\n  mainObjectFileID: 4300000\n"));
        Assert.That(Text(File), Does.StartWith("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!43 &4300000\nMesh:\n"
            + "  m_ObjectHideFlags: 0\n"));
        Assert.That(Directory.EnumerateFiles(Path.Combine(Project.Root, "Meshes/Sea State 5"), "*",
            new EnumerationOptions { AttributesToSkip = 0 }).Count(), Is.EqualTo(2));
        Assert.That(Errors, Is.Empty);
    }

    // The worked example of a plate: two 16-bit triangles, each vertex position then normal, little endian.
    [Test]
    public void CreateAsset_APlate_HasItsNumbersWhereUnityLooks()
    {
        var mesh = new Mesh
        {
            name = "Plate",
            vertices = [new(-1f, 0f, -1f), new(-1f, 0f, 1f), new(1f, 0f, 1f), new(1f, 0f, -1f)],
            normals = [Vector3.up, Vector3.up, Vector3.up, Vector3.up],
            triangles = [0, 1, 2, 0, 2, 3],
        };
        AssetDatabase.CreateAsset(mesh, "Assets/Plate.asset");
        string text = Text("Assets/Plate.asset");
        Assert.That(text, Does.Contain("  m_IndexFormat: 0\n  m_IndexBuffer: 000001000200000002000300\n"));
        Assert.That(text,
            Does.Contain("    m_DataSize: 96\n    _typelessdata: 000080bf00000000000080bf000000000000803f00000000"));
        Assert.That(text, Does.Contain("    - stream: 0\n      offset: 12\n      format: 0\n      dimension: 3\n"
            + "    - stream: 0\n      offset: 0\n      format: 0\n      dimension: 0\n"));
        Assert.That(text,
            Does.Contain("    localAABB:\n      m_Center: {x: 0, y: 0, z: 0}\n      m_Extent: {x: 1, y: 0, z: 1}\n"));
    }

    [Test]
    public void Mesh_OfAnyContent_IsReadBackBitForBit() => Prop.ForAll(Arb.From(Meshes), contents =>
    {
        var mesh = new Mesh { name = "Any" };
        mesh.Load(contents);
        AssetDatabase.CreateAsset(mesh, "Assets/Any.asset");
        string first = Text("Assets/Any.asset");
        Mesh read = Reopened<Mesh>("Assets/Any.asset");
        EditorUtility.SetDirty(read);
        AssetDatabase.SaveAssets();
        return (Describe(read.Contents) == Describe(contents)).Label("content")
            .And((Text("Assets/Any.asset") == first).Label("bytes"));
    }).Check(Config.QuickThrowOnFailure.WithMaxTest(200));

    static readonly Gen<float> Floats = Gen.OneOf(
        Gen.Choose(int.MinValue, int.MaxValue).Select(BitConverter.Int32BitsToSingle).Where(float.IsFinite),
        Gen.Elements(0f, -0f, float.Epsilon, -float.MaxValue, 0.1f));

    static readonly Gen<MeshContents> Meshes =
        from vertexCount in Gen.Choose(1, 30)
        from numbers in Floats.ArrayOf(20 * vertexCount)
        from isWide in Gen.Elements(true, false)
        from parts in Gen.Choose(0, 3)
        from indices in Gen.Choose(0, vertexCount - 1).ArrayOf(12 * parts)
        from topologies in Gen.Elements(MeshTopology.Triangles, MeshTopology.Quads, MeshTopology.Lines,
            MeshTopology.Points).ArrayOf(parts)
        from channels in Gen.Choose(0, 31)
        from dimension in Gen.Choose(2, 4)
        select new MeshContents
        {
            Vertices = Take(numbers, 0, vertexCount, v => (Vector3)v),
            Normals = (channels & 1) > 0 ? Take(numbers, 3, vertexCount, v => (Vector3)v) : [],
            Tangents = (channels & 2) > 0 ? Take(numbers, 6, vertexCount, v => v) : [],
            Colors = (channels & 4) > 0 ? Take(numbers, 10, vertexCount, v => new Color(v.x, v.y, v.z, v.w)) : [],
            Uvs = [.. Enumerable.Range(0, 8).Select(uv => (uv == 0 && (channels & 8) > 0)
                || (uv == 5 && (channels & 16) > 0)
                ? Take(numbers, 14, vertexCount,
                    v => new Vector4(v.x, v.y, dimension > 2 ? v.z : 0f, dimension > 3 ? v.w : 0f)) : [])],
            Indices = indices,
            IndexFormat = isWide ? IndexFormat.UInt32 : IndexFormat.UInt16,
            SubMeshes = [.. topologies.Select((topology, part) => new SubMeshDescriptor(12 * part, 12, topology)
            {
                firstVertex = Math.Min(part, vertexCount), vertexCount = vertexCount - Math.Min(part, vertexCount),
                bounds = new Bounds(new Vector3(part, 0.1f, -7f), Vector3.one * 0.3f),
            })],
            Bounds = new Bounds(new Vector3(numbers[0] % 1e3f, 1e-7f, 0f), new Vector3(0.7f, 12f, 1e9f)),
        };

    static T[] Take<T>(float[] numbers, int from, int count, Func<Vector4, T> make) => Enumerable.Range(0, count)
        .Select(vertex => 20 * vertex + from).Select(start =>
            make(new Vector4(numbers[start], numbers[start + 1], numbers[start + 2], numbers[start + 3]))).ToArray();

    // Every number as bits: -0 is not 0.
    static string Describe(MeshContents contents) => string.Join("\n",
        Hex<Vector3>(contents.Vertices), Hex<Vector3>(contents.Normals),
        Hex<Vector4>(contents.Tangents), Hex<Color>(contents.Colors),
        string.Join("\n", contents.Uvs.Select(uv => Hex<Vector4>(uv))),
        string.Join(" ", contents.Indices), contents.IndexFormat,
        string.Join("\n", contents.SubMeshes.Select(part => $"{part.indexStart} {part.indexCount} {part.topology} "
            + $"{part.baseVertex} {part.firstVertex} {part.vertexCount} {Hex<Bounds>([part.bounds])}")),
        Hex<Bounds>([contents.Bounds]), contents.IsReadable);

    static string Hex<T>(ReadOnlySpan<T> values)
        where T : unmanaged => Convert.ToHexString(MemoryMarshal.AsBytes(values));

    [Test]
    public void Mesh_Of70000Vertices_KeepsIts32BitIndices()
    {
        var mesh = new Mesh
        {
            name = "Large", indexFormat = IndexFormat.UInt32,
            vertices = [.. Enumerable.Range(0, 70000).Select(i => new Vector3(i, 0.5f * i, 1f))]
        };
        mesh.SetIndices([69999, 1, 65536], MeshTopology.Triangles, 0);
        AssetDatabase.CreateAsset(mesh, "Assets/Large.asset");
        Assert.That(Describe(Reopened<Mesh>("Assets/Large.asset").Contents), Is.EqualTo(Describe(mesh.Contents)));
    }

    [Test]
    public void SaveAssetIfDirty_AfterAChange_WritesIt_AndOnlyThen()
    {
        AssetDatabase.CreateAsset(Triangle(), "Assets/A.asset");
        Mesh mesh = Reopened<Mesh>("Assets/A.asset");
        mesh.vertices = [Vector3.zero, 2f * Vector3.up, Vector3.right];
        string before = Text("Assets/A.asset");
        AssetDatabase.SaveAssetIfDirty(mesh);
        Assert.That(Text("Assets/A.asset"), Is.EqualTo(before));
        EditorUtility.SetDirty(mesh);
        AssetDatabase.SaveAssetIfDirty(mesh);
        Assert.That(EditorUtility.IsDirty(mesh), Is.False);
        Assert.That(Reopened<Mesh>("Assets/A.asset").vertices[1], Is.EqualTo(2f * Vector3.up));
    }

    // Saving resets the dirty count, by which a gatherer knows that a stored mesh has changed.
    [Test]
    public void SaveAssets_AfterAChange_IsSeenByTheNextGather()
    {
        AssetDatabase.CreateAsset(Triangle(), "Assets/A.asset");
        Mesh mesh = Reopened<Mesh>("Assets/A.asset");
        var shown = new GameObject("A", typeof(MeshFilter), typeof(MeshRenderer));
        shown.GetComponent<MeshFilter>().sharedMesh = mesh;
        var gatherer = new SceneGatherer();
        try
        {
            var before = gatherer.Gather(~0, [shown.transform], null);
            mesh.vertices = [Vector3.zero, 2f * Vector3.up, Vector3.right];
            EditorUtility.SetDirty(mesh);
            AssetDatabase.SaveAssets();
            Assert.That(EditorUtility.GetDirtyCount(mesh), Is.Zero);
            Assert.That(gatherer.Gather(~0, [shown.transform], null), Is.Not.SameAs(before));
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(shown);
        }
    }

    [Test]
    public void CopySerialized_OntoAnAsset_IsWrittenBySaveAssets_AndTheGuidStays()
    {
        AssetDatabase.CreateAsset(Triangle("A"), "Assets/A.asset");
        string meta = Text("Assets/A.asset.meta");
        Mesh mesh = Reopened<Mesh>("Assets/A.asset"), source = Triangle("A");
        source.vertices = [Vector3.zero, 3f * Vector3.up, Vector3.right];
        EditorUtility.CopySerialized(source, mesh);
        AssetDatabase.SaveAssets();
        Assert.That(AssetDatabase.GetAssetPath(mesh), Is.EqualTo("Assets/A.asset"));
        Assert.That(Describe(Reopened<Mesh>("Assets/A.asset").Contents), Is.EqualTo(Describe(source.Contents)));
        Assert.That(Text("Assets/A.asset.meta"), Is.EqualTo(meta));
    }

    [Test]
    public void CreateAsset_OverAnAsset_KeepsItsGuid()
    {
        Project.Write("Assets/A.asset", MeshText.Of([0, 0, 0, 0, 1, 0, 1, 0, 0], 0, 1, 2).ToString(), 7);
        Mesh mesh = Triangle("A");
        AssetDatabase.CreateAsset(mesh, "Assets/A.asset");
        Assert.That(AssetDatabase.AssetPathToGUID("Assets/A.asset"), Is.EqualTo(TemporaryProject.Guid(7)));
        Assert.That(AssetDatabase.LoadAssetAtPath<Mesh>("Assets/A.asset"), Is.SameAs(mesh));
    }

    [Test]
    public void NewGuid_IsThatOfThePath_UnlessAMovedFileHasIt()
    {
        AssetDatabase.CreateAsset(Triangle(), "Assets/A.asset");
        string guid = AssetDatabase.AssetPathToGUID("Assets/A.asset"), text = Text("Assets/A.asset");
        foreach (string end in new[] { "", ".meta" })
            System.IO.File.Delete(Path.Combine(Project.Root, "Assets/A.asset" + end));
        AssetDatabase.Refresh();
        AssetDatabase.CreateAsset(Triangle(), "Assets/A.asset");
        Assert.That(AssetDatabase.AssetPathToGUID("Assets/A.asset"), Is.EqualTo(guid));
        Assert.That(Text("Assets/A.asset"), Is.EqualTo(text));

        foreach (string end in new[] { "", ".meta" })
            System.IO.File.Move(Path.Combine(Project.Root, "Assets/A.asset" + end),
                Path.Combine(Project.Root, "Assets/B.asset" + end));
        AssetDatabase.Refresh();
        AssetDatabase.CreateAsset(Triangle(), "Assets/A.asset");
        Assert.That(AssetDatabase.AssetPathToGUID("Assets/A.asset"), Is.Not.EqualTo(guid));
        Assert.That(AssetDatabase.GUIDToAssetPath(guid), Is.EqualTo("Assets/B.asset"));
    }

    [Test]
    public void ScriptableObject_WithAReference_IsReadBack()
    {
        Project.WriteScript(typeof(MarkerOptions), 3);
        var first = ScriptableObject.CreateInstance<MarkerOptions>();
        first.Frequency = 9.4e9f;
        AssetDatabase.CreateAsset(first, "Assets/First.asset");
        var second = ScriptableObject.CreateInstance<MarkerOptions>();
        second.Next = first;
        AssetDatabase.CreateAsset(second, "Assets/Second.asset");
        MarkerOptions read = Reopened<MarkerOptions>("Assets/Second.asset");
        Assert.That((read.Frequency, read.Next.Frequency), Is.EqualTo((1f, 9.4e9f)));
        Assert.That((read.name, read.Next.name), Is.EqualTo(("Second", "First")), "an asset is called as its file");
    }

    [TestCase("Elsewhere/A.asset", "'Elsewhere/A.asset': no place for an asset: give a path below Assets, "
        + "or below Packages and the name of an embedded or local package")]
    [TestCase("Packages/com.other/A.asset", "'Packages/com.other/A.asset': no place for an asset: "
        + "give a path below Assets, or below Packages and the name of an embedded or local package")]
    [TestCase("Assets/../A.asset", "'Assets/../A.asset': no place for an asset: give a path below Assets, "
        + "or below Packages and the name of an embedded or local package")]
    [TestCase("Assets/None/A.asset",
        "Assets/None/A.asset: its folder is not there: make Assets/None first (AssetDatabase.CreateFolder)")]
    [TestCase("Assets/A.fbx", "Assets/A.fbx: an asset's name ends in .asset")]
    public void CreateAsset_WhereNoneCanBe_SaysSo(string path, string message)
    {
        Assert.That(Assert.Throws<UnityException>(() => AssetDatabase.CreateAsset(Triangle(), path)).Message,
            Is.EqualTo(message));
        Assert.That(Directory.GetFileSystemEntries(Path.Combine(Project.Root, "Assets")), Is.Empty);
    }

    // The system refuses a folder in the file's place for every user; a read-only folder would not stop root.
    [Test]
    public void CreateAsset_WhereTheSystemRefuses_SaysSoInOneLine_AndLeavesNothing()
    {
        Directory.CreateDirectory(Path.Combine(Project.Root, "Assets/A.asset"));
        string message =
            Assert.Throws<UnityException>(() => AssetDatabase.CreateAsset(Triangle(), "Assets/A.asset")).Message;
        Assert.That(message, Does.StartWith("Assets/A.asset: cannot be written: ").And.Not.Contain("\n"));
        Assert.That(Directory.GetFileSystemEntries(Path.Combine(Project.Root, "Assets")), Has.Length.EqualTo(1));
    }

    [Test]
    public void CreateAsset_OfWhatIsNotWritten_IsRefused()
    {
        string message = Assert.Throws<UnityException>(
            () => AssetDatabase.CreateAsset(new Material((Shader)null), "Assets/M.mat")).Message;
        Assert.That(message, Is.EqualTo("the Material 'M' is not written outside of Unity: only meshes, "
            + "ScriptableObjects and prefabs are"));
        Mesh mesh = Triangle();
        AssetDatabase.CreateAsset(mesh, "Assets/A.asset");
        message = Assert.Throws<UnityException>(() => AssetDatabase.CreateAsset(mesh, "Assets/B.asset")).Message;
        Assert.That(message,
            Does.StartWith("Creating asset at path Assets/B.asset failed: 'A' is the asset Assets/A.asset already"));
    }

    [Test]
    public void Mesh_WithASkin_IsNotSavedWithoutIt()
    {
        string text = MeshText.Of([0, 0, 0, 0, 1, 0, 1, 0, 0], 0, 1, 2).ToString();
        Project.Write("Assets/A.asset", text + "  m_BindPose:\n  - e00: 1\n", 7);
        Mesh mesh = AssetDatabase.LoadAssetAtPath<Mesh>("Assets/A.asset");
        EditorUtility.SetDirty(mesh);
        Assert.That(Assert.Throws<UnityException>(AssetDatabase.SaveAssets).Message,
            Is.EqualTo("Assets/A.asset: holds a skin, which only Unity writes: save it there"));
    }

    [Test]
    public void CreateFolder_Twice_NumbersTheSecond()
    {
        AssetDatabase.CreateFolder("Assets", "Seas");
        Assert.That(AssetDatabase.GUIDToAssetPath(AssetDatabase.CreateFolder("Assets", "Seas")),
            Is.EqualTo("Assets/Seas 1"));
        Assert.That(AssetDatabase.IsValidFolder("Assets/Seas 1")
            && AssetDatabase.IsValidFolder("Packages/com.glint.meshes") && AssetDatabase.IsValidFolder("Assets"));
        Assert.That(AssetDatabase.IsValidFolder("Assets/None") || AssetDatabase.IsValidFolder("")
            || AssetDatabase.IsValidFolder("Meshes"), Is.False);
    }

    [Test]
    public void CreateFolder_WithoutAParent_LogsIt()
    {
        Assert.That(AssetDatabase.CreateFolder("Assets/None", "Seas"), Is.Empty);
        Assert.That(Errors, Is.EqualTo(new[] { "Assets/None/Seas: its folder is not there: "
            + "make Assets/None first (AssetDatabase.CreateFolder)" }));
    }
}
