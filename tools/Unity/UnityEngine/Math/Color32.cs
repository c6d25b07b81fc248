using System;
using System.Runtime.InteropServices;
using Glint.Host;

namespace UnityEngine;

[Serializable]
[StructLayout(LayoutKind.Explicit)]
public struct Color32 : IEquatable<Color32>, IFormattable
{
    [FieldOffset(0), NonSerialized] int rgba;
    [FieldOffset(0)] public byte r;
    [FieldOffset(1)] public byte g;
    [FieldOffset(2)] public byte b;
    [FieldOffset(3)] public byte a;

    public Color32(byte r, byte g, byte b, byte a)
    {
        rgba = 0;
        this.r = r;
        this.g = g;
        this.b = b;
        this.a = a;
    }

    public byte this[int index]
    {
        get => index switch
        {
            0 => r,
            1 => g,
            2 => b,
            3 => a,
            _ => throw new IndexOutOfRangeException($"Invalid Color32 index({index})!")
        };
        set
        {
            switch (index)
            {
                case 0: r = value; break;
                case 1: g = value; break;
                case 2: b = value; break;
                case 3: a = value; break;
                default: throw new IndexOutOfRangeException($"Invalid Color32 index({index})!");
            }
        }
    }

    public static implicit operator Color32(Color c) => new(Byte(c.r), Byte(c.g), Byte(c.b), Byte(c.a));
    public static implicit operator Color(Color32 c) => new(c.r / 255f, c.g / 255f, c.b / 255f, c.a / 255f);
    public static Color32 Lerp(Color32 a, Color32 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Color32 LerpUnclamped(Color32 a, Color32 b, float t)
    {
        return new Color32(Mix(a.r, b.r, t), Mix(a.g, b.g, t), Mix(a.b, b.b, t), Mix(a.a, b.a, t));
    }

    public override int GetHashCode() => rgba;
    public override bool Equals(object other) => other is Color32 c && Equals(c);
    public bool Equals(Color32 other) => rgba == other.rgba;
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) =>
        "RGBA" + FloatFormat.Tuple(format, formatProvider, r, g, b, a);

    static byte Byte(float channel) => (byte)Mathf.Round(Mathf.Clamp01(channel) * 255f);
    static byte Mix(byte from, byte to, float t) => (byte)(from + (to - from) * t);
}
