using System;
using System.Buffers.Binary;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>Arrays of whole numbers, which Unity writes as one text of little-endian hexadecimal bytes.</summary>
internal static class PackedArray
{
    /// <summary>Bytes of an element; 0 for types that are written item by item.</summary>
    internal static int Width(Type element)
    {
        if (element.IsEnum)
            element = Enum.GetUnderlyingType(element);
        return Type.GetTypeCode(element) switch
        {
            TypeCode.Boolean or TypeCode.Byte or TypeCode.SByte => 1,
            TypeCode.Int16 or TypeCode.UInt16 or TypeCode.Char => 2,
            TypeCode.Int32 or TypeCode.UInt32 => 4,
            TypeCode.Int64 or TypeCode.UInt64 => 8,
            _ => 0,
        };
    }

    /// <summary>
    /// Null if the text is not hexadecimal or does not have a whole number of elements. Values of overrides are as
    /// written.
    /// </summary>
    internal static List<Int128> Decode(YamlNode node, Type element)
    {
        int width = Width(element);
        string hex = PackedOverrides.IsOne(node)
            ? PackedOverrides.Hex((YamlMappingNode)node)
            : ((YamlScalarNode)node).Value ?? "";
        if (hex is null || hex.Length % (2 * width) != 0 || !hex.All(char.IsAsciiHexDigit))
            return null;
        byte[] bytes = Convert.FromHexString(hex);
        List<Int128> values = new(bytes.Length / width);
        for (int start = 0; start < bytes.Length; start += width)
            values.Add(Element(bytes.AsSpan(start, width), Type.GetTypeCode(element)));
        return !PackedOverrides.IsOne(node)
            || Apply(PackedOverrides.Edits((YamlMappingNode)node), values) ? values : null;
    }

    /// <summary>The hexadecimal bytes of a list, which may be null.</summary>
    internal static string Encode(IList list, Type element)
    {
        StringBuilder hex = new();
        int width = Width(element);
        Span<byte> bytes = stackalloc byte[sizeof(long)];
        for (int index = 0; index < (list?.Count ?? 0); index++)
        {
            BinaryPrimitives.WriteInt64LittleEndian(bytes, unchecked((long)Whole(list[index], element)));
            hex.Append(Convert.ToHexStringLower(bytes[..width]));
        }
        return hex.ToString();
    }

    /// <summary>A whole number, enum, bool or character as a number.</summary>
    internal static Int128 Whole(object value, Type type) => Type.GetTypeCode(type) switch
    {
        TypeCode.Boolean => (bool)value ? 1 : 0,
        TypeCode.Char => (char)value,
        TypeCode.UInt64 => Convert.ToUInt64(value),
        _ => Convert.ToInt64(value),
    };

    static Int128 Element(ReadOnlySpan<byte> bytes, TypeCode type) => type switch
    {
        TypeCode.SByte => (sbyte)bytes[0],
        TypeCode.Int16 => BitConverter.ToInt16(bytes),
        TypeCode.UInt16 or TypeCode.Char => BitConverter.ToUInt16(bytes),
        TypeCode.Int32 => BitConverter.ToInt32(bytes),
        TypeCode.UInt32 => BitConverter.ToUInt32(bytes),
        TypeCode.Int64 => BitConverter.ToInt64(bytes),
        TypeCode.UInt64 => BitConverter.ToUInt64(bytes),
        _ => bytes[0],
    };

    static bool Apply(IEnumerable<(int Index, string Value)> edits, List<Int128> values)
    {
        foreach ((int index, string text) in edits)
        {
            if (!Scalars.TryInteger(text, out Int128 value)
                || index < 0 && (value < 0 || value > PropertyOverride.LargestArray))
                return false;
            if (index < 0)
                Resize(values, (int)value);
            else if (index < values.Count)
                values[index] = value;
        }
        return true;
    }

    static void Resize(List<Int128> values, int size)
    {
        Int128 last = values.Count > 0 ? values[^1] : 0;
        if (size < values.Count)
            values.RemoveRange(size, values.Count - size);
        values.AddRange(Enumerable.Repeat(last, size - values.Count));
    }
}
