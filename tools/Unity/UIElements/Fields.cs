using System;
using System.Collections.Generic;

namespace UnityEngine.UIElements;

public interface INotifyValueChanged<T>
{
    T value { get; set; }

    void SetValueWithoutNotify(T newValue);
}

public static class INotifyValueChangedExtensions
{
    public static bool RegisterValueChangedCallback<T>(
        this INotifyValueChanged<T> control, EventCallback<ChangeEvent<T>> callback)
    {
        ((CallbackEventHandler)control).RegisterCallback(callback);
        return true;
    }

    /// <summary>Sets a control's value and notifies of a change.</summary>
    internal static void Set<T>(this INotifyValueChanged<T> control, ref T value, T newValue)
    {
        T previous = value;
        if (EqualityComparer<T>.Default.Equals(previous, newValue))
            return;
        value = newValue;
        ((CallbackEventHandler)control).Raise(new ChangeEvent<T> { previousValue = previous, newValue = newValue });
    }
}

public abstract class BaseField<TValueType> : BindableElement, INotifyValueChanged<TValueType>
{
    public static readonly string alignedFieldUssClassName = "unity-base-field__aligned";

    TValueType _value;

    internal BaseField(string label) => this.label = label;

    public string label { get => labelElement.text; set => labelElement.text = value; }

    public Label labelElement { get; } = new();

    public virtual TValueType value { get => _value; set => this.Set(ref _value, value); }

    public virtual void SetValueWithoutNotify(TValueType newValue) => _value = newValue;
}

public abstract class BaseBoolField : BaseField<bool>
{
    public BaseBoolField(string label)
        : base(label)
    {
    }

    public string text { get; set; } = "";
}

public class Toggle : BaseBoolField
{
    public Toggle()
        : this(null)
    {
    }

    public Toggle(string label)
        : base(label)
    {
    }
}

public abstract class TextInputBaseField<TValueType> : BaseField<TValueType>
{
    internal TextInputBaseField(string label)
        : base(label)
    {
    }

    public bool isReadOnly { get; set; }
}

public class TextField : TextInputBaseField<string>
{
    public TextField(string label)
        : base(label)
    {
    }
}

public abstract class BasePopupField<TValueType, TValueChoice> : BaseField<TValueType>
{
    internal BasePopupField(string label)
        : base(label)
    {
    }

    public virtual List<TValueChoice> choices { get; set; } = new();
}

public class PopupField<T> : BasePopupField<T, T>
{
    public PopupField(string label = null)
        : base(label)
    {
    }

    public int index { get => choices.IndexOf(value); set => this.value = choices[value]; }
}

public class DropdownField : PopupField<string>
{
    public DropdownField(string label)
        : base(label)
    {
    }

    public DropdownField(
        string label, List<string> choices, int defaultIndex,
        Func<string, string> formatSelectedValueCallback = null, Func<string, string> formatListItemCallback = null)
        : base(label)
    {
        this.choices = choices;
        SetValueWithoutNotify(choices[defaultIndex]);
    }
}
