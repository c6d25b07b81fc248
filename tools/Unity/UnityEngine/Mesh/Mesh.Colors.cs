using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Color[] colors
    {
        get => Read("colors", Contents.Colors);
        set => SetColors(value);
    }

    public Color32[] colors32
    {
        get => Array.ConvertAll(colors, color => (Color32)color);
        set => SetColors(value);
    }

    public void GetColors(List<Color> colors) => Read("colors", Contents.Colors, colors);
    public void GetColors(List<Color32> colors) =>
        Read("colors", Array.ConvertAll(Contents.Colors, color => (Color32)color), colors);
    public void SetColors(List<Color> inColors) => StoreColors(CollectionsMarshal.AsSpan(inColors));
    public void SetColors(List<Color> inColors, int start, int length) =>
        StoreColors(CollectionsMarshal.AsSpan(inColors).Slice(start, length));
    public void SetColors(Color[] inColors) => StoreColors(inColors);
    public void SetColors(Color[] inColors, int start, int length) => StoreColors(inColors.AsSpan(start, length));
    public void SetColors(List<Color32> inColors) => SetColors(inColors?.ToArray());
    public void SetColors(Color32[] inColors) =>
        StoreColors(Array.ConvertAll(inColors ?? Array.Empty<Color32>(), color => (Color)color));

    void StoreColors(ReadOnlySpan<Color> values) => Contents.Colors = Channel("colors", Contents.Colors, values);
}
