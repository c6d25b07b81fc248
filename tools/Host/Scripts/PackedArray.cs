using System;
using System.Collections.Generic;
using System.Linq;
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

    /// <summary>Null when the text is none of such bytes, or holds no whole number of elements.</summary>
    internal static List<long> Decode(YamlNode node, int width)
    {
        string hex = PackedOverrides.IsOne(node) ? PackedOverrides.Hex((YamlMappingNode)node) : ((YamlScalarNode)node).Value ?? "";
        if (hex.Length % (2 * width) != 0 || !hex.All(char.IsAsciiHexDigit))
            return null;
        byte[] bytes = Convert.FromHexString(hex);
        List<long> values = new(bytes.Length / width);
        for (int start = 0; start < bytes.Length; start += width)
            values.Add(Element(bytes.AsSpan(start, width)));
        return !PackedOverrides.IsOne(node) || Apply(PackedOverrides.Edits((YamlMappingNode)node), values) ? values : null;
    }

    static long Element(ReadOnlySpan<byte> bytes) => bytes.Length switch
    {
        1 => bytes[0],
        2 => BitConverter.ToInt16(bytes),
        4 => BitConverter.ToInt32(bytes),
        _ => BitConverter.ToInt64(bytes),
    };

    static bool Apply(IEnumerable<(int Index, string Value)> edits, List<long> values)
    {
        foreach ((int index, string text) in edits)
        {
            if (!Scalars.TryInteger(text, out long value))
                return false;
            if (index < 0)
                Resize(values, (int)value);
            else if (index < values.Count)
                values[index] = value;
        }
        return true;
    }

    static void Resize(List<long> values, int size)
    {
        long last = values.Count > 0 ? values[^1] : 0;
        if (size < values.Count)
            values.RemoveRange(size, values.Count - size);
        values.AddRange(Enumerable.Repeat(last, size - values.Count));
    }
}
