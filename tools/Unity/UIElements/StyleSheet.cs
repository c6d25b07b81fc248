namespace UnityEngine.UIElements;

/// <summary>Style sheets are not loaded by the host.</summary>
public class StyleSheet : ScriptableObject
{
}

public struct VisualElementStyleSheetSet
{
    readonly VisualElement _element;

    internal VisualElementStyleSheetSet(VisualElement element) => _element = element;

    public int count => _element.Sheets.Count;

    public void Add(StyleSheet styleSheet) => _element.Sheets.Add(styleSheet);
}
