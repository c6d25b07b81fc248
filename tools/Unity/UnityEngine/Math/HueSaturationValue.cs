using UnityEngine;

namespace Glint.Host;

/// <summary>Hue, saturation and value, each 0 to 1, to and from red, green and blue.</summary>
internal static class HueSaturationValue
{
    internal static void FromColor(Color color, out float hue, out float saturation, out float value)
    {
        value = color.maxColorComponent;
        float spread = value - Mathf.Min(Mathf.Min(color.r, color.g), color.b);
        hue = 0f;
        saturation = value == 0f ? 0f : spread / value;
        if (spread == 0f)
            return;
        if (color.r == value)
            hue = (color.g - color.b) / spread;
        else if (color.g == value)
            hue = 2f + (color.b - color.r) / spread;
        else
            hue = 4f + (color.r - color.g) / spread;
        hue = hue < 0f ? hue / 6f + 1f : hue / 6f;
    }

    internal static Color ToColor(float hue, float saturation, float value, bool hdr)
    {
        var color = new Color(Channel(5f), Channel(3f), Channel(1f));
        return hdr ? color : new Color(Mathf.Clamp01(color.r), Mathf.Clamp01(color.g), Mathf.Clamp01(color.b));

        // Each channel is a trapezium over the hue, shifted by a third of the circle against the others.
        float Channel(float shift)
        {
            float k = Mathf.Repeat(shift + hue * 6f, 6f);
            return value - value * saturation * Mathf.Clamp01(Mathf.Min(k, 4f - k));
        }
    }
}
