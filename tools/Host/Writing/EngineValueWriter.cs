using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Structs of the engine and of Unity.Mathematics, in the form that <see cref="EngineValues"/> reads.
/// </summary>
internal static class EngineValueWriter
{
    /// <summary>A struct written in one line; null for structs of several lines.</summary>
    internal static string Line(object value) => value switch
    {
        Vector2 v => Line("xy", v.x, v.y),
        Vector3 v => Line("xyz", v.x, v.y, v.z),
        Vector4 v => Line("xyzw", v.x, v.y, v.z, v.w),
        Quaternion q => Line("xyzw", q.x, q.y, q.z, q.w),
        Color c => Line("rgba", c.r, c.g, c.b, c.a),
        Vector2Int v => $"{{x: {v.x}, y: {v.y}}}",
        Vector3Int v => $"{{x: {v.x}, y: {v.y}, z: {v.z}}}",
        _ => null,
    };

    /// <summary>
    /// Writes a struct of several lines; false for a struct whose fields are written with their names.
    /// </summary>
    internal static bool Write(YamlWriter yaml, object value)
    {
        switch (value)
        {
            case LayerMask mask:
                yaml.Field("serializedVersion", 2);
                yaml.Field("m_Bits", (uint)mask.value);
                return true;
            case Rect rect:
                yaml.Field("serializedVersion", 2);
                yaml.Field("x", ScalarText.Of(rect.x));
                yaml.Field("y", ScalarText.Of(rect.y));
                yaml.Field("width", ScalarText.Of(rect.width));
                yaml.Field("height", ScalarText.Of(rect.height));
                return true;
            case Color32 colour:
                yaml.Field("serializedVersion", 2);
                yaml.Field("rgba", (uint)(colour.r | colour.g << 8 | colour.b << 16 | colour.a << 24));
                return true;
            case Bounds box:
                Box(yaml, box);
                return true;
            case Matrix4x4 matrix:
                for (int entry = 0; entry < 16; entry++)
                    yaml.Field($"e{entry / 4}{entry % 4}", ScalarText.Of(matrix[entry / 4, entry % 4]));
                return true;
            default:
                return false;
        }
    }

    internal static void Box(YamlWriter yaml, Bounds box)
    {
        yaml.Field("m_Center", Line(box.center));
        yaml.Field("m_Extent", Line(box.extents));
    }

    /// <summary>The fields of any other struct of Unity.Mathematics. All are public.</summary>
    internal static IEnumerable<FieldInfo> Fields(Type type) =>
        ScriptReflection.Fields(type, BindingFlags.Instance | BindingFlags.Public);

    static string Line(string names, params float[] values) =>
        "{" + string.Join(", ", values.Select((value, index) => $"{names[index]}: {ScalarText.Of(value)}")) + "}";
}
