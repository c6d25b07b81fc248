namespace Glint.Host;

/// <summary>Order and values are those of UnityEditor.PlayModeStateChange.</summary>
internal enum PlayModeStep
{
    EnteredEditMode,
    ExitingEditMode,
    EnteredPlayMode,
    ExitingPlayMode,
}
