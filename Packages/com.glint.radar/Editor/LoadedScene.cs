using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// The radar and target of a command, from a scene of the project, a mesh file, or the built-in scene.
    /// </summary>
    public sealed class LoadedScene
    {
        /// <summary>Name of the scene or mesh file without folder and extension.</summary>
        public string Name { get; private set; }

        /// <summary>Asset path of the scene, or path of the mesh file as given; null for the built-in scene.</summary>
        public string Scene { get; private set; }

        /// <summary>The radar to trace.</summary>
        public RadarController Radar { get; private set; }

        /// <summary>The object that a sweep turns, or about which it moves the radar; null if none is given.</summary>
        public Transform Target { get; private set; }

        /// <summary>The sea whose snapshots a sweep shows; null if none are swept.</summary>
        public Sea Sea { get; private set; }

        /// <summary>Orbit of the radar of a mesh file; null with a scene.</summary>
        public RadarOrbit Orbit { get; private set; }

        /// <summary>Opens the input of a command line.</summary>
        /// <exception cref="GlintException">It does not exist, or has no radar or no such target.</exception>
        public static LoadedScene Open(CommandLine line)
        {
            switch (line.InputKind)
            {
                case InputKind.Scene: return OpenScene(line);
                case InputKind.BuiltIn: return MakeBuiltIn(line);
                default: return OpenMeshFile(line);
            }
        }

        /// <summary>A sweep through the poses of a plan.</summary>
        public SweepSetup Sweep(SweepPlan plan) =>
            new SweepSetup(Radar, plan) { Target = Target, Sea = Sea, Orbit = Orbit, Scene = Scene };

        /// <summary>The open scene.</summary>
        public static LoadedScene InOpenScene(RadarController radar, Transform target, Sea sea)
        {
            string scene = radar.gameObject.scene.path;
            return new LoadedScene
            {
                Name = Path.GetFileNameWithoutExtension(scene), Scene = scene, Radar = radar, Target = target, Sea = sea
            };
        }

        /// <summary>
        /// Updates the seas of the open scenes. A sea that cannot be shown is only logged in the editor; here it is an
        /// error.
        /// </summary>
        /// <exception cref="GlintException">A sea cannot be shown.</exception>
        public static void RebuildSeas()
        {
            foreach (var sea in SceneSearch.FindEnabled<Sea>())
                sea.Rebuild();
        }

        /// <summary>Opens a scene of the project; returns its asset path.</summary>
        /// <exception cref="GlintException">There is no such scene, or one of its seas cannot be shown.</exception>
        internal static string OpenSceneFile(string input)
        {
            var paths = new ProjectPaths(Path.GetDirectoryName(Application.dataPath));
            var readings = paths.Readings(input, Directory.GetCurrentDirectory());
            if (!readings.Any(File.Exists) && readings.FirstOrDefault(Directory.Exists) is string folder)
                throw new GlintException($"{input}: {folder} is a folder: give a scene in it");
            if (!readings.Any(File.Exists))
                throw new GlintException($"{input}: there is no such scene; "
                    + $"it was looked for at {string.Join(" and ", readings)}");
            string scene = paths.ToAssetPath(input, Directory.GetCurrentDirectory());
            EditorSceneManager.OpenScene(scene, OpenSceneMode.Single);
            RebuildSeas();
            return scene;
        }

        /// <summary>Opens a new scene that has only the mesh of a file.</summary>
        /// <exception cref="GlintException">The file cannot be read.</exception>
        internal static MeshFile OpenMeshFileAlone(CommandLine line)
        {
            var file = ReadMeshFile(line);
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
            MeshFileScene.MakeObject(file);
            return file;
        }

        static LoadedScene OpenScene(CommandLine line)
        {
            OpenSceneFile(line.Input);
            if (line.IsGiven(Options.Clutter))
                SceneClutter.Set(line.Get(Options.Clutter), line.Input);
            var radar = SceneSearch.FindRadar(line.Input);
            if (line.IsGiven(Options.Size) && radar.IsFitted)
                throw new GlintException($"{line.Input}: its radar fits its aperture to the scene by Ray Spacing, "
                    + $"so {Options.Size.Flag} has no effect: leave it out, or clear Fit Aperture of '{radar.name}'");
            radar.Settings = Override(radar.Settings, line);
            // A scene that was stored before there were tubes has no kernels of them.
            if (radar.TubeKernel == null)
                radar.TubeKernel = ProjectAssets.TubeKernel;
            if (radar.ClutterKernel == null)
                radar.ClutterKernel = ProjectAssets.TubesKernel;
            if (line.IsGiven(Options.Receiver))
            {
                var size = line.Get(Options.Receiver);
                radar.ReceiverSize = new Vector2((float)size.x, (float)size.y);
            }
            var target = line.IsGiven(Options.Target) ? FindTarget(line.Input, line.Get(Options.Target)) : null;
            if (target != null && line.IsGiven(Options.Angles) && !MovesAnything(target))
                Debug.LogWarning($"{line.Input}: --target '{PathOf(target)}' has no mesh, sea or radar at or below it: "
                    + "turning it changes nothing; name the object that holds the target's meshes");
            var sea = line.IsGiven(Options.Snapshots) ? SceneSearch.FindSea(line.Input) : null;
            return InOpenScene(radar, target, sea);
        }

        static LoadedScene OpenMeshFile(CommandLine line) => Show(ReadMeshFile(line), line);

        static MeshFile ReadMeshFile(CommandLine line)
        {
            var file = MeshFileReader.Read(line.Input, line.Get(Options.Unit), line.Get(Options.Up));
            int flat = file.CountDegenerate();
            if (flat > 0)
                Debug.LogWarning($"{line.Input}: {flat} of {file.TriangleCount} triangles have no area; "
                    + "they reflect nothing");
            return file;
        }

        // Mesh options are refused: their defaults are the published experiment's camera.
        static LoadedScene MakeBuiltIn(CommandLine line)
        {
            var made =
                new SeaAndShip(line.Get(Options.Seed), line.Get(Options.SeaTriangles), line.Get(Options.ShipTriangles));
            var loaded = Show(new MeshFile("Ship", made.Ship.Vertices, made.Ship.Indices), line);
            MeshFileScene.MakeObject(new MeshFile("Sea", made.Sea.Vertices, made.Sea.Indices));
            return new LoadedScene { Name = "sea and ship", Radar = loaded.Radar, Target = loaded.Target };
        }

        // A new scene with only the mesh and a radar before it.
        static LoadedScene Show(MeshFile file, CommandLine line)
        {
            EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
            var placement = new RadarPlacement
            {
                Aim = line.Get(Options.Aim),
                Distance = line.Get(Options.Distances)?[0] ?? line.Get(Options.Distance),
                GrazingDegrees = line.Get(Options.GrazingAngles)?[0] ?? line.Get(Options.Grazing),
                AzimuthDegrees = line.Get(Options.Azimuth),
                VerticalFovDegrees = line.Get(Options.Fov),
                RaySpacing = line.Get(Options.Spacing),
                ApertureSize = line.Get(Options.Aperture),
            };
            // The receiver of parallel rays is their aperture, unless another is given.
            if (!line.IsGiven(Options.Spacing) || line.IsGiven(Options.Receiver))
                placement.ReceiverSize = line.Get(Options.Receiver);
            var scene =
                MeshFileScene.Create(file, placement, Override(RadarSettings.Default, line), ProjectAssets.Kernel);
            (scene.Radar.TubeKernel, scene.Radar.ClutterKernel) = (ProjectAssets.TubeKernel, ProjectAssets.TubesKernel);
            return new LoadedScene
            {
                Name = file.Name, Scene = line.Input, Radar = scene.Radar, Target = scene.Target, Orbit = scene.Orbit
            };
        }

        // Options that are not given keep the scene's settings, or the defaults, which are also those of the options.
        static RadarSettings Override(RadarSettings settings, CommandLine line)
        {
            if (line.IsGiven(Options.Size))
                (settings.RaysAcross, settings.RaysDown) = (line.Get(Options.Size).x, line.Get(Options.Size).y);
            if (line.IsGiven(Options.Region))
                settings.Region = line.Get(Options.Region);
            if (line.IsGiven(Options.Frequency))
                settings.FrequencyHz = line.Get(Options.Frequency);
            if (line.IsGiven(Options.Bounces))
                settings.MaxBounces = line.Get(Options.Bounces);
            if (line.IsGiven(Options.Tolerance))
                settings.ToleranceDb = line.Get(Options.Tolerance);
            settings.SkipSamplingError |= line.Get(Options.NoSamplingError);
            return settings;
        }

        static bool MovesAnything(Transform target) => target.GetComponentInChildren<MeshFilter>() != null
            || target.GetComponentInChildren<Sea>() != null || target.GetComponentInChildren<RadarController>() != null;

        static Transform FindTarget(string scene, string name)
        {
            var all = Object.FindObjectsByType<Transform>(FindObjectsInactive.Include, FindObjectsSortMode.None);
            var fitting = all.Where(candidate => candidate.name == name || PathOf(candidate) == name).ToArray();
            var named = fitting.Where(candidate => candidate.gameObject.activeInHierarchy).ToArray();
            if (named.Length == 1)
                return named[0];
            if (named.Length > 1)
                throw new GlintException($"{scene}: --target \"{name}\" fits {named.Length} objects, {Quoted(named)}; "
                    + "give the path of one, or rename them");
            if (fitting.Length > 0)
                throw new GlintException($"{scene}: the object \"{name}\" for --target is inactive; activate it");
            throw new GlintException($"{scene}: has no object \"{name}\" for --target; "
                + $"at its root are {Quoted(all.Where(candidate => candidate.parent == null).ToArray())}");
        }

        static string Quoted(Component[] components)
        {
            const int shown = 8;
            string names = string.Join(", ", components.Select(component => $"'{PathOf(component.transform)}'")
                .OrderBy(path => path, System.StringComparer.Ordinal).Take(shown));
            return components.Length > shown ? $"{names} and {components.Length - shown} more" : names;
        }

        /// <summary>Path from the root, as in --target: Fleet/Ship.</summary>
        public static string PathOf(Transform transform) =>
            transform.parent == null ? transform.name : $"{PathOf(transform.parent)}/{transform.name}";
    }
}
