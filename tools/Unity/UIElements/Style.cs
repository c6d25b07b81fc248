using System;

namespace UnityEngine.UIElements;

public enum DisplayStyle
{
    Flex,
    None,
}

public enum FlexDirection
{
    Column,
    ColumnReverse,
    Row,
    RowReverse,
}

public interface IStyle
{
    StyleColor backgroundColor { get; set; }

    StyleColor color { get; set; }

    StyleEnum<DisplayStyle> display { get; set; }

    StyleEnum<FlexDirection> flexDirection { get; set; }

    StyleFloat flexGrow { get; set; }

    StyleLength left { get; set; }

    StyleLength minWidth { get; set; }

    StyleLength top { get; set; }

    StyleTranslate translate { get; set; }
}

internal sealed class InlineStyle : IStyle
{
    public StyleColor backgroundColor { get; set; }

    public StyleColor color { get; set; }

    public StyleEnum<DisplayStyle> display { get; set; }

    public StyleEnum<FlexDirection> flexDirection { get; set; }

    public StyleFloat flexGrow { get; set; }

    public StyleLength left { get; set; }

    public StyleLength minWidth { get; set; }

    public StyleLength top { get; set; }

    public StyleTranslate translate { get; set; }
}

public struct StyleColor
{
    public StyleColor(Color v) => value = v;

    public Color value { get; set; }

    public static implicit operator StyleColor(Color v) => new(v);
}

public struct StyleEnum<T>
    where T : struct, IConvertible
{
    public StyleEnum(T v) => value = v;

    public T value { get; set; }

    public static implicit operator StyleEnum<T>(T v) => new(v);
}

public struct StyleFloat
{
    public StyleFloat(float v) => value = v;

    public float value { get; set; }

    public static implicit operator StyleFloat(float v) => new(v);
}

public struct StyleLength
{
    public StyleLength(Length v) => value = v;

    public Length value { get; set; }

    public static implicit operator StyleLength(float v) => new(v);

    public static implicit operator StyleLength(Length v) => new(v);
}

public struct StyleTranslate
{
    public StyleTranslate(Translate v) => value = v;

    public Translate value { get; set; }

    public static implicit operator StyleTranslate(Translate v) => new(v);
}

public struct Translate
{
    public Translate(Length x, Length y) => (this.x, this.y) = (x, y);

    public Length x { get; set; }

    public Length y { get; set; }
}

public enum LengthUnit
{
    Pixel,
    Percent,
}

public struct Length
{
    public Length(float value)
        : this(value, LengthUnit.Pixel)
    {
    }

    public Length(float value, LengthUnit unit) => (this.value, this.unit) = (value, unit);

    public float value { get; set; }

    public LengthUnit unit { get; set; }

    public static implicit operator Length(float value) => new(value);

    public static Length Percent(float value) => new(value, LengthUnit.Percent);
}

public enum AngleUnit
{
    Degree,
    Gradian,
    Radian,
    Turn,
}

public struct Angle
{
    public Angle(float value, AngleUnit unit) => (this.value, this.unit) = (value, unit);

    public float value { get; set; }

    public AngleUnit unit { get; set; }

    public static Angle Degrees(float value) => new(value, AngleUnit.Degree);
}
