namespace UnityEngine;

public enum ColorSpace
{
    Uninitialized = -1,
    Gamma = 0,
    Linear = 1,
}

public sealed class QualitySettings : Object
{
    QualitySettings()
    {
    }

    /// <summary>The host draws nothing: what is written is what a file shows. Settable for tests.</summary>
    public static ColorSpace activeColorSpace { get; internal set; } = ColorSpace.Gamma;
}
