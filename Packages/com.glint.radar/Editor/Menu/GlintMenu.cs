using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
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

        [MenuItem(Folder + "Corner reflector", false, Priority)]
        static void MakeCornerReflector(MenuCommand command) =>
            SceneObjects.MakeCornerReflector(command.context as GameObject);

        [MenuItem(Folder + "Sea", false, Priority)]
        static void MakeSea(MenuCommand command) => SceneObjects.MakeSea(command.context as GameObject);

        [MenuItem(Folder + "Ship", false, Priority)]
        static void MakeShip(MenuCommand command) => SceneObjects.MakeShip(command.context as GameObject);
    }
}
