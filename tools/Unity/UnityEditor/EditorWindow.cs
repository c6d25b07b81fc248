using System.Linq;
using Glint.Host;
using UnityEngine;
using UnityEngine.UIElements;

namespace UnityEditor;

/// <summary>A window without a display: it receives messages, and has a tree once it is shown.</summary>
public class EditorWindow : ScriptableObject
{
    bool _isShown;

    public VisualElement rootVisualElement { get; } = new();

    public GUIContent titleContent { get; set; } = new();

    public Vector2 minSize { get; set; }

    public Rect position { get; set; }

    /// <summary>The window of a type, opened if there is none.</summary>
    public static T GetWindow<T>()
        where T : EditorWindow
    {
        T window = ObjectRegistry.All().OfType<T>().FirstOrDefault() ?? CreateInstance<T>();
        window.Show();
        return window;
    }

    public void Show()
    {
        if (_isShown)
            return;
        _isShown = true;
        Messages.Call(this, "CreateGUI");
        Messages.Call(this, "OnFocus");
    }

    public void Close() => DestroyImmediate(this);
}
