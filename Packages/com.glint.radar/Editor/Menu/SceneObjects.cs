using System.Linq;
using Glint.Core;
using Glint.Reference;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// New objects of the menu GameObject > Glint, made by code without further assets. Each is one step of Undo and
    /// gets selected. Without a parent they are where Unity puts its own: below the scene's default parent, else at the
    /// Scene view's pivot.
    /// </summary>
    static class SceneObjects
    {
        // Distance in radii of the target's sphere, at which the sphere fills two thirds of a view of 60 degrees.
        const double RadiiAway = 3;

        // The radar's camera is not a view of the scene: other cameras draw over it.
        const float DrawnFirst = -10;

        // Metres, as IMO MSC.192(79) assumes.
        const float MastHeight = 15;

        /// <summary>
        /// A radar with its receiver and its ray paths. It looks down on an object at the angle of the published
        /// experiment, from a distance at which the whole object is visible. Without an object it has the pose of the
        /// published experiment and looks at where another new object would be.
        /// </summary>
        /// <param name="target">May be null.</param>
        public static RadarController MakeRadar(GameObject target)
        {
            var camera = new GameObject("Radar").AddComponent<Camera>();
            camera.depth = DrawnFirst;
            var radar = camera.gameObject.AddComponent<RadarController>();
            radar.Kernel = ProjectAssets.Kernel;
            radar.TubeKernel = ProjectAssets.TubeKernel;
            radar.ClutterKernel = ProjectAssets.TubesKernel;
            radar.Receiver = MeshFileScene.MakeReceiver(camera.transform, false);
            radar.gameObject.AddComponent<RayPaths>();
            AddToScene(radar.gameObject, null);
            var (centre, distance) = target != null ? SphereAround(target)
                : (camera.transform.position, CornerReflector.Distance);
            camera.transform.rotation = Quaternion.Euler((float)AccuracyScene.PublishedGrazingDegrees, 0, 0);
            camera.transform.position = centre - (float)distance * camera.transform.forward;
            return radar;
        }

        /// <summary>A cross section of an object, or of the scene if there is none.</summary>
        /// <param name="target">May be null.</param>
        public static RadarCrossSection MakeCrossSection(GameObject target)
        {
            var made = new GameObject("Cross Section").AddComponent<RadarCrossSection>();
            made.Kernel = ProjectAssets.TubesKernel;
            made.Target = target != null ? target.transform : null;
            AddToScene(made.gameObject, null);
            return made;
        }

        /// <summary>A radar screen with its picture over the game view, on the mast of a ship.</summary>
        /// <param name="ship">May be null.</param>
        public static RadarScreen MakeScreen(GameObject ship)
        {
            var screen = new GameObject("Radar Screen").AddComponent<RadarScreen>();
            (screen.Kernel, screen.SeaKernel) = (ProjectAssets.ScreenKernel, ProjectAssets.SeaKernel);
            screen.gameObject.AddComponent<RadarScreenOverlay>();
            AddToScene(screen.gameObject, ship);
            var mast = screen.transform;
            mast.localPosition = new Vector3(mast.localPosition.x, MastHeight, mast.localPosition.z);
            screen.OwnShip = ship != null ? ship.transform : null;
            return screen;
        }

        /// <summary>
        /// The corner reflector of the published experiment, open towards -Z, about its turning point.
        /// </summary>
        /// <param name="parent">May be null.</param>
        public static GameObject MakeCornerReflector(GameObject parent)
        {
            var reflector = CornerReflectorAssets.MakeReflector();
            AddToScene(reflector, parent);
            return reflector;
        }

        /// <summary>A sea of the standard waves with clutter, without stored snapshots.</summary>
        /// <param name="parent">May be null.</param>
        public static Sea MakeSea(GameObject parent)
        {
            var sea = new GameObject("Sea").AddComponent<Sea>();
            sea.Material = ProjectAssets.StandardMaterial;
            sea.Clutter = SeaClutterSettings.On;
            AddToScene(sea.gameObject, parent);
            PutAtSeaLevel(sea.transform);
            sea.Rebuild();
            return sea;
        }

        /// <summary>The standard ship. Its mesh is stored with the scene.</summary>
        /// <param name="parent">May be null.</param>
        public static Ship MakeShip(GameObject parent)
        {
            var ship = new GameObject("Ship").AddComponent<Ship>();
            ProjectAssets.Show(ship.gameObject, ShipFigures.Make(ship.Settings));
            AddToScene(ship.gameObject, parent);
            PutAtSeaLevel(ship.transform);
            return ship;
        }

        static void AddToScene(GameObject made, GameObject parent) => Fix.AsOneStep($"Create {made.name}", () =>
        {
            Undo.RegisterCreatedObjectUndo(made, $"Create {made.name}");
            ObjectFactory.PlaceGameObject(made, parent); // also names and selects it
            foreach (var part in made.GetComponentsInChildren<Transform>(true))
                part.gameObject.layer = made.layer;
        });

        // The Scene view's pivot is at any height.
        static void PutAtSeaLevel(Transform made) =>
            made.localPosition = new Vector3(made.localPosition.x, 0, made.localPosition.z);

        // Centre of an object and a distance from which it is visible.
        static (Vector3 centre, double distance) SphereAround(GameObject target)
        {
            var boxes = target.GetComponentsInChildren<Renderer>().Select(renderer => renderer.bounds).ToArray();
            if (boxes.Length == 0)
                return (target.transform.position, CornerReflector.Distance);
            var box = boxes[0];
            foreach (var other in boxes)
                box.Encapsulate(other);
            double radius = box.extents.magnitude;
            return (box.center, radius > 0 ? RadiiAway * radius : CornerReflector.Distance);
        }
    }

    /// <summary>The menu GameObject > Glint.</summary>
    static class GlintMenu
    {
        const string Folder = "GameObject/Glint/";
        const int Priority = 10; // among the entries that make objects

        [MenuItem(Folder + "Radar", false, Priority)]
        static void MakeRadar(MenuCommand command)
        {
            // Unity calls once for each selected object.
            if (command.context == null || command.context == Selection.activeGameObject)
                SceneObjects.MakeRadar(command.context as GameObject);
        }

        [MenuItem(Folder + "Cross section", false, Priority)]
        static void MakeCrossSection(MenuCommand command)
        {
            if (command.context == null || command.context == Selection.activeGameObject)
                SceneObjects.MakeCrossSection(command.context as GameObject);
        }

        [MenuItem(Folder + "Radar screen", false, Priority)]
        static void MakeScreen(MenuCommand command) => SceneObjects.MakeScreen(command.context as GameObject);

        [MenuItem(Folder + "Corner reflector", false, Priority)]
        static void MakeCornerReflector(MenuCommand command) =>
            SceneObjects.MakeCornerReflector(command.context as GameObject);

        [MenuItem(Folder + "Sea", false, Priority)]
        static void MakeSea(MenuCommand command) => SceneObjects.MakeSea(command.context as GameObject);

        [MenuItem(Folder + "Ship", false, Priority)]
        static void MakeShip(MenuCommand command) => SceneObjects.MakeShip(command.context as GameObject);
    }
}
