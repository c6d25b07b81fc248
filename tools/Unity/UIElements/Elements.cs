using System;

namespace UnityEngine.UIElements;

public class BindableElement : VisualElement
{
    public string bindingPath { get; set; }
}

public class TextElement : BindableElement
{
    public virtual string text { get; set; } = "";
}

public class Label : TextElement
{
    public Label()
    {
    }

    public Label(string text) => this.text = text;
}

public class Button : TextElement
{
    public Button(Action clickEvent) => clicked += clickEvent;

    public event Action clicked;

    internal void Click() => clicked?.Invoke();
}

public class Foldout : BindableElement, INotifyValueChanged<bool>
{
    bool _value = true;

    public string text { get; set; } = "";

    public bool value { get => _value; set => this.Set(ref _value, value); }

    public void SetValueWithoutNotify(bool newValue) => _value = newValue;
}

public enum HelpBoxMessageType
{
    None,
    Info,
    Warning,
    Error,
}

public class HelpBox : VisualElement
{
    public HelpBox(string text, HelpBoxMessageType messageType) => (this.text, this.messageType) = (text, messageType);

    public string text { get; set; }

    public HelpBoxMessageType messageType { get; set; }
}

public class ScrollView : VisualElement
{
}

public abstract class AbstractProgressBar : BindableElement, INotifyValueChanged<float>
{
    float _value;

    public string title { get; set; } = "";

    public float lowValue { get; set; }

    public float highValue { get; set; } = 100;

    public virtual float value { get => _value; set => this.Set(ref _value, value); }

    public void SetValueWithoutNotify(float newValue) => _value = newValue;
}

public class ProgressBar : AbstractProgressBar
{
}

public enum TwoPaneSplitViewOrientation
{
    Horizontal,
    Vertical,
}

public class TwoPaneSplitView : VisualElement
{
    public TwoPaneSplitView(int fixedPaneIndex, float fixedPaneStartDimension, TwoPaneSplitViewOrientation orientation)
    {
    }
}

public class Image : VisualElement
{
    public Texture image { get; set; }

    public ScaleMode scaleMode { get; set; }
}
