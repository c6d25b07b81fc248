using System;
using UnityEngine.UIElements;
using Object = UnityEngine.Object;

namespace UnityEditor.UIElements;

/// <summary>Names its serialized field without showing a value.</summary>
public class PropertyField : VisualElement
{
    public string bindingPath { get; set; }

    public string label { get; set; }
}

public class ObjectField : BaseField<Object>
{
    public ObjectField(string label)
        : base(label)
    {
    }

    public Type objectType { get; set; }

    public bool allowSceneObjects { get; set; }
}

public static class BindingExtensions
{
    /// <summary>Serialized values are not tracked: a test raises ObjectChangeEvents instead.</summary>
    public static void TrackSerializedObjectValue(
        this VisualElement element, SerializedObject obj, Action<SerializedObject> callback = null)
    {
    }
}
