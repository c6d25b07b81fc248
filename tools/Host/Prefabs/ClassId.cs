namespace Glint.Host;

/// <summary>Numbers of the classes that the loader knows; objects of other classes are skipped.</summary>
internal static class ClassId
{
    internal const int GameObject = 1;
    internal const int Transform = 4;
    internal const int Camera = 20;
    internal const int Material = 21;
    internal const int MeshRenderer = 23;
    internal const int MeshFilter = 33;
    internal const int Mesh = 43;
    internal const int MonoBehaviour = 114;
    internal const int SkinnedMeshRenderer = 137;
    internal const int LodGroup = 205;
    internal const int Terrain = 218;
    internal const int RectTransform = 224;
    internal const int PrefabInstance = 1001;
    internal const int SceneRoots = 1660057539;

    internal static bool IsTransform(int id) => id is Transform or RectTransform;

    internal static bool IsKnown(int id) =>
        id is GameObject or Transform or Camera or Material or MeshRenderer or MeshFilter or Mesh
        or MonoBehaviour or SkinnedMeshRenderer or LodGroup or Terrain or RectTransform or PrefabInstance or SceneRoots;
}
