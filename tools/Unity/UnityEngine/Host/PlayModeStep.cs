namespace Glint.Host;

/// <summary>In the order and with the values of UnityEditor.PlayModeStateChange.</summary>
internal enum PlayModeStep
{
    EnteredEditMode,
    ExitingEditMode,
    EnteredPlayMode,
    ExitingPlayMode,
}
