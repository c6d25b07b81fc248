using System.Linq;
using Glint.Host;
using UnityEngine.SceneManagement;

namespace UnityEngine;

/// <summary>Looks along +z of its transform; in camera space, as in OpenGL, along -z.</summary>
public sealed partial class Camera : Behaviour
{
    float _fieldOfView = 60f;
    float _nearClipPlane = 0.3f;
    float _farClipPlane = 1000f;
    float _orthographicSize = 5f;
    bool _orthographic;
    int _cullingMask = -1;
    float _depth;
    Rect _rect = new(0f, 0f, 1f, 1f);
    float? _aspect;
    Matrix4x4? _projection;
    Matrix4x4? _worldToCamera;

    /// <summary>Never called by the host, which does not render.</summary>
    public static CameraCallback onPreCull;

    public delegate void CameraCallback(Camera cam);

    public CameraType cameraType { get; set; } = CameraType.Game;

    /// <summary>The only scene that it shows; without one, all scenes.</summary>
    public Scene scene { get; set; }

    public static Camera main => allCameras.FirstOrDefault(camera => camera.CompareTag("MainCamera"));

    /// <summary>The enabled cameras, by depth.</summary>
    public static Camera[] allCameras =>
        FindObjectsByType<Camera>(FindObjectsSortMode.None)
            .Where(camera => camera.enabled)
            .OrderBy(camera => camera._depth)
            .ToArray();

    public static int allCamerasCount => allCameras.Length;

    /// <summary>Vertical field of view, in degrees.</summary>
    public float fieldOfView
    {
        get => Alive()._fieldOfView;
        set => Alive()._fieldOfView = value;
    }

    public float nearClipPlane
    {
        get => Alive()._nearClipPlane;
        set => Alive()._nearClipPlane = value;
    }

    public float farClipPlane
    {
        get => Alive()._farClipPlane;
        set => Alive()._farClipPlane = value;
    }

    public bool orthographic
    {
        get => Alive()._orthographic;
        set => Alive()._orthographic = value;
    }

    /// <summary>Half the height of the view, in metres.</summary>
    public float orthographicSize
    {
        get => Alive()._orthographicSize;
        set => Alive()._orthographicSize = value;
    }

    public int cullingMask
    {
        get => Alive()._cullingMask;
        set => Alive()._cullingMask = value;
    }

    public float depth
    {
        get => Alive()._depth;
        set => Alive()._depth = value;
    }

    /// <summary>Lens and sensor are not modelled; only the field of view counts.</summary>
    public bool usePhysicalProperties => false;

    public Rect rect
    {
        get => Alive()._rect;
        set => Alive()._rect = value;
    }

    public Rect pixelRect => new(
        rect.x * Screen.width, rect.y * Screen.height, rect.width * Screen.width, rect.height * Screen.height);

    public int pixelWidth => Mathf.RoundToInt(pixelRect.width);

    public int pixelHeight => Mathf.RoundToInt(pixelRect.height);

    /// <summary>Width over height: that of the view unless set; not serialized.</summary>
    public float aspect
    {
        get => Alive()._aspect ?? pixelRect.width / pixelRect.height;
        set => Alive()._aspect = value;
    }

    public Matrix4x4 projectionMatrix
    {
        get => Alive()._projection ?? (_orthographic ? Orthographic() : Perspective());
        set => Alive()._projection = value;
    }

    public Matrix4x4 worldToCameraMatrix
    {
        get => Alive()._worldToCamera
            ?? Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Pose().inverse;
        set => Alive()._worldToCamera = value;
    }

    public Matrix4x4 cameraToWorldMatrix => worldToCameraMatrix.inverse;

    public static float HorizontalToVerticalFieldOfView(float horizontalFieldOfView, float aspectRatio) =>
        2f * Mathf.Rad2Deg * Mathf.Atan(Mathf.Tan(0.5f * Mathf.Deg2Rad * horizontalFieldOfView) / aspectRatio);

    public static float VerticalToHorizontalFieldOfView(float verticalFieldOfView, float aspectRatio) =>
        2f * Mathf.Rad2Deg * Mathf.Atan(Mathf.Tan(0.5f * Mathf.Deg2Rad * verticalFieldOfView) * aspectRatio);

    public static int GetAllCameras(Camera[] cameras)
    {
        Camera[] all = allCameras;
        all.CopyTo(cameras, 0);
        return all.Length;
    }

    public void ResetAspect() => Alive()._aspect = null;

    public void ResetProjectionMatrix() => Alive()._projection = null;

    public void ResetWorldToCameraMatrix() => Alive()._worldToCamera = null;

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        var original = (Camera)source;
        _fieldOfView = original._fieldOfView;
        _nearClipPlane = original._nearClipPlane;
        _farClipPlane = original._farClipPlane;
        _orthographicSize = original._orthographicSize;
        _orthographic = original._orthographic;
        _cullingMask = original._cullingMask;
        _depth = original._depth;
        _rect = original._rect;
    }

    Camera Alive()
    {
        EnsureAlive();
        return this;
    }

    // A camera has a position and a direction; its transform's scale does not affect the view.
    Matrix4x4 Pose() => Matrix4x4.TRS(transform.position, transform.rotation, Vector3.one);

    Matrix4x4 Perspective() => Matrix4x4.Perspective(_fieldOfView, aspect, _nearClipPlane, _farClipPlane);

    Matrix4x4 Orthographic() => Matrix4x4.Ortho(
        -_orthographicSize * aspect, _orthographicSize * aspect, -_orthographicSize, _orthographicSize,
        _nearClipPlane, _farClipPlane);
}
