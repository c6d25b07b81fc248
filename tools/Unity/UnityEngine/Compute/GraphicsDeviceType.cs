namespace UnityEngine.Rendering;

public enum GraphicsDeviceType
{
    Direct3D11 = 2,
    Null = 4,
    OpenGLES3 = 11,
    Metal = 16,
    OpenGLCore = 17,
    Direct3D12 = 18,
    Vulkan = 21,
}
