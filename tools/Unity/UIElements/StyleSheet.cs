namespace UnityEngine.UIElements;

/// <summary>Style sheets are not read: no asset of the project is one here.</summary>
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
