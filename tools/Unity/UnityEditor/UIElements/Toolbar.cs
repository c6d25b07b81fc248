using UnityEngine.UIElements;

namespace UnityEditor.UIElements;

public class Toolbar : VisualElement
{
}

public class ToolbarMenu : TextElement
{
    public DropdownMenu menu { get; } = new();
}

public class ToolbarToggle : Toggle
{
}
