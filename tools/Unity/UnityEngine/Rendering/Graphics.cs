namespace UnityEngine;

/// <summary>The host has no screen: drawing calls are recorded for tests.</summary>
public class Graphics
{
    internal static (RenderParams Parameters, Mesh Mesh, Matrix4x4 Place)? LastDrawn { get; private set; }

    public static void RenderMesh(in RenderParams rparams, Mesh mesh, int submeshIndex, Matrix4x4 objectToWorld,
        Matrix4x4? prevObjectToWorld = null) =>
        LastDrawn = (rparams, mesh, objectToWorld);
}
