namespace UnityEngine;

public enum ScaleMode
{
    StretchToFill,
    ScaleAndCrop,
    ScaleToFit,
}

public class GUIContent
{
    public GUIContent()
    {
    }

    public GUIContent(string text) => this.text = text;

    public string text { get; set; } = "";
}

public class GUIUtility
{
}
