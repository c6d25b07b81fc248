using System;

namespace UnityEditor;

[Flags]
public enum GizmoType
{
    Pickable = 1,
    NotInSelectionHierarchy = 2,
    Selected = 4,
    Active = 8,
    InSelectionHierarchy = 16,
    NonSelected = 32,
}

public sealed class DrawGizmo : Attribute
{
    public GizmoType drawOptions;

    public DrawGizmo(GizmoType gizmo) => drawOptions = gizmo;
}
