using System;
using System.Linq;
using System.Reflection;
using Glint.Host;
using UnityEngine;
using UnityEngine.UIElements;
using Object = UnityEngine.Object;

namespace UnityEditor;

public sealed class CanEditMultipleObjects : Attribute;

public class CustomEditor : Attribute
{
    public CustomEditor(Type inspectedType) => InspectedType = inspectedType;

    internal Type InspectedType { get; }
}

/// <summary>An inspector; a test creates one and examines its tree.</summary>
public class Editor : ScriptableObject
{
    SerializedObject _serialized;

    public Object target { get => targets[0]; set => targets[0] = value; }

    public Object[] targets { get; private set; } = new Object[1];

    public SerializedObject serializedObject => _serialized ??= new SerializedObject(target);

    public virtual VisualElement CreateInspectorGUI() => null;

    public static Editor CreateEditor(Object targetObject) => CreateEditor(new[] { targetObject });

    /// <summary>Null if no editor is registered for the first object's type.</summary>
    public static Editor CreateEditor(Object[] targetObjects)
    {
        Type inspected = targetObjects[0].GetType();
        Type type = ScriptTypes.All()
            .FirstOrDefault(type => type.GetCustomAttribute<CustomEditor>()?.InspectedType == inspected);
        if (type is null)
            return null;
        var editor = (Editor)Glint.Host.ObjectFactory.NewAsset(type);
        editor.targets = targetObjects;
        editor.Awaken();
        return editor;
    }
}
