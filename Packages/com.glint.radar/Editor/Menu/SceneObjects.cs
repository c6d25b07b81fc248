using System.Linq;
using Glint.Reference;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// New objects of the menu GameObject > Glint, made by code without further assets. Each is one step of Undo and
    /// gets selected.
    /// </summary>
    static class SceneObjects
    {
        // Distance in radii of the target's sphere, at which the sphere fills two thirds of a view of 60 degrees.
        const double RadiiAway = 3;

        // The radar's camera is not a view of the scene: other cameras draw over it.
        const float DrawnFirst = -10;

        /// <summary>
        /// A radar with its receiver and its ray paths. It looks down on an object at the angle of the published
        /// experiment, from a distance at which the whole object is visible. Without an object it has the pose of the
        /// published experiment and looks at the world's origin.
        /// </summary>
        /// <param name="target">May be null.</param>
        public static RadarController MakeRadar(GameObject target)
        {
            var camera = new GameObject("Radar").AddComponent<Camera>();
            camera.depth = DrawnFirst;
            var radar = camera.gameObject.AddComponent<RadarController>();
            radar.Kernel = ProjectAssets.Kernel;
            radar.Receiver = MeshFileScene.MakeReceiver(camera.transform, false);
            radar.gameObject.AddComponent<RayPaths>();
            FindTarget(target, out var centre, out double distance);
            camera.transform.rotation = Quaternion.Euler((float)AccuracyScene.PublishedGrazingDegrees, 0, 0);
            camera.transform.position = centre - (float)distance * camera.transform.forward;
            AddToScene(radar.gameObject, null);
            return radar;
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

        /// <summary>A sea of the standard waves, without stored snapshots.</summary>
        /// <param name="parent">May be null.</param>
        public static Sea MakeSea(GameObject parent)
        {
            var sea = new GameObject("Sea").AddComponent<Sea>();
            sea.Material = ProjectAssets.StandardMaterial;
            AddToScene(sea.gameObject, parent);
            sea.Rebuild();
            return sea;
        }

        /// <summary>The standard ship. Its mesh is stored with the scene.</summary>
        /// <param name="parent">May be null.</param>
        public static Ship MakeShip(GameObject parent)
        {
            var ship = new GameObject("Ship", typeof(MeshFilter), typeof(MeshRenderer)).AddComponent<Ship>();
            ProjectAssets.Show(ship.gameObject, ShipFigures.Make(ship.Settings));
            AddToScene(ship.gameObject, parent);
            return ship;
        }

        static void AddToScene(GameObject made, GameObject parent)
        {
            if (parent == null)
                StageUtility.PlaceGameObjectInCurrentStage(made); // the scene, or the prefab that is open
            else
                GameObjectUtility.SetParentAndAlign(made, parent);
            GameObjectUtility.EnsureUniqueNameForSibling(made);
            Fix.AsOneStep($"Create {made.name}", () => Undo.RegisterCreatedObjectUndo(made, $"Create {made.name}"));
            Selection.activeGameObject = made;
        }

        static void FindTarget(GameObject target, out Vector3 centre, out double distance)
        {
            (centre, distance) = (Vector3.zero, CornerReflector.Distance);
            if (target == null)
                return;
            centre = target.transform.position;
            var boxes = target.GetComponentsInChildren<Renderer>().Select(renderer => renderer.bounds).ToArray();
            if (boxes.Length == 0)
                return;
            var box = boxes[0];
            foreach (var other in boxes)
                box.Encapsulate(other);
            centre = box.center;
            if (box.extents.magnitude > 0)
                distance = RadiiAway * box.extents.magnitude;
        }
    }

    /// <summary>The menu GameObject > Glint.</summary>
    static class GlintMenu
    {
        const string Folder = "GameObject/Glint/";
        const int Priority = 10; // among the objects that can be made

        [MenuItem(Folder + "Radar", false, Priority)]
        static void MakeRadar(MenuCommand command)
        {
            // Unity calls once for each selected object.
            if (command.context == null || command.context == Selection.activeGameObject)
                SceneObjects.MakeRadar(command.context as GameObject);
        }

        [MenuItem(Folder + "Corner reflector", false, Priority)]
        static void MakeCornerReflector(MenuCommand command) =>
            SceneObjects.MakeCornerReflector(command.context as GameObject);

        [MenuItem(Folder + "Sea", false, Priority)]
        static void MakeSea(MenuCommand command) => SceneObjects.MakeSea(command.context as GameObject);

        [MenuItem(Folder + "Ship", false, Priority)]
        static void MakeShip(MenuCommand command) => SceneObjects.MakeShip(command.context as GameObject);
    }
}
