using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// An object's fields by their names in a file. Here only whether scripts may read a mesh; null for others.
/// </summary>
public class SerializedObject : IDisposable
{
    SerializedProperty _readable;

    public SerializedObject(Object obj) => targetObject = obj;

    public Object targetObject { get; }

    public SerializedProperty FindProperty(string propertyPath) => targetObject is Mesh mesh
        && propertyPath == "m_IsReadable"
        ? _readable ??= new SerializedProperty { boolValue = mesh.isReadable } : null;

    /// <summary>Writes what was set, so that it can be undone; false if nothing was.</summary>
    public bool ApplyModifiedProperties()
    {
        if (targetObject is not Mesh mesh || _readable is null || _readable.boolValue == mesh.isReadable)
            return false;
        Undo.RecordObject(mesh, "Modified Property in " + mesh.name);
        mesh.Contents.IsReadable = _readable.boolValue;
        EditorUtility.SetDirty(mesh);
        return true;
    }

    public void Dispose()
    {
    }
}

public class SerializedProperty
{
    internal SerializedProperty()
    {
    }

    public bool boolValue { get; set; }
}
