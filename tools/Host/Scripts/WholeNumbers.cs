using System;

namespace Glint.Host;

/// <summary>
/// The integer types of C# that a script's field may have: their range, and a number as an object of the type.
/// </summary>
internal static class WholeNumbers
{
    /// <summary>
    /// Range of a field's values. Unity has written 32-bit flags both as signed and as unsigned numbers.
    /// </summary>
    internal static (Int128 Min, Int128 Max) Range(Type type) => type.IsEnum
        && PackedArray.Width(type) == sizeof(int)
        ? (int.MinValue, uint.MaxValue)
        : Type.GetTypeCode(type) switch
        {
            TypeCode.Byte => (byte.MinValue, byte.MaxValue),
            TypeCode.SByte => (sbyte.MinValue, sbyte.MaxValue),
            TypeCode.Int16 => (short.MinValue, short.MaxValue),
            TypeCode.UInt16 or TypeCode.Char => (ushort.MinValue, ushort.MaxValue),
            TypeCode.Int32 => (int.MinValue, int.MaxValue),
            TypeCode.UInt32 => (uint.MinValue, uint.MaxValue),
            TypeCode.UInt64 => (ulong.MinValue, ulong.MaxValue),
            _ => (long.MinValue, long.MaxValue),
        };

    /// <param name="value">Within the range of the type.</param>
    internal static object Make(Int128 value, Type type)
    {
        unchecked
        {
            if (type.IsEnum)
                return Enum.ToObject(type, (long)value);
            return Type.GetTypeCode(type) switch
            {
                TypeCode.Boolean => value != 0,
                TypeCode.Byte => (byte)value,
                TypeCode.SByte => (sbyte)value,
                TypeCode.Int16 => (short)value,
                TypeCode.UInt16 => (ushort)value,
                TypeCode.Char => (char)(ushort)value,
                TypeCode.Int32 => (int)value,
                TypeCode.UInt32 => (uint)value,
                TypeCode.UInt64 => (ulong)value,
                _ => (object)(long)value,
            };
        }
    }
}
