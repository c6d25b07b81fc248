namespace UnityEngine;

public struct RenderParams
{
    public RenderParams(Material mat) : this() => material = mat;

    public int layer { readonly get; set; }

    public Bounds worldBounds { readonly get; set; }

    public Camera camera { readonly get; set; }

    public Material material { readonly get; set; }
}
