using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Cli;
using Unity.Mathematics;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

/// <summary>
/// A small project: the published experiment's scene and prefab, and a scene with everything that the loader knows.
/// Each case damages one or two of its files, and loads or traces a scene with few rays.
/// </summary>
sealed class SceneCases : IDisposable
{
    const string Radar = "Packages/com.glint.radar", Experiment = "Assets/CornerReflector.unity",
        Whole = "Assets/Scene.unity";
    const int Mast = 1, Fleet = 2, Hull = 3, Options = 4, Paint = 5, MarkerScript = 9, OptionsScript = 10;

    static readonly string[] Experiments =
        ["Scenes/CornerReflector.unity", "Meshes/CornerReflector/Corner Reflector.prefab"];
    static readonly string[] Scripts = ["Runtime/Components/RadarController.cs",
        "Runtime/Components/Sweep.cs", "Runtime/Glint.asmdef",
        "package.json", "Shaders/Trace.compute.meta"];

    readonly TemporaryProject _project = new();
    readonly Action<LogType, string> _logBefore = LogSink.Writer;
    readonly List<string> _log = [];
    readonly (string Path, byte[] Content)[] _files;
    readonly string[] _subjects;
    readonly string _keepIn;

    /// <param name="productRoot">The project with the experiment.</param>
    /// <param name="keepIn">Folder for copies of the damaged files; may be null.</param>
    public SceneCases(string productRoot, string keepIn)
    {
        _keepIn = keepIn;
        CopyExperiment(productRoot);
        WriteWhole();
        // The kernels' sources are not damaged.
        var all = Directory.EnumerateFiles(_project.Root, "*", SearchOption.AllDirectories)
            .Select(path => Path.GetRelativePath(_project.Root, path)).ToArray();
        _files = all.Where(path => Path.GetExtension(path) is not (".hlsl" or ".compute" or ".cs"))
            .Order(StringComparer.Ordinal)
            .Select(path => (path, File.ReadAllBytes(Path.Combine(_project.Root, path)))).ToArray();
        _subjects = [.. all.Select(Path.GetFileNameWithoutExtension), "mesh", "--", "results"];
        _ = _project.Project;
        LogSink.Writer = (type, message) => _log.Add($"[{type}] {message}");
    }

    /// <summary>Loads a scene and gathers its triangles.</summary>
    public Outcome Load(Random random)
    {
        string scene = Pick([Experiment, Whole], random);
        var damaged = DamageSome(random, scene);
        _log.Clear();
        try
        {
            return WithoutErrors(Outcome.Of(() =>
            {
                Project.Open(_project.Root);
                SceneRegistry.Fill(SceneRegistry.AddFile(scene));
                return Gather();
            }, _subjects));
        }
        finally
        {
            Engine.Reset();
            Mend(damaged);
        }
    }

    /// <summary>Traces a scene or a mesh file by a command in this process.</summary>
    public Outcome Trace(Random random) => Command(random, arguments =>
    {
        var (output, error) = (new StringWriter(), new StringWriter());
        try
        {
            int code = new Shell(new Terminal { Out = output, Error = error, Live = null, Width = 100 }).Run(arguments);
            return (code, output.ToString(), error.ToString());
        }
        finally
        {
            LogSink.Writer = (type, message) => _log.Add($"[{type}] {message}");
            Engine.DeviceSelector = null;
            Engine.Reset();
        }
    });

    /// <summary>The same in its own process, as a user runs it.</summary>
    public Outcome Start(Random random) => Command(random, arguments =>
    {
        var start = GlintProcess.Of(arguments);
        start.WorkingDirectory = _project.Root;
        return GlintProcess.Run(start);
    });

    public void Dispose()
    {
        LogSink.Writer = _logBefore;
        _project.Dispose();
    }

    Outcome Command(Random random, Func<string[], (int Code, string Output, string Error)> run)
    {
        var damaged = new List<(string, byte[])>();
        string[] arguments;
        if (random.Next(3) == 0)
        {
            var (name, content) = MeshCases.Make(random);
            File.WriteAllBytes(PathOf(name), content);
            Keep(name);
            arguments = MeshLine(name, random);
        }
        else
        {
            string scene = Pick([Experiment, Whole], random);
            if (random.Next(4) > 0)
                damaged = DamageSome(random, scene);
            arguments = SceneLine(scene, random);
        }
        try
        {
            var (code, output, error) = run(arguments);
            var outcome = Outcome.OfCommand(code, output, error, _subjects);
            string written = string.Concat(Directory.EnumerateFiles(_project.Root, "results.*",
                SearchOption.AllDirectories).Select(File.ReadAllText));
            outcome = outcome.Verdict == Verdict.Done ? Outcome.OfCommand(0, written, "", _subjects) : outcome;
            return outcome.Verdict == Verdict.Finding
                ? outcome with { Text = $"glint {string.Join(' ', arguments)}: {outcome.Text}" }
                : outcome;
        }
        finally
        {
            Mend(damaged);
            foreach (string folder in Directory.GetDirectories(_project.Root, "out*"))
                Directory.Delete(folder, true);
        }
    }

    string[] SceneLine(string scene, Random random)
    {
        string[] line = random.Next(2) == 0 ? [Pick(["run", "verify"], random), PathOf(scene)]
            : ["sweep", PathOf(scene), "--target", scene == Experiment ? "Corner Reflector" : "Deck",
                "--angles", Pick(["0", "0,1", "-360,1e-9", "0:1:0.5"], random), "--out", Out(random)];
        return [.. line, "--size", "16x9", .. RadarOptions(random)];
    }

    string[] MeshLine(string name, Random random)
    {
        List<string> line = random.Next(4) == 0
            ? ["sweep", PathOf(name), "--angles", Pick(["0", "45,90", "1e-5"], random), "--out", Out(random)]
            : [Pick(["run", "verify"], random), PathOf(name)];
        // Plane-wave rays from a fixed rectangle; a rectangle fitted to any mesh may have billions of rays.
        bool isParallel = random.Next(4) == 0;
        line.AddRange(isParallel
            ? ["--spacing", Pick(["0.5", "1", "0.25"], random), "--aperture", Pick(["3", "1e-6", "2x5"], random)]
            : ["--size", Pick(["16x9", "1x1", "5x8", "64x1"], random)]);
        line.AddRange(RadarOptions(random));
        Add("--unit", "mm", "km", "um", "ft");
        Add("--up", "y", "z");
        Add("--distance", "3", "1e-6", "1e6", "0.5");
        Add("--grazing", "0", "90", "-90", "45", "1e-9");
        Add("--azimuth", "0", "-360", "33");
        if (!isParallel)
            Add("--fov", "179", "1e-5", "20");
        Add("--aim", "0,1,0", "1e6,-1e6,1e6", "1e-300,0,0");
        return line.ToArray();

        void Add(string option, params string[] values)
        {
            if (random.Next(3) == 0)
                line.AddRange([option, Pick(values, random)]);
        }
    }

    string[] RadarOptions(Random random)
    {
        List<string> options = [];
        Add("--frequency", "1", "1e12", "9.4e9");
        Add("--bounces", "1", "16");
        Add("--receiver", "1e-6", "1e6", "3x1e-6");
        Add("--region", "0,0,1,1", "15,8,1,1", "15,8,2,1", "3,2,9,5");
        Add("--device", "0", "no such device", "99");
        return options.ToArray();

        void Add(string option, params string[] values)
        {
            if (random.Next(8) == 0)
                options.AddRange([option, Pick(values, random)]);
        }
    }

    // A results folder: new, with older results, with an obstacle, or impossible.
    string Out(Random random)
    {
        string folder = PathOf("out");
        switch (random.Next(8))
        {
            case 0:
                Directory.CreateDirectory(folder);
                File.WriteAllText(Path.Combine(folder, Pick(["results.csv", "results.json", "results.lock"], random)),
                    Pick(["", "angle_deg,NaN\n", "{"], random));
                return folder;
            case 1:
                return Directory.CreateDirectory(Path.Combine(folder,
                Pick(["results.csv", "results.json", "results.lock", "other"], random))).Parent.FullName;
            case 2:
                return Pick([PathOf(Whole), PathOf(Whole) + "/out", "/proc/results", "/dev/null/results",
                folder + new string('x', 300), folder + "\t"], random);
            default: return folder;
        }
    }

    // The scene itself in half of the cases, else any file.
    List<(string Path, byte[] Content)> DamageSome(Random random, string scene)
    {
        List<(string Path, byte[] Content)> damaged = [];
        for (int count = random.Next(5) == 0 ? 2 : 1; count > 0; count--)
        {
            var file = random.Next(2) == 0 ? _files.Single(file => file.Path == scene) : Pick(_files, random);
            File.WriteAllBytes(PathOf(file.Path),
                Damage.Of(file.Content, random, _files.Select(other => other.Content).ToArray()));
            damaged.Add(file);
            Keep(file.Path);
        }
        return damaged;
    }

    void Keep(string path)
    {
        if (_keepIn != null)
            File.Copy(PathOf(path), Path.Combine(_keepIn, Path.GetFileName(path)), true);
    }

    void Mend(List<(string Path, byte[] Content)> damaged)
    {
        foreach (var (path, content) in damaged)
            File.WriteAllBytes(PathOf(path), content);
    }

    Outcome Gather()
    {
        foreach (var instance in new SceneGatherer().Gather(~0, [], null).Instances)
        {
            bool isFinite = math.all(math.isfinite(instance.ToWorld.X) & math.isfinite(instance.ToWorld.Y)
                    & math.isfinite(instance.ToWorld.Z) & math.isfinite(instance.ToWorld.Origin))
                && instance.Mesh.Vertices.All(vertex => math.all(math.isfinite(vertex)));
            if (!isFinite || instance.Mesh.Indices.Any(index => index < 0 || index >= instance.Mesh.Vertices.Length))
                return Outcome.Finding("gathered a mesh that is none");
        }
        return Outcome.Done;
    }

    Outcome WithoutErrors(Outcome outcome)
    {
        string error = _log.FirstOrDefault(line => !(line.StartsWith("[Log]") || line.StartsWith("[Warning]"))
            || line.Any(char.IsControl));
        return error == null ? outcome : Outcome.Finding($"logged: {error}");
    }

    void CopyExperiment(string productRoot)
    {
        void Copy(string from, string to)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(PathOf(to)));
            File.Copy(Path.Combine(productRoot, from), PathOf(to));
        }
        foreach (string file in Experiments.SelectMany(file => new[] { file, file + ".meta" }))
            Copy(file, "Assets/" + Path.GetFileName(file));
        foreach (string file in Scripts.Concat(Scripts.Where(script => script.EndsWith(".cs"))
            .Select(script => script + ".meta")))
            Copy($"{Radar}/{file}", $"{Radar}/{file}");
        foreach (string file in Directory.EnumerateFiles(Path.Combine(productRoot, Radar, "Shaders"))
            .Select(Path.GetFileName).Where(file => !file.EndsWith(".meta")))
            Copy($"{Radar}/Shaders/{file}", $"{Radar}/Shaders/{file}");
        Copy("ProjectSettings/ProjectVersion.txt", "ProjectSettings/ProjectVersion.txt");
        Copy("ProjectSettings/EditorBuildSettings.asset", "ProjectSettings/EditorBuildSettings.asset");
        _project.Write("ProjectSettings/TagManager.asset", Header + "--- !u!78 &1\nTagManager:\n  serializedVersion: "
            + "2\n  tags:\n  - Ship\n  layers:\n  - Default\n  - \n  - Water\n");
    }

    void WriteWhole()
    {
        _project.WriteScript(typeof(Marker), MarkerScript);
        _project.WriteScript(typeof(MarkerOptions), OptionsScript);
        _project.Write("Assets/Hull.asset",
            MeshText.Of([0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, 1], 0, 1, 2, 1, 2, 3).ToString(), Hull);
        _project.Write("Assets/Paint.mat", Header + "--- !u!21 &2100000\nMaterial:\n  m_Name: Paint\n", Paint);
        _project.Write("Assets/Options.asset",
            Header + $"--- !u!114 &11400000\nMonoBehaviour:\n  m_Script: {Asset(11500000, OptionsScript)}\n"
                + $"  m_Name: Options\n  Frequency: 3\n  Next: {Asset(11400000, Options, 2)}\n", Options);
        _project.Write("Assets/Mast.prefab", Prefab(Object(100, "Mast", children: [111], position: "{x: 0, y: 5, z: 0}")
            + Object(110, "Radar", father: 101, components: Component(112, 113, 114))
            + MeshFilter(112, 110) + MeshRenderer(113, 110) + Script(114, 110, MarkerScript,
                "  Target: {fileID: 101}\n  Numbers:\n  - 1.5\n  Packed: 0100000002000000\n")), Mast);
        _project.Write("Assets/Fleet.prefab",
            Prefab(Object(200, "Fleet") + Object(220, "Boat", father: 201, components: Component(222, 223))
                + MeshFilter(222, 220) + MeshRenderer(223, 220)
                + Instance(250, Mast, father: 201, modifications: "\n" + Change(101, Mast, "m_LocalPosition.x", "2"))
                + StandIn(4, 260, 101, Mast, 250)), Fleet);
        string script = $"{{fileID: 11500000, guid: 3a55cc0a53d649f99bad66d013e746cd, type: 3}}",
            kernel = "{fileID: 7200000, guid: ffd30fe9c86540ae9308a11817044a2f, type: 3}";
        string changes = "\n" + Change(114, Mast, "Numbers.Array.size", "3") + Change(114, Mast, "Packed.Array.data[1]",
                "-7") + Change(110, Mast, "m_Name", "Scanner") + Change(114, Mast, "Main.Length", "12")
            + Change(112, Mast, "m_Mesh", "", Asset(4300000, Hull, 2));
        _project.Write(Whole, Scene(
            Object(10, "Deck", children: [21, 600, 51], components: Component(12, 13, 14))
                + MeshFilter(12, 10, Asset(4300000, Hull, 2))
                + MeshRenderer(13, 10, $"  m_Enabled: 1\n  m_Materials:\n  - {Asset(2100000, Paint, 2)}\n")
            + Script(14, 10, MarkerScript, $"  Target: {{fileID: 21}}\n  Shape: {Asset(4300000, Hull, 2)}\n  Settings: "
                + $"{Asset(11400000, Options, 2)}\n  Packed: 0100000002000000\n  Main:\n    Length: 2\n    Label: a\n"
                + "  Cell: {x: 1, y: 2}\n  Kind: 4\n  Colour: {r: 1, g: 1, b: 1, a: 1}\n  Words:\n  - a\n  - b\n")
            + Object(20, "Rail", father: 11, components: Component(22, 23, 24), position: "{x: 1, y: 2, z: 3}")
            + MeshFilter(22, 20) + MeshRenderer(23, 20)
            + "--- !u!205 &24\nLODGroup:\n  m_GameObject: {fileID: 20}\n  m_LODs:\n  - screenRelativeHeight: 0.5\n"
            + "    renderers:\n    - renderer: {fileID: 23}\n  - screenRelativeHeight: 0.1\n    renderers:\n"
            + "    - renderer: {fileID: 13}\n  m_Enabled: 1\n"
            + Object(30, "Camera", children: [41], components: Component(32, 33), position: "{x: 0, y: 0, z: -20}")
            + "--- !u!20 &32\nCamera:\n  m_GameObject: {fileID: 30}\n  m_Enabled: 1\n  field of view: "
            + "30\n  orthographic: 0\n"
            + $"--- !u!114 &33\nMonoBehaviour:\n  m_GameObject: {{fileID: 30}}\n  m_Enabled: 1\n  m_Script: {script}\n"
            + "  m_Name: \n  _frequencyHz: 10000000000\n  _maxBounces: 3\n  _receiver: {fileID: 41}\n  _receiverSize: "
            + $"{{x: 3, y: 3}}\n  _roots:\n  - {{fileID: 11}}\n  _kernel: {kernel}\n"
            + Object(40, "Receiver", father: 31)
            + Object(50, "Lamp", father: 11, components: Component(52, 53))
            + "--- !u!108 &52\nLight:\n  m_GameObject: {fileID: 50}\n--- !u!137 &53\nSkinnedMeshRenderer:\n"
            + "  m_GameObject: {fileID: 50}\n  m_Enabled: 1\n  m_Mesh: " + Asset(4300000, Hull, 2) + "\n"
            + Instance(500, Mast, father: 11, modifications: changes, addedObjects: "\n" + Added(111, Mast, 71))
            + StandIn(4, 600, 101, Mast, 500) + StandIn(4, 610, 111, Mast, 500)
            + Object(70, "Flag", father: 610)
            + Instance(501, Fleet, modifications: "\n" + Change(101, Mast, "m_LocalPosition.y", "9"),
                removedComponents: "\n    - " + Asset(223, Fleet) + "\n",
                removedObjects: "\n    - " + Asset(110, Mast) + "\n"),
            11, 31, 501), 0x20);
    }

    string PathOf(string path) => Path.Combine(_project.Root, path);

    static T Pick<T>(IReadOnlyList<T> items, Random random) => items[random.Next(items.Count)];
}
