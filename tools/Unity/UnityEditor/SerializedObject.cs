using System;
using System.Linq;
using System.Reflection;
using Glint.Host;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// An object's fields by their serialized names. Supports only whether scripts may read a mesh, and the whole numbers
/// of a script; null for others.
/// </summary>
public class SerializedObject : IDisposable
{
    SerializedProperty _readable;
    SerializedProperty _number;
    FieldInfo _numberField;

    public SerializedObject(Object obj) => targetObject = obj;

    public Object targetObject { get; }

    public SerializedProperty FindProperty(string propertyPath) => targetObject is Mesh mesh
        && propertyPath == "m_IsReadable"
        ? _readable ??= new SerializedProperty { boolValue = mesh.isReadable } : FindNumber(propertyPath);

    /// <summary>Writes changes as an undo step; false without changes.</summary>
    public bool ApplyModifiedProperties()
    {
        if (_number is not null)
            return ApplyNumber();
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

    // One at a time.
    SerializedProperty FindNumber(string path)
    {
        _numberField = SerializedFields.Of(targetObject.GetType())
            .FirstOrDefault(field => field.Name == path && field.FieldType == typeof(int));
        return _number = _numberField is null
            ? null
            : new SerializedProperty { intValue = (int)_numberField.GetValue(targetObject) };
    }

    bool ApplyNumber()
    {
        if (_number.intValue == (int)_numberField.GetValue(targetObject))
            return false;
        Undo.RecordObject(targetObject, "Modified Property in " + targetObject.name);
        _numberField.SetValue(targetObject, _number.intValue);
        Messages.Call(targetObject, "OnValidate");
        EditorUtility.SetDirty(targetObject);
        return true;
    }
}

public class SerializedProperty
{
    internal SerializedProperty()
    {
    }

    public bool boolValue { get; set; }

    public int intValue { get; set; }
}
