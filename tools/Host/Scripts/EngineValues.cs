using System;
using System.Reflection;
using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// Structs of the engine and of Unity.Mathematics. Most are written with the names of their fields, some with other
/// names.
/// </summary>
internal static class EngineValues
{
    /// <param name="current">Present value of the field, with its type. Absent keys leave their part
    /// unchanged.</param>
    internal static object Read(FieldMap fields, object current,
        Func<YamlNode, Type, object, string, object> readMember) => current switch
        {
            LayerMask mask => (LayerMask)fields.Bits("m_Bits", mask),
            Rect rect => Rect(fields, rect),
            Bounds box => new Bounds(Vector(fields.Map("m_Center"), box.center),
                Vector(fields.Map("m_Extent"), box.extents) * 2f),
            Color32 colour => fields.Has("rgba") ? Color32(fields.Bits("rgba", 0)) : colour,
            _ => ByName(fields, current, readMember),
        };

    internal static Vector3 Vector(FieldMap fields, Vector3 absent = default) =>
        new(fields.Number("x", absent.x), fields.Number("y", absent.y), fields.Number("z", absent.z));

    internal static Quaternion Rotation(FieldMap fields) =>
        new(fields.Number("x"), fields.Number("y"), fields.Number("z"), fields.Number("w", 1f));

    internal static Rect Rect(FieldMap fields, Rect absent) =>
        new(fields.Number("x", absent.x), fields.Number("y", absent.y), fields.Number("width", absent.width),
            fields.Number("height", absent.height));

    static Color32 Color32(int rgba) => new((byte)rgba, (byte)(rgba >> 8), (byte)(rgba >> 16), (byte)(rgba >> 24));

    static object ByName(FieldMap fields, object value, Func<YamlNode, Type, object, string, object> readMember)
    {
        Type type = value.GetType();
        foreach ((YamlNode keyNode, YamlNode node) in fields.Node.Children)
        {
            if (keyNode is not YamlScalarNode { Value: { Length: > 0 } key })
                continue;
            if (ScriptReflection.Field(type, MemberName(type, key)) is FieldInfo { IsInitOnly: false } field)
                field.SetValue(value, readMember(node, field.FieldType, field.GetValue(value), key));
            else if (ScriptReflection.Property(type, key) is { CanRead: true, CanWrite: true } property)
                property.SetValue(value, readMember(node, property.PropertyType, property.GetValue(value), key));
        }
        return value;
    }

    // e12 is row 1, column 2.
    static string MemberName(Type type, string key) =>
        type == typeof(Matrix4x4) && key[0] == 'e' ? "m" + key[1..] : key;
}
