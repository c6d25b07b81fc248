namespace UnityEngine;

/// <summary>
/// Conversions between the world, the viewport (0 to 1 from the lower left corner) and the screen (pixels); z is metres
/// in front of the camera.
/// </summary>
public sealed partial class Camera
{
    public Vector3 WorldToViewportPoint(Vector3 position)
    {
        Vector3 inCamera = worldToCameraMatrix.MultiplyPoint3x4(position);
        Vector3 clip = projectionMatrix.MultiplyPoint(inCamera);
        return new Vector3(0.5f + 0.5f * clip.x, 0.5f + 0.5f * clip.y, -inCamera.z);
    }

    public Vector3 ViewportToWorldPoint(Vector3 position)
    {
        Matrix4x4 projection = projectionMatrix;
        float clipX = 2f * position.x - 1f, clipY = 2f * position.y - 1f;
        float w = projection.m32 * -position.z + projection.m33;
        var inCamera = new Vector3(
            (clipX * w - projection.m02 * -position.z - projection.m03) / projection.m00,
            (clipY * w - projection.m12 * -position.z - projection.m13) / projection.m11,
            -position.z);
        return cameraToWorldMatrix.MultiplyPoint3x4(inCamera);
    }

    public Vector3 WorldToScreenPoint(Vector3 position) => ViewportToScreenPoint(WorldToViewportPoint(position));

    public Vector3 ScreenToWorldPoint(Vector3 position) => ViewportToWorldPoint(ScreenToViewportPoint(position));

    public Vector3 ScreenToViewportPoint(Vector3 position)
    {
        Rect pixels = pixelRect;
        return new Vector3(
            (position.x - pixels.x) / pixels.width, (position.y - pixels.y) / pixels.height, position.z);
    }

    public Vector3 ViewportToScreenPoint(Vector3 position)
    {
        Rect pixels = pixelRect;
        return new Vector3(
            pixels.x + position.x * pixels.width, pixels.y + position.y * pixels.height, position.z);
    }

    /// <summary>Starts on the near plane.</summary>
    public Ray ViewportPointToRay(Vector3 pos)
    {
        Vector3 origin = ViewportToWorldPoint(new Vector3(pos.x, pos.y, nearClipPlane));
        Matrix4x4 toWorld = cameraToWorldMatrix;
        Vector3 direction = orthographic
            ? toWorld.MultiplyVector(new Vector3(0f, 0f, -1f))
            : origin - toWorld.MultiplyPoint3x4(Vector3.zero);
        return new Ray(origin, direction);
    }

    public Ray ScreenPointToRay(Vector3 pos) => ViewportPointToRay(ScreenToViewportPoint(pos));
}
