using Glint.Host;

namespace UnityEngine;

/// <summary>Draws nothing: what it is given is listed in <see cref="ScreenText"/>.</summary>
public class GUI
{
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void Box(Rect position, string text) => ScreenText.Add(text);

    public static void DrawTexture(Rect position, Texture image) => ScreenText.Add($"texture {image.name}");

    public static void Label(Rect position, string text) => ScreenText.Add(text);
}
