using System;

namespace UnityEngine;

public enum FilterMode
{
    Point,
    Bilinear,
    Trilinear,
}

public enum TextureFormat
{
    RGB24 = 3,
    RGBA32 = 4,
}

public class Texture : Object
{
    protected Texture()
    {
    }

    public virtual int width { get; set; }

    public virtual int height { get; set; }

    public FilterMode filterMode { get; set; }
}

/// <summary>Stores colours for tests; the host does not show them.</summary>
public sealed class Texture2D : Texture
{
    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
    {
        this.width = width;
        this.height = height;
    }

    internal Color32[] Pixels { get; private set; }

    public void SetPixels(Color[] colors) => SetPixels32(Array.ConvertAll(colors, colour => (Color32)colour));

    public void SetPixels32(Color32[] colors)
    {
        if (colors.Length != width * height)
            throw new ArgumentException($"{colors.Length} colours for {width} x {height} pixels", nameof(colors));
        Pixels = colors;
    }

    public void Apply()
    {
    }
}

public static class ImageConversion
{
    public static byte[] EncodeToPNG(this Texture2D tex) =>
        throw new NotSupportedException("The host writes no PNG files.");
}
