using System;
using System.Reflection;
using UnityEngine;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>Structs of the engine and of Unity.Mathematics. Most are written by the names of their fields, some by names of their own.</summary>
internal static class EngineValues
{
    const BindingFlags AnyInstance = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    internal static object Read(FieldMap fields, Type type, Func<YamlNode, Type, string, object> readMember)
    {
        if (type == typeof(LayerMask))
            return (LayerMask)unchecked((int)fields.Integer("m_Bits"));
        if (type == typeof(Rect))
            return Rect(fields);
        if (type == typeof(Bounds))
            return new Bounds(Vector(fields.Map("m_Center")), Vector(fields.Map("m_Extent")) * 2f);
        if (type == typeof(Color32))
            return Color32(fields.Integer("rgba"));
        return ByName(fields, type, readMember);
    }

    internal static Vector3 Vector(FieldMap fields, float absent = 0f) =>
        new(fields.Number("x", absent), fields.Number("y", absent), fields.Number("z", absent));

    internal static Quaternion Rotation(FieldMap fields) =>
        new(fields.Number("x"), fields.Number("y"), fields.Number("z"), fields.Number("w", 1f));

    internal static Rect Rect(FieldMap fields) => new(fields.Number("x"), fields.Number("y"), fields.Number("width"), fields.Number("height"));

    static Color32 Color32(long rgba) => new((byte)rgba, (byte)(rgba >> 8), (byte)(rgba >> 16), (byte)(rgba >> 24));

    static object ByName(FieldMap fields, Type type, Func<YamlNode, Type, string, object> readMember)
    {
        object value = Activator.CreateInstance(type);
        foreach ((YamlNode keyNode, YamlNode node) in fields.Node.Children)
        {
            if (keyNode is not YamlScalarNode { Value: { Length: > 0 } key })
                continue;
            if (type.GetField(MemberName(type, key), AnyInstance) is FieldInfo { IsInitOnly: false } field)
                field.SetValue(value, readMember(node, field.FieldType, key));
            else if (type.GetProperty(key, AnyInstance, null, null, Type.EmptyTypes, null) is { CanWrite: true } property)
                property.SetValue(value, readMember(node, property.PropertyType, key));
        }
        return value;
    }

    // e12 is row 1, column 2.
    static string MemberName(Type type, string key) => type == typeof(Matrix4x4) && key[0] == 'e' ? "m" + key[1..] : key;
}
