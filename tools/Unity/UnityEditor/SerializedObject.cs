using System;
using System.Linq;
using System.Reflection;
using Glint.Host;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// An object's fields by their serialized names. Supports only whether scripts may read a mesh, and the whole numbers
/// and texts of a script; null for others.
/// </summary>
public class SerializedObject : IDisposable
{
    SerializedProperty _readable;
    SerializedProperty _value;
    FieldInfo _valueField;

    public SerializedObject(Object obj) => targetObject = obj;

    public Object targetObject { get; }

    public SerializedProperty FindProperty(string propertyPath) => targetObject is Mesh mesh
        && propertyPath == "m_IsReadable"
        ? _readable ??= new SerializedProperty { boolValue = mesh.isReadable } : FindValue(propertyPath);

    /// <summary>Writes changes as an undo step; false without changes.</summary>
    public bool ApplyModifiedProperties()
    {
        if (_value is not null)
            return ApplyValue();
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
    SerializedProperty FindValue(string path)
    {
        _valueField = SerializedFields.Of(targetObject.GetType()).FirstOrDefault(field => field.Name == path
            && (field.FieldType == typeof(int) || field.FieldType == typeof(string)));
        return _value = _valueField is null
            ? null
            : new SerializedProperty { Value = _valueField.GetValue(targetObject) };
    }

    bool ApplyValue()
    {
        if (Equals(_value.Value, _valueField.GetValue(targetObject)))
            return false;
        Undo.RecordObject(targetObject, "Modified Property in " + targetObject.name);
        _valueField.SetValue(targetObject, _value.Value);
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

    public int intValue { get => (int)Value; set => Value = value; }

    public string stringValue { get => (string)Value; set => Value = value; }

    internal object Value { get; set; }
}
