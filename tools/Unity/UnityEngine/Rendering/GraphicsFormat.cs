namespace UnityEngine.Experimental.Rendering;

public enum GraphicsFormat
{
    None = 0,
    R8G8B8A8_SRGB = 4,
    R8G8B8A8_UNorm = 8,
}

[System.Flags]
public enum GraphicsFormatUsage
{
    None = 0,
    Sample = 1,
    Linear = 2,
    Render = 16,
    LoadStore = 1024,
}
